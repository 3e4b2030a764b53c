#include "scenario/expression/parse.h"

#include <array>
#include <cctype>
#include <utility>

#include "base/text/concat.h"
#include "base/text/number_text.h"

namespace tread {
namespace {

constexpr int kDeepest = 64;            // parentheses within each other; bounds the recursion
constexpr std::size_t kLongest = 4000;  // characters

bool isLetter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

class Parser {
public:
    Parser(std::string_view text, ExpressionFault& fault) : text_(text), fault_(fault) {}

    std::optional<Term> all() {
        if (text_.size() > kLongest) return fail(0, "found an expression of more than 4000 characters; shorten it");
        auto term = either();
        skipBlanks();
        if (term && at_ < text_.size()) {
            return fail(at_, concat({"found ", quote(text_.substr(at_), 20),
                                     " after a complete expression, expected +, -, *, /, a comparison, and, or"}));
        }
        return term;
    }

private:
    using Result = std::optional<Term>;
    using Sign = std::pair<std::string_view, Operation>;

    Result either() {
        return joined([&] { return both(); }, std::array{Sign{"or", Operation::either}});
    }
    Result both() {
        return joined([&] { return inverted(); }, std::array{Sign{"and", Operation::both}});
    }
    Result inverted() {
        skipBlanks();
        const std::size_t at = at_;
        if (!takeWord("not")) return comparison();
        if (++depth_ > kDeepest) return tooDeep(at);
        auto inner = inverted();
        --depth_;
        if (!inner) return {};
        return Term{.operation = Operation::invert, .at = at, .terms = {*std::move(inner)}};
    }
    Result comparison() {
        static constexpr std::array<Sign, 7> kSigns{{{"<=", Operation::at_most},
                                                     {">=", Operation::at_least},
                                                     {"==", Operation::equal},
                                                     {"!=", Operation::unequal},
                                                     {"<", Operation::less},
                                                     {">", Operation::greater},
                                                     {"=", Operation::equal}}};
        auto left = sum();
        const auto sign = left ? takeSign(kSigns) : std::nullopt;
        if (!sign) return left;
        auto right = sum();
        if (!right) return {};
        if (const auto more = takeSign(kSigns)) {
            return fail(more->second, "found a second comparison, expected one; write \"a < b and b < c\"");
        }
        return made(*sign, *std::move(left), *std::move(right));
    }
    Result sum() {
        return joined([&] { return product(); }, std::array{Sign{"+", Operation::add}, Sign{"-", Operation::subtract}});
    }
    Result product() {
        return joined([&] { return sign(); }, std::array{Sign{"*", Operation::multiply}, Sign{"/", Operation::divide}});
    }
    Result sign() {
        skipBlanks();
        const std::size_t at = at_;
        if (!take('-')) return power();
        if (++depth_ > kDeepest) return tooDeep(at);
        auto inner = sign();
        --depth_;
        if (!inner) return {};
        return Term{.operation = Operation::negate, .at = at, .terms = {*std::move(inner)}};
    }
    Result power() {
        auto base = value();
        skipBlanks();
        const std::size_t at = at_;
        if (!base || !take('^')) return base;
        auto exponent = value();
        if (!exponent) return {};
        return made({Operation::power, at}, *std::move(base), *std::move(exponent));
    }

    Result value() {
        skipBlanks();
        const std::size_t at = at_;
        if (at == text_.size()) {
            return fail(at, "found the end of the expression, expected a number, a channel or a function; complete it");
        }
        const char c = text_[at];
        if (c == '(') return inParentheses();
        if (c == '"' || c == '\'') return words(c);
        if (isDigit(c) || c == '.') return number();
        if (isLetter(c)) return named();
        return fail(at, concat({"found ", quote(text_.substr(at, 1)),
                                ", expected a number, a channel, a function or a parenthesis; correct it"}));
    }

    Result inParentheses() {
        const std::size_t at = at_++;
        if (++depth_ > kDeepest) return tooDeep(at);
        auto inner = either();
        --depth_;
        if (!inner) return {};
        skipBlanks();
        if (!take(')')) return fail(at, "found a parenthesis that is not closed; close it");
        return inner;
    }

    Result words(char mark) {
        const std::size_t at = at_, end = text_.find(mark, at + 1);
        if (end == std::string_view::npos) return fail(at, "found a quotation mark that is not closed; close it");
        at_ = end + 1;
        return Term{.operation = Operation::words, .at = at, .name = std::string(text_.substr(at + 1, end - at - 1))};
    }

    // takeNumber() wants the number alone: letters may follow it as a unit.
    Result number() {
        const std::size_t at = at_;
        std::size_t end = at;
        const auto digits = [&] {
            while (end < text_.size() && isDigit(text_[end])) ++end;
        };
        digits();
        if (end < text_.size() && text_[end] == '.') ++end;
        digits();
        if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
            std::size_t behind = end + 1;
            if (behind < text_.size() && (text_[behind] == '-' || text_[behind] == '+')) ++behind;
            if (behind < text_.size() && isDigit(text_[behind])) {
                end = behind;
                digits();
            }
        }
        std::string_view digits_only = text_.substr(at, end - at);
        const auto number = takeNumber(digits_only);
        if (!number || !digits_only.empty())
            return fail(at,
                        concat({"found ", quote(text_.substr(at, end - at)), ", which is not a number; correct it"}));
        at_ = end;
        Term term{.operation = Operation::number, .at = at, .number = *number};
        skipBlanks();
        const std::size_t unit_begins = at_;
        const std::string_view unit = takeUnit();
        if (unit.empty()) return term;
        std::string why;
        const auto known = parseUnit(unit, why);
        if (!known) return fail(unit_begins, why);
        term.number = *number * known->numerator / known->denominator + known->offset;
        term.dimension = known->dimension;
        return term;
    }

    // Names of units, with a space or a slash between, as long as they follow; "and", "or" and channels are none.
    std::string_view takeUnit() {
        skipBlanks();
        const std::size_t begin = at_;
        std::size_t end = begin;
        if (begin < text_.size() && text_[begin] == '%') {
            ++at_;
            return text_.substr(begin, 1);
        }
        for (bool first = true;; first = false) {
            std::size_t at = end;
            while (at < text_.size() && text_[at] == ' ') ++at;
            if (!first && at < text_.size() && text_[at] == '/') ++at;
            while (at < text_.size() && text_[at] == ' ') ++at;
            const std::size_t name_begins = at;
            while (at < text_.size() && isLetter(text_[at])) ++at;
            const std::string_view name = text_.substr(name_begins, at - name_begins);
            if (at < text_.size() && text_[at] == '^') ++at;
            if (at < text_.size() && text_[at] == '-' && at + 1 < text_.size() && isDigit(text_[at + 1])) ++at;
            while (at < text_.size() && isDigit(text_[at])) ++at;
            std::string why;
            const bool word = name == "and" || name == "or" || name == "not";
            const bool more = at < text_.size() && (text_[at] == '.' || text_[at] == '(' || text_[at] == '_');
            if (name.empty() || word || more) break;
            // What is glued to a number, or follows it, is meant as its unit.
            if (!first && !parseUnit(name, why)) break;
            end = at;
        }
        at_ = end;
        return text_.substr(begin, end - begin);
    }

    Result named() {
        const std::size_t at = at_;
        while (at_ < text_.size() &&
               (isLetter(text_[at_]) || isDigit(text_[at_]) || text_[at_] == '.' || text_[at_] == '@'))
            ++at_;
        Term term{.operation = Operation::name, .at = at, .name = std::string(text_.substr(at, at_ - at))};
        skipBlanks();
        if (!take('(')) return term;
        term.operation = Operation::call;
        if (++depth_ > kDeepest) return tooDeep(at);
        skipBlanks();
        if (!take(')')) {
            do {
                auto argument = either();
                if (!argument) return {};
                term.terms.push_back(*std::move(argument));
                skipBlanks();
            } while (take(','));
            if (!take(')')) {
                return fail(at, concat({"found ", term.name,
                                        "( without its closing parenthesis; close it, and put "
                                        "commas between its arguments"}));
            }
        }
        --depth_;
        return term;
    }

    template <class Next, std::size_t N>
    Result joined(const Next& next, const std::array<Sign, N>& signs) {
        auto left = next();
        while (left) {
            const auto sign = takeSign(signs);
            if (!sign) break;
            auto right = next();
            if (!right) return {};
            left = made(*sign, *std::move(left), *std::move(right));
        }
        return left;
    }

    static Term made(std::pair<Operation, std::size_t> sign, Term left, Term right) {
        Term term{.operation = sign.first, .at = sign.second};
        term.terms.push_back(std::move(left));
        term.terms.push_back(std::move(right));
        return term;
    }

    template <std::size_t N>
    std::optional<std::pair<Operation, std::size_t>> takeSign(const std::array<Sign, N>& signs) {
        skipBlanks();
        const std::size_t at = at_;
        for (const auto& [sign, operation] : signs) {
            const bool is_word = isLetter(sign.front());
            if (is_word ? !takeWord(sign) : !text_.substr(at_).starts_with(sign)) continue;
            if (!is_word) at_ += sign.size();
            return std::pair{operation, at};
        }
        return {};
    }

    bool takeWord(std::string_view word) {
        const std::string_view rest = text_.substr(at_);
        if (!rest.starts_with(word)) return false;
        if (rest.size() > word.size() && (isLetter(rest[word.size()]) || isDigit(rest[word.size()]))) return false;
        at_ += word.size();
        return true;
    }
    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void skipBlanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    }

    Result fail(std::size_t at, std::string text) {
        fault_ = {at, std::move(text)};
        return {};
    }
    Result tooDeep(std::size_t at) { return fail(at, "found more than 64 levels in an expression; simplify it"); }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    ExpressionFault& fault_;
};

}  // namespace

std::optional<Term> parseExpression(std::string_view text, ExpressionFault& fault) {
    return Parser(text, fault).all();
}

}  // namespace tread
