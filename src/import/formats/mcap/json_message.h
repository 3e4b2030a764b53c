// Messages in JSON: every number and truth value in objects and arrays is a value of its path.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "import/formats/mcap/topic_table.h"

namespace tread {

// Adds the numbers of a message to the open row of `table`; false when the bytes are no JSON object.
bool readJsonMessage(std::string_view bytes, TopicTable& table);

// A number or a truth value of the outermost object, as a JSON schema describes it.
struct JsonProperty {
    std::string name, title, description;
};
std::vector<JsonProperty> jsonProperties(std::string_view schema);

}  // namespace tread
