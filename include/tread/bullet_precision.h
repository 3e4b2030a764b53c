// The precision of Bullet's numbers is part of each name that has to do with Bullet: a program that mixes the two does
// not link, and the linker names the precision that is missing. The CMake targets and pkg-config packages say for which
// precision they are (TREAD_BULLET_FLOAT64, TREAD_BULLET_FLOAT32), so that the compiler refuses before that.
#pragma once

#include "tread/api.h"

#if defined(TREAD_BULLET_FLOAT64) && defined(TREAD_BULLET_FLOAT32)
#error "This links tread::tread and tread::tread_float: link the one for the precision of your Bullet alone."
#elif defined(TREAD_BULLET_FLOAT64) && !defined(BT_USE_DOUBLE_PRECISION)
#error "Bullet is in single precision here: link tread::tread_float (pkg-config tread-float), not tread::tread."
#elif defined(TREAD_BULLET_FLOAT32) && defined(BT_USE_DOUBLE_PRECISION)
#error "Bullet is in double precision here: link tread::tread (pkg-config tread), not tread::tread_float."
#endif

#ifdef BT_USE_DOUBLE_PRECISION
#define TREAD_BULLET_PRECISION bullet_float64
#else
#define TREAD_BULLET_PRECISION bullet_float32
#endif

#ifdef TREAD_IN_LIBRARY
// Each part of the library that has to do with Bullet ends a program at its start that runs with the other Bullet.
namespace tread {
inline namespace TREAD_BULLET_PRECISION {
bool requireSameBullet();
inline const bool kSameBullet = requireSameBullet();
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
#endif
