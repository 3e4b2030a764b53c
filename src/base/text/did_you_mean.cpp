#include "base/text/did_you_mean.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tread {
namespace {

constexpr std::size_t kLongestWord = 100;  // nobody mistypes more; keeps the search cheap for hostile files
constexpr std::size_t kStep = 2;           // cost of one edit; a wrong case costs half of it

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::size_t substitution(char a, char b) {
    if (a == b) return 0;
    return lower(a) == lower(b) ? kStep / 2 : kStep;
}

// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j * kStep;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i * kStep;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + kStep, row[j - 1] + kStep, last[j - 1] + substitution(a[i - 1], b[j - 1])});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + kStep);
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

}  // namespace

std::optional<std::string_view> closest(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.size() > kLongestWord) return {};
    // One edit in three letters; a word of one or two letters only in another case.
    std::size_t best =
        word.size() < 3 ? word.size() * kStep / 2 + 1 : std::max<std::size_t>(word.size() / 3, 1) * kStep + 1;
    std::optional<std::string_view> found;
    for (const std::string_view candidate : candidates) {
        const std::size_t longer = std::max(word.size(), candidate.size());
        const std::size_t shorter = std::min(word.size(), candidate.size());
        if ((longer - shorter) * kStep >= best) continue;
        const std::size_t cost = distance(word, candidate);
        if (cost < best) {
            best = cost;
            found = candidate;
        }
    }
    return found;
}

std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates) {
    const auto candidate = closest(word, candidates);
    return candidate ? "; did you mean \"" + std::string(*candidate) + "\"?" : std::string();
}

std::string listed(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

}  // namespace tread
