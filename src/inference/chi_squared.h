// The chi-squared distribution.
#pragma once

namespace tread::inference {

// P(X > x), from the regularised incomplete gamma function: series below a + 1, continued fraction above (W. J. Lentz,
// 1976; Press et al., Numerical Recipes, 3rd ed., 6.2).
double chiSquaredTail(double x, double degrees_of_freedom);

}  // namespace tread::inference
