// Logarithm and powers with the same bits on every machine (elementary.h says why), for what is computed once or
// seldom: within 1 unit in the last place, and with the special values of the C library.
#pragma once

namespace tread {

double logarithm(double x);

double power(double base, double exponent);

}  // namespace tread
