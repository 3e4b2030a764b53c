#include "describe_car.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/setting.h"
#include "base/text_file.h"
#include "base/yaml_document.h"
#include "describable.h"
#include "kind_of_file.h"
#include "output.h"
#include "report/sheet_report.h"
#include "report/text.h"
#include "sheet/sheet.h"
#include "tread/load.h"
#include "wrapped.h"

namespace tread::program {
namespace {

using sheet::Sheet;
using sheet::SheetRow;

[[noreturn]] void rejectKind(const std::string& file, const std::string& found) {
    throw LoadError({{file, 0, 0, "",
                      fmt::format("found {}, expected a vehicle file, such as vehicles/compact.yaml; `tread describe "
                                  "vehicle` lists what it holds",
                                  found)}});
}

// One sentence for a file of another kind, where the reader would name every field that a car has and it has not.
void expectCar(const std::string& file) {
    const std::string extension = Path(file).extension().string();
    if (extension == ".tir" || extension == ".TIR") rejectKind(file, "a tyre property file");
    if (extension == ".csv" || extension == ".CSV") rejectKind(file, "a table of values");
    std::string fault;
    const auto text = readTextFile(file, fault);
    std::vector<Problem> problems;
    const auto document = text ? parseYaml(*text, file, problems) : std::nullopt;
    if (!document) return;  // the reader says why
    const std::vector<std::string> keys = keysOf(*document);
    const Describable* const kind = bestMatch(keys);
    if (!kind) rejectKind(file, foundKeys(keys));
    if (kind->name != "vehicle") rejectKind(file, fmt::format("a {} file", kind->name));
}

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
    const std::size_t columns = outputColumns(), indent = 2 + labels + 2 + values + 1 + units + 2;
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
    expectCar(options.what);
    VehicleParams car = loadVehicle(options.what);
    applySettings(car, options.settings, "--set",
                  [](std::string_view) -> std::string { return "`tread describe vehicle` lists all paths"; });
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
