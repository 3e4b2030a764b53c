// Height fields as CSV text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tread/height_field.h"

namespace tread {

// The field of a text in the format of readForeign(HeightField&, ...); `file` names it in the faults.
void parseHeightField(HeightField& field, std::string_view text, const std::string& file,
                      std::vector<Problem>& problems);

}  // namespace tread
