#include "scenario/course_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/math/elementary.h"
#include "base/text/concat.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "base/text/trimmed.h"
#include "base/units/units.h"
#include "base/yaml/position.h"
#include "log/csv_header.h"
#include "log/csv_lines.h"

namespace tread {
namespace {

constexpr double kFarApart = 3;  // ends of a closed course, over the longest way between two points [guess]

// One field of a point and the column that holds it.
struct CourseColumn {
    std::string name;
    std::string unit;
    Limits limits;
    double LinePoint::*field = nullptr;
};

// The columns that a file can have, from the one description of a point.
std::vector<CourseColumn> knownColumns() {
    std::vector<CourseColumn> known;
    constexpr std::array fields{&LinePoint::x, &LinePoint::y, &LinePoint::width, &LinePoint::bank, &LinePoint::speed};
    const LinePoint point;
    LinePoint::describe(point, [&](std::string_view name, const auto&, const About& about) {
        known.push_back({std::string(name), std::string(about.unit), about.limits, fields[known.size()]});
    });
    return known;
}

class CourseReader {
public:
    CourseReader(std::string_view text, const std::string& file, bool closed, std::vector<Problem>& problems)
        : lines_(text), file_(file), closed_(closed), problems_(problems) {}

    std::vector<LinePoint> read() {
        if (!lines_.next()) {
            complain(1, 1, "found no line, expected a header such as x [m],y [m] and points below it");
            return {};
        }
        header();
        if (!problems_.empty()) return {};
        while (lines_.next() && problems_.size() < kMostFaults) row();
        if (problems_.empty()) ends();
        return std::move(points_);
    }

private:
    static constexpr std::size_t kMostFaults = 20;

    void complain(int line, std::size_t column, std::string text) {
        problems_.push_back({file_, line, static_cast<int>(column), "", std::move(text)});
    }

    // "name [unit]"; without unit it is SI.
    void header() {
        const std::vector<CourseColumn> known = knownColumns();
        std::vector<std::string_view> names;
        for (const CourseColumn& column : known) names.push_back(column.name);
        for (const HeaderCell& cell : splitHeader(lines_.line())) {
            const std::string_view text = cell.text;
            const std::size_t bracket = std::min(text.find('['), text.size());
            const std::string_view name = trimmed(text.substr(0, bracket));
            std::string_view unit = bracket < text.size() ? text.substr(bracket + 1) : std::string_view();
            if (unit.ends_with(']')) unit.remove_suffix(1);
            const auto found = std::find(names.begin(), names.end(), name);
            if (found == names.end()) {
                complain(
                    lines_.number(), cell.column,
                    concat({"found the column ", quote(name), ", expected ", listed(names), didYouMean(name, names)}));
                continue;
            }
            CourseColumn column = known[static_cast<std::size_t>(found - names.begin())];
            const bool twice = std::any_of(columns_.begin(), columns_.end(),
                                           [&](const CourseColumn& other) { return other.name == column.name; });
            std::string why;
            if (twice)
                complain(lines_.number(), cell.column, concat({"found a second column ", quote(name), "; remove one"}));
            if (!unit.empty() && !toSi("0 " + std::string(unit), column.unit, why))
                complain(lines_.number(), cell.column, why);
            column.unit = unit.empty() ? column.unit : std::string(unit);
            columns_.push_back(std::move(column));
        }
        for (const std::string_view needed : {"x", "y"}) {
            if (std::none_of(columns_.begin(), columns_.end(), [&](const auto& c) { return c.name == needed; }))
                complain(lines_.number(), 1, concat({"found no column ", needed, ", expected x and y"}));
        }
    }

    void row() {
        const std::vector<HeaderCell> cells = splitHeader(lines_.line());
        if (cells.size() != columns_.size()) {
            complain(lines_.number(), 1,
                     concat({"found ", std::to_string(cells.size()), " cells, expected ",
                             std::to_string(columns_.size()), " as in the header"}));
            return;
        }
        LinePoint point;
        const std::size_t before = problems_.size();
        for (std::size_t i = 0; i < cells.size(); ++i) cell(cells[i], columns_[i], point);
        if (problems_.size() != before) return;
        if (!points_.empty() && hypotenuse(point.x - points_.back().x, point.y - points_.back().y) == 0)
            complain(lines_.number(), 1, "found the same point as in the line before; remove one of the two");
        points_.push_back(point);
        places_.push_back(lines_.number());
    }

    void cell(const HeaderCell& cell, const CourseColumn& column, LinePoint& point) {
        static const std::vector<CourseColumn> described = knownColumns();
        const auto si = std::find_if(described.begin(), described.end(),
                                     [&](const CourseColumn& known) { return known.name == column.name; });
        std::string_view rest = cell.text;
        const bool number = takeNumber(rest).has_value() && rest.empty();
        std::string why;
        const auto value = number ? toSi(cell.text + " " + column.unit, si->unit, why) : std::nullopt;
        if (!value) {
            complain(lines_.number(), cell.column,
                     concat({"found ", quote(cell.text), " in column ", column.name, ", expected a number"}));
        } else if (!column.limits.allow(*value)) {
            complain(lines_.number(), cell.column,
                     concat({"found ", quote(cell.text), " in column ", column.name, ", expected ",
                             limitsText(column.limits)}));
        } else {
            point.*column.field = *value;
        }
    }

    // Enough points, and a closed course that comes back.
    void ends() {
        const std::size_t least = closed_ ? 3 : 2;
        if (closed_ && points_.size() > 1 &&
            hypotenuse(points_.front().x - points_.back().x, points_.front().y - points_.back().y) == 0)
            points_.pop_back();  // the first point once more: the usual way to say that it is closed
        if (points_.size() < least) {
            complain(std::max(lines_.number(), 1), 1,
                     concat({"found ", std::to_string(points_.size()), " points, expected at least ",
                             std::to_string(least), closed_ ? " for a closed course" : ""}));
            return;
        }
        double longest = 0;
        for (std::size_t i = 1; i < points_.size(); ++i)
            longest = std::max(longest, hypotenuse(points_[i].x - points_[i - 1].x, points_[i].y - points_[i - 1].y));
        const double gap = hypotenuse(points_.front().x - points_.back().x, points_.front().y - points_.back().y);
        if (closed_ && gap > kFarApart * longest) {
            complain(
                places_[points_.size() - 1], 1,
                concat({"found the last point ", numberText(std::round(10 * gap) / 10),
                        " m from the first, expected a closed course to come back; add points or set closed: false"}));
        }
    }

    CsvLines lines_;
    const std::string& file_;
    bool closed_;
    std::vector<Problem>& problems_;
    std::vector<CourseColumn> columns_;
    std::vector<LinePoint> points_;
    std::vector<int> places_;  // line of each point
};

// Faults of the course beside its file, with their paths.
void checkUse(const Scenario& scenario, const std::filesystem::path& file, std::vector<Problem>& problems) {
    const CourseLine& line = scenario.course.line;
    const bool has_speed = line.limits.given() || std::any_of(line.points.begin(), line.points.end(),
                                                              [](const LinePoint& p) { return p.speed > 0; });
    for (std::size_t i = 0; i < scenario.phases.size(); ++i) {
        if (!std::holds_alternative<FollowCourse>(scenario.phases[i].throttle) || has_speed) continue;
        const std::string path = "phases." + std::to_string(i) + ".throttle";
        const TextPosition at = positionOfValue(file.string(), path);
        problems.push_back(
            {file.string(), at.line, at.column, path,
             "found a driver who follows the speed of the course, which has none; expected a column speed "
             "or course.line.limits"});
    }
    const std::size_t least = line.closed ? 3 : 2;
    if (line.points.empty() || line.points.size() >= least) return;
    const TextPosition at = positionOfValue(file.string(), "course.line.points");
    problems.push_back(
        {file.string(), at.line, at.column, "course.line.points",
         concat({"found ", std::to_string(line.points.size()), " points, expected at least ", std::to_string(least)})});
}

}  // namespace

std::vector<LinePoint> parseCourse(std::string_view text, const std::string& file, bool closed,
                                   std::vector<Problem>& problems) {
    return CourseReader(text, file, closed, problems).read();
}

Scenario withCourseRead(Scenario scenario, const std::filesystem::path& scenario_file) {
    CourseLine& line = scenario.course.line;
    std::vector<Problem> problems;
    if (!line.file.empty()) {
        const std::filesystem::path file = (scenario_file.parent_path() / line.file).lexically_normal();
        std::string fault;
        const auto text = readTextFile(file, fault);
        if (!text) {
            const TextPosition at = positionOfValue(scenario_file.string(), "course.line.file");
            problems.push_back({scenario_file.string(), at.line, at.column, "course.line.file",
                                concat({"found ", quote(file.string()), ": ", fault})});
        } else {
            line.points = parseCourse(*text, file.string(), line.closed, problems);
        }
        line.file.clear();
    }
    if (problems.empty()) checkUse(scenario, scenario_file, problems);
    if (!problems.empty()) throw LoadError(std::move(problems));
    return scenario;
}

}  // namespace tread
