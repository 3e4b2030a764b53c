#include "blind/key.h"

#include <nlohmann/json.hpp>

#include "blind/enum_named.h"
#include "tread/problem.h"

namespace tread {
namespace {

using Json = nlohmann::json;

Json jsonOf(const CaseKey& one) {
    Json numbers = Json::object();
    for (const auto& [path, number] : one.numbers) {
        numbers[path] = {{"nominal", number.nominal}, {"value", number.value}, {"change", number.change}};
    }
    return {{"name", one.name},
            {"kind", enumNames(one.kind)[static_cast<std::size_t>(one.kind)]},
            {"draw", one.draw},
            {"effects", one.effects},
            {"outsider", one.outsider},
            {"numbers", numbers},
            {"generalised_forces", one.generalised_forces}};
}

CaseKey caseOf(const Json& json) {
    CaseKey one{.name = json.at("name"),
                .kind = caseKind(json.at("kind").get<std::string>()),
                .draw = json.at("draw"),
                .effects = json.at("effects"),
                .outsider = json.at("outsider"),
                .generalised_forces = json.at("generalised_forces"),
                .numbers = {}};
    for (const auto& [path, number] : json.at("numbers").items()) {
        one.numbers[path] = {number.at("nominal"), number.at("value"), number.at("change")};
    }
    return one;
}

}  // namespace

CaseKind caseKind(std::string_view name) {
    return enumNamed<CaseKind>(name, "the kind of case");
}

std::string keyText(const BlindKey& key) {
    Json cases = Json::array();
    for (const CaseKey& one : key.cases) cases.push_back(jsonOf(one));
    const Json json{{"tread_version", key.tread_version},
                    {"seed", key.seed},
                    {"vehicle", key.vehicle},
                    {"generator", key.generator},
                    {"drives", enumNames(key.drives)[static_cast<std::size_t>(key.drives)]},
                    {"cases", cases}};
    return json.dump(2) + "\n";
}

BlindKey parseKey(std::string_view text, const std::string& file) {
    try {
        const Json json = Json::parse(text);
        BlindKey key{.tread_version = json.at("tread_version"),
                     .seed = json.at("seed"),
                     .vehicle = json.at("vehicle"),
                     .generator = json.value("generator", ""),
                     .drives = driveSet(json.value("drives", "all")),
                     .cases = {}};
        for (const Json& one : json.at("cases")) key.cases.push_back(caseOf(one));
        return key;
    } catch (const Json::exception& error) {
        throw LoadError({{file, 0, 0, "",
                          "found no key of a blind check, expected one that `tread blind make` wrote: " +
                              std::string(error.what())}});
    }
}

}  // namespace tread
