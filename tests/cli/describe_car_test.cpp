// `tread describe car.yaml`: the data sheet of a car.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/text/concat.h"
#include "base/text/markup.h"
#include "cli/program.h"
#include "report/text.h"
#include "shared/scratch.h"
#include "sheet/sheet.h"
#include "tread/load.h"

namespace tread::describe_car_test {
namespace {

using Json = nlohmann::json;

std::string compactFile() {
    return sourceFile("vehicles/compact.yaml");
}

double figure(const Json& sheet, const std::string& name) {
    for (const Json& row : sheet["figures"])
        if (row["name"] == name) return row["value"];
    ADD_FAILURE() << "no " << name;
    return 0;
}

std::string readText(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST(DescribeCar, EveryShippedCarHasASheet) {
    std::size_t cars = 0;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFile("vehicles"))) {
        if (entry.path().extension() != ".yaml") continue;
        ++cars;
        const Result result = runProgram({"describe", entry.path().string(), "--json"});
        EXPECT_EQ(result.status, 0) << entry.path();
        EXPECT_EQ(result.err, "") << entry.path();
        const Json sheet = Json::parse(result.out);
        EXPECT_EQ(sheet["vehicle"], loadVehicle(entry.path()).name);
        for (const Json& row : sheet["figures"])
            EXPECT_TRUE(row["value"].is_number() || row["note"] != "") << entry.path() << " " << row["name"];
        EXPECT_GT(figure(sheet, "top_speed"), 0) << entry.path();
    }
    EXPECT_GE(cars, 9u);
}

// Lines are broken between words.
std::string withSingleSpaces(const std::string& text) {
    std::istringstream words(text);
    std::string out, word;
    while (words >> word) out += (out.empty() ? "" : " ") + word;
    return out;
}

// Behind the answer, which is one line wherever it stands, lines fit a window.
TEST(DescribeCar, LinesHaveAtMostAHundredColumns) {
    std::istringstream lines(runProgram({"describe", compactFile()}).out);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
        EXPECT_LE(columns, 100) << line;
    }
}

// Text, page and JSON have every row of the table.
TEST(DescribeCar, TextPageAndJsonSayTheSame) {
    const Scratch scratch;
    const std::string page_file = scratch.path("sheet.html");
    const Result text = runProgram({"describe", compactFile(), "--report", page_file});
    EXPECT_EQ(text.status, 0);
    EXPECT_EQ(text.err, concat({"data sheet: ", page_file, "\n"}));
    const Json json = Json::parse(runProgram({"describe", compactFile(), "--json"}).out);
    const std::string page = readText(page_file);
    EXPECT_EQ(json["answer"], firstLine(text.out));
    const sheet::Sheet sheet = sheet::sheetOf(loadVehicle(compactFile()));
    ASSERT_EQ(json["figures"].size(), sheet.rows.size());
    const std::string words = withSingleSpaces(text.out);
    for (std::size_t i = 0; i < sheet.rows.size(); ++i) {
        const sheet::SheetRow& row = sheet.rows[i];
        const Json& in_json = json["figures"][i];
        EXPECT_EQ(in_json["name"], row.name);
        EXPECT_EQ(in_json["unit"], row.unit);
        EXPECT_EQ(in_json["formula"], row.formula);
        EXPECT_EQ(in_json["value"].is_null(), std::isnan(row.value)) << row.name;
        const std::string value = formatNumber(row.value, 4);
        for (const std::string_view part : {row.label, row.formula, row.sources.front()}) {
            EXPECT_TRUE(contains(words, part)) << part;
            EXPECT_TRUE(contains(page, escapeMarkup(part))) << part;
        }
        EXPECT_TRUE(contains(text.out, std::isnan(row.value) ? "none" : value)) << row.name;
        EXPECT_TRUE(contains(page, value)) << row.name;
    }
}

TEST(DescribeCar, TheNameOfAShippedCarIsEnough) {
    std::filesystem::current_path(sourceFile(""));  // where the shipped cars are looked for
    const Result sheet = runProgram({"describe", "compact"});
    EXPECT_EQ(sheet.status, 0) << sheet.err;
    EXPECT_EQ(sheet.out, runProgram({"describe", compactFile()}).out);
}

TEST(DescribeCar, ASettingChangesTheCar) {
    const auto sheet = [](const std::vector<std::string>& more) {
        std::vector<std::string> words{"describe", compactFile(), "--json"};
        words.insert(words.end(), more.begin(), more.end());
        return Json::parse(runProgram(words).out);
    };
    const Json usual = sheet({}), changed = sheet({"--set", "load.mass=200", "--set", "load.x=-1.2"});
    EXPECT_DOUBLE_EQ(figure(changed, "mass"), figure(usual, "mass") + 200);
    EXPECT_LT(figure(changed, "understeer_gradient"), figure(usual, "understeer_gradient"));
}

std::string sentence(const std::vector<std::string>& words) {
    const Result result = runProgram(words);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << "one sentence: " << result.err;
    return result.err;
}

TEST(DescribeCar, AFileOfAnotherKindIsOneSentence) {
    const std::string scenario = sourceFile("scenarios/steady_circle.yaml");
    EXPECT_EQ(sentence({"describe", scenario}),
              concat({scenario,
                      ": found a scenario file, expected a vehicle file; `tread run` takes it after the "
                      "vehicle\n"}));
    EXPECT_TRUE(contains(sentence({"describe", sourceFile("vehicles/tyres/car_205_60R15.yaml")}), "found a tyre file"));
    EXPECT_TRUE(contains(sentence({"describe", "there_is_none.yaml"}), "there_is_none.yaml: found no file"));
    EXPECT_TRUE(contains(sentence({"describe", "vehicl"}), "did you mean \"vehicle\"?"));
}

TEST(DescribeCar, OptionsOfTheSheetAreNotForWords) {
    EXPECT_TRUE(contains(sentence({"describe", "vehicle", "--report", "a.html"}), "--report: found with the word"));
    EXPECT_TRUE(contains(sentence({"describe", "vehicle", "--set", "mass=1"}), "--set: found with the word"));
    EXPECT_TRUE(contains(sentence({"describe", compactFile(), "--set", "mas=1"}), "did you mean \"mass\"?"));
}

}  // namespace
}  // namespace tread::describe_car_test
