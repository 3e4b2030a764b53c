// What the shared library exports.
#pragma once

#if defined(_WIN32)
#define TREAD_API
#else
#define TREAD_API __attribute__((visibility("default")))
#endif
