#include <fmt/format.h>

#include <algorithm>

#include "diagnose/answer/precheck.h"
#include "diagnose/settings.h"

namespace tread::diagnose::answer {
namespace {

constexpr std::size_t kMostPairs = 12, kWidth = 116, kIndent = 10;  // pairs listed; characters

// A headline followed by words, wrapped, with the lines below indented.
std::string paragraph(const char* headline, const std::vector<std::string>& words) {
    std::string text, line = fmt::format("{:<{}}", headline, kIndent);
    for (const std::string& word : words) {
        if (line.size() + word.size() > kWidth && line.size() > kIndent) {
            text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
            line = std::string(kIndent, ' ');
        }
        line += word + " ";
    }
    return text + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

// "CAN FIND  grip 340, mass 120"; empty for an empty group.
std::string groupText(const char* headline, const std::string& meaning, const Visibility::Group& group) {
    if (group.empty()) return {};
    std::vector<std::string> words{meaning};
    for (std::size_t i = 0; i < group.size(); ++i)
        words.push_back(fmt::format("{} {:.{}f}{}", group[i].first, group[i].second, group[i].second < 10 ? 1 : 0,
                                    i + 1 < group.size() ? "," : ""));
    return paragraph(headline, words);
}

std::string pairsText(const std::vector<ConfusablePair>& pairs) {
    std::string text;
    for (std::size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i) {
        text += fmt::format("{:<{}}{} and {} (similarity {:.2f}): separated by {:.1f} nats, mostly in {}\n",
                            i == 0 ? "ALIKE" : "", kIndent, pairs[i].a, pairs[i].b, pairs[i].cosine,
                            pairs[i].separation, pairs[i].manoeuvre);
    }
    return text;
}

}  // namespace

Visibility visibility(const std::map<std::string, double>& expected_evidence) {
    Visibility groups;
    for (const auto& one : expected_evidence) {
        if (one.second >= kTestable) groups.found.push_back(one);
        else (one.second >= kSettings.clear ? groups.perhaps : groups.hidden).push_back(one);
    }
    for (Visibility::Group* group : {&groups.found, &groups.perhaps, &groups.hidden})
        std::stable_sort(group->begin(), group->end(),
                         [](const auto& a, const auto& b) { return a.second > b.second; });
    return groups;
}

std::string precheckText(const Precheck& precheck) {
    const Visibility groups = visibility(precheck.expected_evidence);
    std::string text = groupText("CAN FIND", "expected evidence at typical size, in nats:", groups.found);
    text += groupText("MAY SHOW", fmt::format("only if larger than typical ({:.0f} nats or more):", kSettings.clear),
                      groups.perhaps);
    text += groupText("NOT SEEN", "excited too weakly in these drives:", groups.hidden);
    return text + pairsText(precheck.confusable);
}

}  // namespace tread::diagnose::answer
