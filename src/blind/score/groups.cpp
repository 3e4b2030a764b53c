#include "blind/score/groups.h"

#include "blind/score/bands.h"

namespace tread::blind::score {
namespace {

using key::CaseKey;
using key::CaseKind;
using key::Family;

using Names = std::vector<std::string>;

template <class Enum>
std::vector<std::string> namesWith(const std::string& before, Enum choice, const std::string& after) {
    std::vector<std::string> names;
    for (const std::string_view name : enumNames(choice)) names.push_back(before + std::string(name) + after);
    return names;
}

void addBands(std::vector<CaseGroup>& all) {
    for (std::size_t i = 0; i < kBands.size(); ++i) {
        const Band band = kBands[i];
        const std::string words = std::string(nameOf(band)) + " nats";
        all.push_back({weakerBandGroups()[i], words, [band](const CaseKey& key, const Names& about) {
                           return !about.empty() && bandOf(weakest(key, about)) == band;
                       }});
        all.push_back(
            {strongerBandGroups()[i], words + ", the stronger of two", [band](const CaseKey& key, const Names& about) {
                 return about.size() > 1 && bandOf(strongest(key, about)) == band;
             }});
    }
}

void addTestable(std::vector<CaseGroup>& all) {
    const auto testable = [](const CaseKey& key, const Names& about) {
        return !about.empty() && weakest(key, about) >= kTestable;
    };
    const auto apart = [testable](const CaseKey& key, const Names& about) {
        return testable(key, about) && toldApart(key, about);
    };
    const auto alike = [testable](const CaseKey& key, const Names& about) {
        return testable(key, about) && !toldApart(key, about);
    };
    const auto one = [](const CaseKey& key, const Names& about) {
        return !about.empty() && strongest(key, about) >= kTestable;
    };
    all.push_back({kTestableAndApart, "22 nats and more, distinguishable", apart});
    all.push_back({kTestableAlike, "22 nats and more, resembles another", alike});
    all.push_back({kOneTestable, "22 nats and more of one at least", one});
}

void addFamiliesAndKinds(std::vector<CaseGroup>& all) {
    for (std::size_t i = 0; i < familyGroups().size(); ++i) {
        all.push_back(
            {familyGroups()[i], std::string(enumNames(Family{})[i]) + " family", [i](const CaseKey& key, const Names&) {
                 return !key.outsider.empty() && key.family == static_cast<Family>(i);
             }});
    }
    for (std::size_t i = 0; i < kindGroups().size(); ++i) {
        all.push_back({kindGroups()[i], std::string(enumNames(CaseKind{})[i]),
                       [i](const CaseKey& key, const Names&) { return key.kind == static_cast<CaseKind>(i); }});
    }
}

}  // namespace

const std::vector<CaseGroup>& caseGroups() {
    static const std::vector<CaseGroup> kGroups = [] {
        std::vector<CaseGroup> all;
        addBands(all);
        addTestable(all);
        addFamiliesAndKinds(all);
        return all;
    }();
    return kGroups;
}

std::vector<std::string> weakerBandGroups() {
    return {"band_0", "band_1", "band_2", "band_3"};
}

std::vector<std::string> strongerBandGroups() {
    return {"stronger_band_0", "stronger_band_1", "stronger_band_2", "stronger_band_3"};
}

std::vector<std::string> familyGroups() {
    return namesWith("", Family{}, "_family");
}

std::vector<std::string> kindGroups() {
    return namesWith("kind_", CaseKind{}, "");
}

}  // namespace tread::blind::score
