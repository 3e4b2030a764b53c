// What a program may use of the shared library: everything else is hidden in it. In the static library the marks are
// without effect.
#pragma once

#if defined(_WIN32)
#define TREAD_API
#define TREAD_INTERNAL
#else
#define TREAD_API __attribute__((visibility("default")))
#define TREAD_INTERNAL __attribute__((visibility("hidden")))  // a part of an API class that is not the API
#endif
