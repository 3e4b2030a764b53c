// The lines of a CSV text that count: those that are neither empty nor a comment.
#pragma once

#include <algorithm>
#include <string_view>

namespace tread {

class CsvLines {
public:
    // A byte order mark is passed over.
    explicit CsvLines(std::string_view text) : rest_(text) {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
    }

    // Moves to the next of them; false at the end.
    bool next() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            line_ = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++number_;
            if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
            if (line_.find_first_not_of(" \t") != std::string_view::npos && line_.front() != '#') return true;
        }
        return false;
    }

    std::string_view line() const { return line_; }  // without its end
    int number() const { return number_; }           // in the text, from 1
    std::string_view rest() const { return rest_; }  // what follows the line

private:
    std::string_view rest_;
    std::string_view line_;
    int number_ = 0;
};

}  // namespace tread
