// The curves of a tyre: `tread tyre --plot`.
#pragma once

#include <string>
#include <vector>

#include "report/svg.h"
#include "tread/tyre.h"
#include "tyre_axes.h"

namespace tread::program {

inline constexpr double kCurveSpeed = 20;  // m/s; steady-state curves do not depend on it

// A tyre seen in one of the axis systems.
struct TyreView {
    const TyreParams& tyre;
    Axes axes;

    double sign(std::string_view column) const { return axisSign(column, axes); }
};

std::vector<Chart> pureSlipFigures(const TyreView& view);
std::vector<Chart> combinedSlipFigures(const TyreView& view);
std::vector<Chart> aligningTorqueFigures(const TyreView& view);
std::vector<Chart> loadFigures(const TyreView& view);
std::vector<Chart> camberFigures(const TyreView& view);
std::vector<Chart> stepResponseFigures(const TyreView& view);

// A self-contained HTML page with all of them; `charts` receives their number.
std::string tyrePage(const TyreView& view, std::size_t& charts);

}  // namespace tread::program
