// The precision of Bullet's numbers is part of each name that has to do with Bullet: a program that mixes the two does
// not link, and the linker names the precision that is missing.
#pragma once

#ifdef BT_USE_DOUBLE_PRECISION
#define TREAD_BULLET_PRECISION bullet_float64
#else
#define TREAD_BULLET_PRECISION bullet_float32
#endif
