// What a program may use of the shared library: everything else is hidden in it. In the static library the marks are
// without effect.
#pragma once

#if defined(__GNUC__)
#define TREAD_API __attribute__((visibility("default")))
#define TREAD_INTERNAL __attribute__((visibility("hidden")))  // a part of an API class that is not the API
#else
#define TREAD_API
#define TREAD_INTERNAL
#endif
