// Replays the corpora of the import fuzzers.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "fuzz/import_entry.h"
#include "fuzz/mat_entry.h"
#include "import/formats/mat_whole.h"
#include "places/places.h"

namespace tread::import_corpus_test {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ImportCorpus, EveryTextBecomesALogOrIsRefusedInWords) {
    std::vector<std::string> taken;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFile("tests/fuzz/corpus/import"))) {
        SCOPED_TRACE(entry.path().string());
        if (fuzz::importHostileText(bytesOf(entry.path()))) taken.push_back(entry.path().filename());
        ++files;
    }
    std::sort(taken.begin(), taken.end());
    EXPECT_GE(files, 15u);
    EXPECT_EQ(taken, (std::vector<std::string>{"commas.csv", "duplicates.csv", "holes.csv", "jumps.csv", "latin1.vbo",
                                               "metadata.csv", "no_time.csv", "plain.csv", "short_last_row.vbo",
                                               "units_below.csv"}));
}

TEST(ImportCorpus, EveryMatlabFileIsJudged) {
    std::size_t files = 0, whole = 0;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFile("tests/fuzz/corpus/mat"))) {
        SCOPED_TRACE(entry.path().string());
        const std::string bytes = bytesOf(entry.path());
        whole += matContents(bytes).fault.empty();
        fuzz::importHostileMat(bytes);
        ++files;
    }
    EXPECT_GE(files, 6u);
    EXPECT_EQ(whole, 6u)
        << "versions 4, 5, with a variable that matio does not read, with an object, with tiny steps of "
           "time, header of 7.3";
}

// matio would look for the data of such a part within its name, and take gigabytes.
TEST(ImportCorpus, FieldsAndCellsWithNamesOfTheirOwnAreDamage) {
    for (const char* file : {"sparse_field_with_a_name.bin", "sparse_in_a_cell_with_a_name.bin"}) {
        const std::string told = bytesOf(sourceFile("tests/fuzz/corpus/mat/" + std::string(file)));
        EXPECT_EQ(matContents(fuzz::MatWriter(told).file()).fault,
                  "is damaged: its variable number 2 has a part that is out of place or claims more than it holds")
            << file;
    }
}

// matio would read the length of the name in the other order, and take 1.7 GB.
TEST(ImportCorpus, Version4GoesByTheOrderThatItTells) {
    const std::string file = bytesOf(sourceFile("tests/fuzz/corpus/mat/v4_in_the_other_order.mat"));
    EXPECT_EQ(matContents(file).fault, "is not a MATLAB file that tread can read (neither version 4, 5 nor 7.3)");
}

// matio does not tell the name of an object.
TEST(ImportCorpus, ObjectsThatTheLibraryDoesNotReadAreTold) {
    const ForeignTable table = readMat(sourceFile("tests/fuzz/corpus/mat/v5_object.mat"));
    ASSERT_EQ(table.columns.size(), 2u);
    EXPECT_EQ(table.columns[0].name, "time");
    EXPECT_EQ(table.columns[1].name, "speed");
    EXPECT_EQ(table.notes,
              std::vector<std::string>{
                  "1 variable that tread cannot read (objects, tables, cells, complex numbers) was skipped"});
}

TEST(ImportCorpus, VariablesThatTheLibraryDoesNotReadAreTold) {
    try {
        readMat(sourceFile("tests/fuzz/corpus/mat/v5_beyond_matio.mat"));
        FAIL() << "it holds nothing that can be read";
    } catch (const LoadError& error) {
        EXPECT_NE(
            error.problems().front().text.find(
                "; variable number 1 of 2 is of a kind that the MATLAB library cannot read; it and those after it "
                "were skipped"),
            std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace tread::import_corpus_test
