// Text tables and VBOX files of other programs, read as they are.
#include <gtest/gtest.h>

#include "import/formats/foreign_table.h"
#include "import/formats/unit_spelling.h"
#include "shared/foreign_logs.h"
#include "shared/import_problems.h"

namespace tread::import_text_test {
namespace {

using foreign::Style;

void expectDrive(const ForeignTable& table) {
    ASSERT_EQ(table.columns.size(), 5u);
    const auto columns = foreign::loggerColumns();
    for (std::size_t c = 0; c < columns.size(); ++c) {
        EXPECT_EQ(table.columns[c].name, columns[c].name);
        EXPECT_EQ(table.columns[c].unit, columns[c].unit);
        ASSERT_EQ(table.columns[c].values.size(), 501u);
        for (int i : {0, 100, 500}) {
            EXPECT_NEAR(table.columns[c].values[static_cast<std::size_t>(i)], columns[c].value(0.01 * i), 1e-6);
        }
    }
}

TEST(ForeignCsv, EveryDialectGivesTheSameTable) {
    for (const Style& style :
         {Style{}, Style{",", '.', false}, Style{";", ',', true}, Style{";", ',', false}, Style{";", '.', true},
          Style{"\t", '.', true}, Style{"\t", ',', false}, Style{" ; ", '.', true}, Style{", ", '.', true},
          Style{",", '.', true, "# made by a logger\n% version 3\n// driver: nobody\n"},
          Style{";", ',', true, "Logger 5000\nVehicle;Test car\n\n"}, Style{",", '.', true, "\xEF\xBB\xBF"}}) {
        SCOPED_TRACE("delimiter '" + style.delimiter + "' decimal " + style.decimal + " above '" + style.above + "'");
        expectDrive(parseForeignCsv(foreign::table(foreign::loggerColumns(), foreign::times(), style), "x.csv"));
    }
}

TEST(ForeignCsv, BlanksMayDelimitAndEndTheLine) {
    const ForeignTable table = parseForeignCsv("t   vx ay\n0.00  1  2  \n 0.01 3\t4\n", "x.txt");
    ASSERT_EQ(table.columns.size(), 3u);
    EXPECT_EQ(table.columns[2].values, (std::vector<double>{2, 4}));
}

TEST(ForeignCsv, HeaderMayBeACommentAndNamesMayBeQuoted) {
    EXPECT_EQ(parseForeignCsv("# t,vx,ay\n0,1,2\n1,2,3\n", "x.csv").columns[1].name, "vx");
    const ForeignTable quoted = parseForeignCsv("\"Time (s)\",\"a, lateral (m/s^2)\"\n0,1\n1,2\n", "x.csv");
    EXPECT_EQ(quoted.columns[1].name, "a, lateral");
    EXPECT_EQ(quoted.columns[1].unit, "m/s^2");
    EXPECT_EQ(parseForeignCsv("t,accel (front)\n0,1\n1,2\n", "x.csv").columns[1].name, "accel (front)")
        << "what stands in parentheses is a unit only when it is one";
}

TEST(ForeignCsv, Latin1IsUnderstoodAndSaid) {
    const ForeignTable table = parseForeignCsv("t,yaw rate\ns,\xB0/s\n0,1\n0.01,2\n", "x.csv");
    EXPECT_EQ(table.columns[1].unit, "°/s");
    ASSERT_EQ(table.notes.size(), 1u);
    EXPECT_EQ(table.notes[0], "the text is not UTF-8; it was read as Latin-1");
}

TEST(ForeignCsv, ClockTimesAreSecondsAndEmptyCellsAreMissing) {
    const ForeignTable table = parseForeignCsv("time;vx\n10:53:17,25;3,5\n10:53:17,50;\n10:53:17,75;nan\n", "x.csv");
    EXPECT_NEAR(table.columns[0].values[1], 10 * 3600 + 53 * 60 + 17.5, 1e-9);
    EXPECT_TRUE(std::isnan(table.columns[1].values[1]));
    EXPECT_TRUE(std::isnan(table.columns[1].values[2]));
    EXPECT_FALSE(table.columns[1].not_a_number);
}

TEST(ForeignCsv, AWordAmongNumbersIsKeptWithItsPlace) {
    const ForeignTable table = parseForeignCsv("t,vx\n0,1\n0.1,fast\n0.2,3\n", "x.csv");
    ASSERT_TRUE(table.columns[1].not_a_number);
    EXPECT_EQ(toText(*table.columns[1].not_a_number), "x.csv:3:5: vx: found \"fast\", which is not a number");
}

TEST(ForeignCsv, AColumnOfTheSameNameGetsANumber) {
    const ForeignTable table = parseForeignCsv("t,v,v\n0,1,2\n1,3,4\n", "x.csv");
    EXPECT_EQ(table.columns[2].name, "v#2");
    EXPECT_EQ(table.notes.size(), 1u);
}

TEST(ForeignCsv, FaultsSayWhere) {
    const auto faults = [](const std::string& text) { return faultsOf([&] { parseForeignCsv(text, "x.csv"); }); };
    EXPECT_EQ(faults("t,vx\n0,1\n0.1,2,3\n0.2,1\n"), "x.csv:3:1: the row has 3 values, the header has 2 columns");
    EXPECT_EQ(faults(""), "x.csv: is empty, expected a header and rows of numbers");
    EXPECT_EQ(faults("0,1\n1,2\n2,3\n").find("x.csv:1:1: found numbers in the first row, expected a header"), 0u);
    EXPECT_EQ(faults("only words\nand more words\n").find("x.csv: has no rows of numbers"), 0u);
    EXPECT_EQ(faults(std::string("t,v\n0,\0\n", 8)).find("x.csv: is not a text file"), 0u);
    EXPECT_EQ(faults("\xFF\xFEt\0,\0").find("x.csv: is text in UTF-16"), 0u);
}

TEST(ForeignCsv, ARowThatIsCutOffAtTheEndIsLeftOutAndSaid) {
    const ForeignTable table = parseForeignCsv("t,vx,ay\n0,1,2\n1,2,3\n2,", "x.csv");
    EXPECT_EQ(table.columns[0].values.size(), 2u);
    ASSERT_EQ(table.notes.size(), 1u);
    EXPECT_EQ(table.notes[0], "the file ends within a row (line 4), which was left out");
}

TEST(Vbo, HasNamesUnitsAndRows) {
    const ForeignTable table = parseVbo(foreign::vbo(foreign::times()), "x.vbo");
    ASSERT_EQ(table.columns.size(), 6u);
    EXPECT_EQ(table.columns[2].name, "velocity");
    EXPECT_EQ(table.columns[2].unit, "kmh");
    EXPECT_EQ(table.columns[4].name, "YawRate");
    EXPECT_EQ(table.columns[4].unit, "°/s") << "[channel units] has the units of the last channels, in Latin-1";
    EXPECT_EQ(table.columns[5].unit, "rad");
    ASSERT_EQ(table.columns[1].values.size(), 501u);
    EXPECT_NEAR(table.columns[1].values[100], 105318.0, 1e-9);
    EXPECT_NEAR(table.columns[4].values[100], -foreign::yawRate(1.0) / foreign::kDegree, 1e-4);
}

TEST(Vbo, TruncatedOrForeignFilesAreRefusedInOneSentence) {
    const std::string whole = foreign::vbo(foreign::times(3));
    const auto faults = [](const std::string& text) { return faultsOf([&] { parseVbo(text, "x.vbo"); }); };
    EXPECT_EQ(faults("hello\n").find("x.vbo: is not a VBOX file: it has no sections, expected [header]"), 0u);
    EXPECT_EQ(faults(whole.substr(0, whole.find("[data]"))).find("x.vbo: has no section, expected [data]"), 0u);
    EXPECT_EQ(faults(whole.substr(0, whole.find("[data]") + 8)), "x.vbo:21:1: the section [data] has no rows");
    EXPECT_EQ(faults("[header]\n\n[data]\n1 2\n"), "x.vbo:1:1: the section [header] names no channel");
    std::string ragged = whole;
    ragged.insert(ragged.find("012 105317.01") + 4, "7 ");
    EXPECT_EQ(faults(ragged), "x.vbo:23:1: the row has 7 values, the header names 6 channels");
}

TEST(Vbo, ARowThatIsCutOffAtTheEndIsLeftOutAndSaid) {
    const std::string whole = foreign::vbo(foreign::times(3));
    const ForeignTable table = parseVbo(whole.substr(0, whole.size() - 30), "x.vbo");
    EXPECT_EQ(table.lines.size(), 2u);
    ASSERT_EQ(table.notes.size(), 2u);
    EXPECT_EQ(table.notes[1], "the file ends within a row (line 24), which was left out");
}

TEST(UnitSpelling, KnowsWhatOthersWrite) {
    const std::pair<const char*, const char*> kPairs[] = {{"kmh", "km/h"},   {"KM/H", "km/h"},
                                                          {"mps", "m/s"},    {"m/sec^2", "m/s2"},
                                                          {"degs", "deg/s"}, {"deg/s", "deg/s"},
                                                          {"G", "g"},        {"NewtonMet ", "N m"},
                                                          {"Nm", "N m"},     {"1/min", "rpm"},
                                                          {"percent", "%"},  {"-", "-"},
                                                          {"furlong", ""},   {"", ""}};
    for (const auto& [foreign, unit] : kPairs) EXPECT_EQ(spelledUnit(foreign), unit) << foreign;
    EXPECT_EQ(unitInName("r_vbox_radps"), "rad/s");
    EXPECT_EQ(nameWithoutUnit("r_vbox_radps"), "r_vbox");
    EXPECT_EQ(unitInName("velocity kmh"), "km/h");
    EXPECT_EQ(unitInName("omega_FL"), "");
    EXPECT_EQ(siUnitOf("rpm"), "rad/s");
    EXPECT_EQ(siUnitOf("degC"), "K");
}

}  // namespace
}  // namespace tread::import_text_test
