#include "blind/key/key.h"

#include "base/text/enum_named.h"
#include "store/described_json.h"
#include "tread/problem.h"

namespace tread::blind::key {

CaseKind caseKindNamed(std::string_view name) {
    return enumNamed<CaseKind>(name, "the kind of case");
}

std::string keyText(const SealedKey& key) {
    return jsonOf(key).dump(2) + "\n";
}

SealedKey parseKey(std::string_view text, const std::string& file) {
    try {
        SealedKey key;
        readJson(key, nlohmann::ordered_json::parse(text));
        return key;
    } catch (const std::exception& error) {
        throw LoadError({{file, 0, 0, "",
                          "found no key of a blind check, expected one that `tread blind make` wrote: " +
                              std::string(error.what())}});
    }
}

}  // namespace tread::blind::key
