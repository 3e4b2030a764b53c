#include "recording/subject_paths.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "base/text/number_text.h"
#include "base/text/pattern.h"
#include "recording/subject.h"

namespace tread::recording {
namespace {

// Rows that are numbers: they have a unit and are neither a list nor a curve, whose default is empty.
const std::map<std::string, ReferenceRow, std::less<>>& rows() {
    static const auto all = [] {
        std::map<std::string, ReferenceRow, std::less<>> numbers;
        for (const ReferenceRow& row : referenceTable<Subject>()) {
            const bool number = !row.unit.empty() && row.limits != "a list" && row.default_text != "empty";
            if (number) numbers.emplace(row.path, row);
        }
        return numbers;
    }();
    return all;
}

// "gears.3" as "gears.0" and "instruments.mountings.can.x" as "instruments.mountings.0.x", the entries that describe
// all elements.
std::string firstOfList(std::string_view path) {
    std::string out;
    for (const std::string_view list : {"instruments.further.", "instruments.mountings."}) {
        const std::size_t number = path.rfind('.') + 1;
        if (path.starts_with(list) && number > list.size())
            return std::string(list) + "0." + std::string(path.substr(number));
    }
    while (!path.empty()) {
        const std::string_view name = takeName(path);
        const bool index = std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); });
        out = joinPath(out, index ? "0" : name);
    }
    return out;
}

}  // namespace

const ReferenceRow* subjectNumber(std::string_view path) {
    const auto found = rows().find(firstOfList(path));
    return found == rows().end() ? nullptr : &found->second;
}

bool isOfTheCar(std::string_view path) {
    return !path.starts_with("road.") && !path.starts_with("wind.") && !path.starts_with("instruments.");
}

std::string pathFault(std::string_view path) {
    const bool pattern = path.find('*') != std::string_view::npos;
    const auto fits = [&](const auto& row) { return matches(path, row.first); };
    if (pattern ? std::any_of(rows().begin(), rows().end(), fits) : subjectNumber(path) != nullptr) return {};
    std::vector<std::string_view> known;
    for (const auto& [name, row] : rows()) known.push_back(name);
    const std::string suggestion = didYouMean(path, known);
    return "found " + quote(path) + ", expected the path of a number of car, road, wind or instruments" +
           (suggestion.empty() ? ";" : suggestion) +
           " `tread describe vehicle` and `tread describe diagnosis` list them";
}

}  // namespace tread::recording
