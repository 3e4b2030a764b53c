#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/text/text_file.h"
#include "log/binary_log.h"
#include "log/csv.h"
#include "log/csv_header.h"
#include "log/csv_lines.h"
#include "store/result_folder.h"

namespace tread {
namespace {

constexpr std::size_t kMostProblems = 20;        // more faults than a person reads at once
constexpr std::size_t kBinaryProbeBytes = 4096;  // where control characters give a binary file away

class Reader {
public:
    Reader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

    Log read() {
        checkText();
        readColumns();
        while (problems_.size() < kMostProblems && lines_.next()) readRow();
        if (!problems_.empty()) throw LoadError(std::move(problems_));
        if (log_.samples() == 0)
            throw LoadError({{file_, lines_.number(), 0, "", "there are no rows below the header"}});
        return std::move(log_);
    }

private:
    void fault(std::size_t column, std::string text) {
        problems_.push_back({file_, lines_.number(), static_cast<int>(column), "", std::move(text)});
    }

    void checkText() {
        const auto isBinary = [](char c) {
            return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
        };
        const std::string_view probe = lines_.rest().substr(0, kBinaryProbeBytes);
        if (std::any_of(probe.begin(), probe.end(), isBinary) || lines_.rest().find('\0') != std::string_view::npos) {
            throw LoadError({{file_, 0, 0, "", "is not a text file, expected CSV with a header of `name [unit]`"}});
        }
    }

    void readColumns() {
        if (!lines_.next()) throw LoadError({{file_, 0, 0, "", "is empty, expected a header of `name [unit]`"}});
        const std::vector<Column> columns = readHeader(lines_.line(), lines_.number(), file_, problems_);
        if (!problems_.empty()) throw LoadError(std::move(problems_));
        const std::string_view rest = lines_.rest();
        const auto lines = static_cast<std::size_t>(std::count(rest.begin(), rest.end(), '\n')) + 1;
        const std::size_t rows = std::min(lines, rest.size() / (2 * columns.size()) + 1);  // a cell has two characters
        for (const Column& column : columns) {
            log_.channels.push_back({column.name, column.unit, {}});
            log_.channels.back().values.reserve(rows);
        }
    }

    void readRow() {
        const std::string_view line = lines_.line();
        const char* at = line.data();
        const char* const end = at + line.size();
        const std::size_t columns = log_.channels.size();
        for (std::size_t i = 0; i < columns; ++i) {
            double value;
            const std::size_t place = static_cast<std::size_t>(at - line.data()) + 1;
            if (!readNumber(at, end, value)) return notANumber(place, i);
            const bool ends = at == end;
            if (ends != (i + 1 == columns)) return ragged(place);
            if (!ends) ++at;
            log_.channels[i].values.push_back(value);
        }
        checkTime();
    }

    // A number with blanks around it, up to a comma or the end of the line.
    static bool readNumber(const char*& at, const char* end, double& value) {
        while (at != end && (*at == ' ' || *at == '\t')) ++at;
        const auto result = std::from_chars(at, end, value);
        if (result.ec != std::errc{}) return false;
        at = result.ptr;
        while (at != end && (*at == ' ' || *at == '\t')) ++at;
        return at == end || *at == ',';
    }

    void notANumber(std::size_t place, std::size_t column) {
        const std::string_view rest = lines_.line().substr(place - 1);
        const std::string_view cell = rest.substr(0, rest.find(','));
        const bool empty = cell.find_first_not_of(" \t") == std::string_view::npos;
        fault(place, "column " + shown(log_.channels[column].name) + ": " +
                         (empty ? "the cell is empty, expected a number" : shown(cell) + " is not a number"));
    }

    void ragged(std::size_t place) {
        const std::string_view line = lines_.line();
        const auto values = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
        const std::size_t columns = log_.channels.size();
        const auto counted = [](std::size_t count, const char* what) {
            return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
        };
        fault(place, "the row has " + counted(values, "value") + ", the header has " + counted(columns, "column"));
    }

    void checkTime() {
        const std::vector<double>& time = log_.channels.front().values;
        if (!std::isfinite(time.back())) {
            fault(1, "the time is not finite");
        } else if (time.size() > 1 && !(time.back() > time[time.size() - 2])) {
            fault(1, "the time does not increase from one row to the next");
        }
    }

    CsvLines lines_;
    std::string file_;
    Log log_;
    std::vector<Problem> problems_;
};

}  // namespace

Log parseLog(std::string_view text, const std::string& file) {
    return Reader(text, file).read();
}

std::string readBytes(const std::filesystem::path& path) {
    std::string fault;
    auto text = readWholeFile(path, fault);
    if (!text) throw FileError("cannot read '" + path.string() + "': " + fault);
    return std::move(*text);
}

Log readLog(const std::filesystem::path& path) {
    expectComplete(path);
    const std::string bytes = readBytes(path);
    return isBinaryLog(bytes) ? parseBinaryLog(bytes, path.string()) : parseLog(bytes, path.string());
}

}  // namespace tread
