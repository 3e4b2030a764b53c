// A page of static figures, for example the curves of a tyre.
#pragma once

#include <string>
#include <vector>

#include "report/svg.h"

namespace tread {

struct FigureGroup {
    std::string title;
    std::string text;
    std::vector<Chart> charts;
};

std::string figurePage(const std::string& title, const std::string& intro, const std::vector<FigureGroup>& groups);

}  // namespace tread
