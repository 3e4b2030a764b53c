// Fewer points for a chart without losing what an engineer looks for: every peak stays.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tread {

// The samples to draw when several curves share one time base: first and last, and per bucket the smallest and the
// largest sample of every curve, and one of each gap (values that are not finite). All samples when there are at most
// `most`; otherwise about `most`, more only where there are gaps or hardly more samples allowed than curves. Ascending.
std::vector<std::size_t> keepExtremes(std::span<const std::span<const double>> curves, std::size_t most);

}  // namespace tread
