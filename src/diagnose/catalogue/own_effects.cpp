#include <algorithm>

#include "base/text/number_text.h"
#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject_paths.h"

namespace tread::diagnose::catalogue {

std::vector<Effect> loadOwnEffects(const std::filesystem::path& file) {
    OwnEffects own = readYaml<OwnEffects>(file);
    std::vector<Problem> problems;
    const auto complain = [&](const std::string& path, std::string text) {
        const TextPosition position = positionOfValue(file.string(), path);
        problems.push_back({file.string(), position.line, position.column, path, std::move(text)});
    };
    std::vector<std::string> taken;
    for (const Effect& known : effectCatalogue()) taken.push_back(known.name);
    for (std::size_t i = 0; i < own.catalogue.size(); ++i) {
        const Effect& effect = own.catalogue[i];
        const std::string at = "catalogue." + std::to_string(i);
        if (std::find(taken.begin(), taken.end(), effect.name) != taken.end())
            complain(at + ".name", "found " + quote(effect.name) +
                                       ", the name of another effect; expected a name that is not yet taken");
        taken.push_back(effect.name);
        for (std::size_t k = 0; k < effect.knobs.size(); ++k) {
            const auto& paths = effect.knobs[k].paths;
            for (std::size_t p = 0; p < paths.size(); ++p) {
                const std::string where = at + ".knobs." + std::to_string(k) + ".paths." + std::to_string(p);
                if (std::string fault = recording::pathFault(paths[p]); !fault.empty())
                    complain(where, std::move(fault));
            }
        }
    }
    if (!problems.empty()) throw LoadError(std::move(problems));
    return std::move(own.catalogue);
}

}  // namespace tread::diagnose::catalogue
