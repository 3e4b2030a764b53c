#include "blind/score/figures.h"

#include "blind/score/groups.h"
#include "blind/score/questions.h"

namespace tread::blind::score {
namespace {

using answers::CaseAnswer;
using key::CaseKey;

void count(Figure& figure, const FigureQuestion& question, const CaseKey& key, const CaseAnswer& answer) {
    for (const bool hit : question.hits(key, answer)) figure.add(hit);
    if (!question.simpler) return;
    const auto& [largest_reduction, bic] = answer.baselines;
    if (!largest_reduction.empty()) figure.largest_reduction.add(question.simpler(key, largest_reduction));
    if (!bic.empty()) figure.bic.add(question.simpler(key, bic));
}

}  // namespace

std::vector<Figure> countFigures(const std::vector<CaseKey>& keys, const std::vector<CaseAnswer>& answers) {
    std::vector<Figure> figures;
    const auto add = [&](const std::string& group, const auto& holds) {
        for (const FigureQuestion& question : figureQuestions()) {
            Figure figure;
            figure.name = question.name;
            figure.words = question.words;
            figure.group = group;
            figure.at_least = question.at_least;
            if (group == question.target_group) figure.target = question.target;
            for (std::size_t i = 0; i < keys.size(); ++i) {
                if (question.asked(keys[i]) && holds(keys[i], question.about(keys[i])))
                    count(figure, question, keys[i], answers[i]);
            }
            figures.push_back(std::move(figure));
        }
    };
    add("", [](const CaseKey&, const std::vector<std::string>&) { return true; });
    for (const CaseGroup& one : caseGroups()) add(one.name, one.holds);
    return figures;
}

}  // namespace tread::blind::score
