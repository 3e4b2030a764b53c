#include "blind/key.h"

#include "blind/enum_named.h"
#include "store/described_json.h"
#include "tread/problem.h"

namespace tread {

CaseKind caseKind(std::string_view name) {
    return enumNamed<CaseKind>(name, "the kind of case");
}

World world(std::string_view name) {
    return enumNamed<World>(name, "the world");
}

std::string keyText(const BlindKey& key) {
    return jsonOf(key).dump(2) + "\n";
}

BlindKey parseKey(std::string_view text, const std::string& file) {
    try {
        BlindKey key;
        readJson(key, nlohmann::ordered_json::parse(text));
        return key;
    } catch (const std::exception& error) {
        throw LoadError({{file, 0, 0, "",
                          "found no key of a blind check, expected one that `tread blind make` wrote: " +
                              std::string(error.what())}});
    }
}

}  // namespace tread
