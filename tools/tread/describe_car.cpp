#include "describe_car.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/yaml/setting.h"
#include "kind_of_file.h"
#include "output.h"
#include "plausibility.h"
#include "report/sheet_report.h"
#include "report/text.h"
#include "sheet/sheet.h"
#include "terminal.h"
#include "tread/load.h"
#include "vehicle/fields.h"

namespace tread::program {
namespace {

using sheet::Sheet;
using sheet::SheetRow;

std::string joined(const std::vector<std::string_view>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string text(const Sheet& sheet) {
    const auto widest = [&](auto cell) {
        std::size_t width = 0;
        for (const SheetRow& row : sheet.rows) width = std::max(width, cell(row).size());
        return width;
    };
    const auto shown = [](const SheetRow& row) { return std::isnan(row.value) ? "none" : formatNumber(row.value, 4); };
    const std::size_t labels = widest([](const SheetRow&row) { return row.label; }), values = widest(shown),
                      units = widest([](const SheetRow&row) { return row.unit; });
    const std::size_t columns = lineWidth(), indent = 2 + labels + 2 + values + 1 + units + 2;
    std::string out = sheetAnswer(sheet) + "\n";
    std::string_view group;
    for (const SheetRow& row : sheet.rows) {
        if (row.group != group) fmt::format_to(std::back_inserter(out), "\n{}\n", group = row.group);
        const bool has_unit = row.unit != "-" && !std::isnan(row.value);
        fmt::format_to(std::back_inserter(out), "  {:<{}}  {:>{}} {:<{}}  {}\n", row.label, labels, shown(row), values,
                       has_unit ? row.unit : "", units, wrapped(row.formula, indent, columns));
        fmt::format_to(std::back_inserter(out), "      {}\n", wrapped("from " + joined(row.sources), 6, columns));
        if (!row.note.empty()) fmt::format_to(std::back_inserter(out), "      {}\n", wrapped(row.note, 6, columns));
    }
    return out + fmt::format("\n{}\n", wrapped(sheet::kSymbols, 0, columns));
}

nlohmann::json json(const Sheet& sheet, const std::string& file, const std::string& report) {
    nlohmann::json figures = nlohmann::json::array();
    for (const SheetRow& row : sheet.rows) {
        figures.push_back({{"name", row.name},
                           {"group", row.group},
                           {"label", row.label},
                           {"value", std::isfinite(row.value) ? nlohmann::json(row.value) : nlohmann::json(nullptr)},
                           {"unit", row.unit},
                           {"note", row.note},
                           {"formula", row.formula},
                           {"sources", row.sources}});
    }
    return {{"answer", sheetAnswer(sheet)},
            {"vehicle", sheet.name},
            {"file", file},
            {"report", report},
            {"figures", figures}};
}

}  // namespace

int describeCar(const DescribeOptions& options) {
    expectKind(options.what, {"vehicle"});
    VehicleParams car = loadVehicle(options.what);
    applySettings(car, options.settings, "--set",
                  [](std::string_view) -> std::string { return "`tread describe vehicle` lists all paths"; });
    warnOfImplausible(implausibleIn(car, options.what, {{options.settings, "--set"}}));
    const Sheet sheet = sheet::sheetOf(car);
    if (!options.report.empty()) {
        writeFile(options.report, sheetReport({.file = options.what,
                                               .settings = options.settings,
                                               .version = TREAD_VERSION,
                                               .sheet = sheet,
                                               .resolved_yaml = vehicleYaml(car)}));
        note("data sheet: " + options.report);
    }
    if (options.json) {
        printJson(json(sheet, options.what, options.report));
    } else {
        print(text(sheet));
    }
    return kYes;
}

}  // namespace tread::program
