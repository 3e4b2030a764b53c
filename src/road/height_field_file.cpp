#include "road/height_field_file.h"

#include <algorithm>
#include <cmath>

#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "base/text/trimmed.h"

namespace tread {
namespace {

constexpr double kEvenness = 1e-3;  // of the spacing, by which a coordinate may be off an equal step (rounded files)
constexpr std::size_t kMostFaults = 20;  // more than a person reads at once

class Table {
public:
    Table(std::string_view text, const std::string& file, std::vector<Problem>& problems)
        : rest_(text), file_(file), problems_(problems), faults_before_(problems.size()) {}

    void read(HeightField& field) {
        if (!nextLine()) return fault(0, "found an empty file, expected a first row with the y of every column");
        readHeader(field);
        if (!fine()) return;
        while (faults() < kMostFaults && nextLine()) readRow(field);
        if (!fine()) return;
        line_number_ = 0;
        if (x_.size() < 2) {
            return fault(0, "found " + std::to_string(x_.size()) + " rows of heights, expected at least two");
        }
        field.x_first = x_.front();
        field.x_spacing = (x_.back() - x_.front()) / static_cast<double>(x_.size() - 1);
        field.y_first = y_.front();
        field.y_spacing = (y_.back() - y_.front()) / static_cast<double>(y_.size() - 1);
        field.columns = static_cast<int>(y_.size());
    }

private:
    std::size_t faults() const { return problems_.size() - faults_before_; }
    bool fine() const { return faults() == 0; }
    void fault(std::size_t column, std::string text) {
        problems_.push_back({file_, line_number_, static_cast<int>(column), "", std::move(text)});
    }

    bool nextLine() {
        while (!rest_.empty()) {
            const std::size_t end = rest_.find('\n');
            line_ = rest_.substr(0, end);
            rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
            ++line_number_;
            if (const auto text = trimmed(line_); !text.empty() && text.front() != '#') return true;
        }
        return false;
    }

    // The cells of the line from its second on are numbers; complains and stops at the first that is none.
    bool readNumbers(std::vector<double>& numbers, std::size_t first_cell) {
        std::size_t begin = 0;
        for (std::size_t cell = 0;; ++cell) {
            const std::size_t end = std::min(line_.find(',', begin), line_.size());
            if (cell >= first_cell) {
                const std::string_view text = trimmed(line_.substr(begin, end - begin));
                std::string_view left = text;
                const auto number = takeNumber(left);
                if (!number || !left.empty()) {
                    fault(begin + 1, "found " + quote(text) + ", expected a number in m");
                    return false;
                }
                if (!kOnEarth.allow(*number)) {
                    fault(begin + 1, "found " + quote(text) + ", expected a number " + limitsText(kOnEarth) + " m");
                    return false;
                }
                numbers.push_back(*number);
            }
            if (end == line_.size()) return true;
            begin = end + 1;
        }
    }

    // Complains unless the last of the first `count` coordinates goes on in the step of the first two.
    void checkStep(const std::vector<double>& at, std::size_t count, const char* name) {
        if (count < 2) return;
        const double step = at[1] - at[0], before = at[count - 2], last = at[count - 1];
        if (!(step > 0)) {
            fault(1, std::string("found ") + name + " = " + numberText(at[1]) + " after " + numberText(at[0]) +
                         ", expected it to increase");
        } else if (std::abs(last - before - step) > kEvenness * step) {
            fault(1, std::string("found ") + name + " = " + numberText(last) + " after " + numberText(before) +
                         ", expected equal steps of " + numberText(step) + " m");
        }
    }

    void readHeader(HeightField& field) {
        const std::string_view name = trimmed(line_.substr(0, line_.find(',')));
        if (name.find("[m]") == std::string_view::npos) {
            return fault(1, "found " + quote(name) + ", expected a first cell like \"x\\y [m]\", then the y of every " +
                                "column");
        }
        if (line_.find(',') == std::string_view::npos || !readNumbers(y_, 1)) {
            if (fine()) fault(1, "found no column, expected the y of at least two");
            return;
        }
        if (y_.size() < 2) return fault(1, "found one column, expected at least two");
        for (std::size_t count = 2; count <= y_.size() && fine(); ++count) checkStep(y_, count, "y");
        field.heights.clear();
    }

    void readRow(HeightField& field) {
        std::vector<double> row;
        if (!readNumbers(row, 0)) return;
        if (row.size() != y_.size() + 1) {
            return fault(1, "found " + std::to_string(row.size()) + " cells, expected x and " +
                                std::to_string(y_.size()) + " heights");
        }
        x_.push_back(row.front());
        checkStep(x_, x_.size(), "x");
        field.heights.insert(field.heights.end(), row.begin() + 1, row.end());
    }

    std::string_view rest_;
    const std::string& file_;
    std::vector<Problem>& problems_;
    std::size_t faults_before_;
    std::string_view line_;
    int line_number_ = 0;
    std::vector<double> x_, y_;
};

}  // namespace

void parseHeightField(HeightField& field, std::string_view text, const std::string& file,
                      std::vector<Problem>& problems) {
    if (isPlainText(text, file, problems)) Table(text, file, problems).read(field);
}

bool readForeign(HeightField& field, const std::filesystem::path& file, std::vector<Problem>& problems) {
    if (file.extension() != ".csv" && file.extension() != ".CSV") return false;
    const std::string name = file.string();
    std::string fault;
    if (const auto text = readTextFile(file, fault); !text) {
        problems.push_back({name, 0, 0, "", fault});
    } else {
        parseHeightField(field, *text, name, problems);
    }
    return true;
}

}  // namespace tread
