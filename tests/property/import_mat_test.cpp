// MATLAB files, written here with matio and read back.
#include <gtest/gtest.h>
#include <matio.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>

#include "base/yaml/read.h"
#include "fuzz/mat_entry.h"
#include "import/import.h"
#include "log/csv.h"
#include "shared/foreign_logs.h"
#include "shared/import_problems.h"

namespace tread::import_mat_test {
namespace {

namespace fs = std::filesystem;

class Mat : public testing::Test {
protected:
    Mat() {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        file_ = fs::path(testing::TempDir()) / ("tread_" + test + ".mat");
    }
    ~Mat() override { fs::remove(file_); }

    static matvar_t* column(const char* name, std::vector<double> values, std::size_t columns = 1) {
        std::size_t dims[2] = {values.size() / columns, columns};
        return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, values.data(), 0);
    }

    void write(const std::vector<matvar_t*>& variables, mat_ft version = MAT_FT_MAT5,
               matio_compression compression = MAT_COMPRESSION_NONE) {
        mat_t* mat = Mat_CreateVer(file_.c_str(), nullptr, version);
        ASSERT_NE(mat, nullptr);
        for (matvar_t* variable : variables) {
            ASSERT_NE(variable, nullptr);
            EXPECT_EQ(Mat_VarWrite(mat, variable, compression), 0);
            Mat_VarFree(variable);
        }
        Mat_Close(mat);
    }

    std::vector<matvar_t*> drive() {
        std::vector<double> t = foreign::times(), rate, speed(t.size(), 3.6 * foreign::kSpeed);
        for (const double at : t) rate.push_back(-foreign::yawRate(at) / foreign::kDegree);
        return {column("t", t), column("yaw_rate_degs", rate), column("v", speed)};
    }

    std::string bytes() const {
        std::ifstream stream(file_, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    void rewrite(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }

    fs::path file_;
};

void expectDrive(const fs::path& file) {
    const auto map = readYamlText<ImportMap>(
        "time: {from: t}\n"
        "map:\n"
        "  - {channel: chassis.yaw_rate, from: yaw_rate_degs, sign: -1}\n"
        "  - {channel: chassis.vx, from: v, unit: km/h}\n",
        "map.yaml");
    const Log log = importLog(readForeignTable(file), map).logs.at(0);
    ASSERT_EQ(log.samples(), 501u);
    for (std::size_t i : {0u, 250u, 500u}) {
        EXPECT_NEAR(valuesOf(log, "chassis.yaw_rate")[i], foreign::yawRate(0.01 * static_cast<double>(i)), 1e-12);
        EXPECT_NEAR(valuesOf(log, "chassis.vx")[i], foreign::kSpeed, 1e-12);
    }
}

TEST_F(Mat, Version5IsReadPlainAndCompressed) {
    write(drive());
    expectDrive(file_);
    write(drive(), MAT_FT_MAT5, MAT_COMPRESSION_ZLIB);
    expectDrive(file_);
}

TEST_F(Mat, Version4IsRead) {
    write(drive(), MAT_FT_MAT4);
    expectDrive(file_);
}

TEST_F(Mat, Version73IsReadWhereMatioCan) {
    mat_t* const probe = Mat_CreateVer(file_.c_str(), nullptr, MAT_FT_MAT73);
    if (!probe) GTEST_SKIP() << "matio was built without HDF5";
    Mat_Close(probe);
    write(drive(), MAT_FT_MAT73);
    expectDrive(file_);
}

TEST_F(Mat, FieldsOfStructsAndColumnsOfArraysHaveNames) {
    std::size_t one[2] = {1, 1};
    const char* fields[] = {"time", "signals"};
    matvar_t* const log = Mat_VarCreateStruct("log", 2, one, fields, 2);
    Mat_VarSetStructFieldByName(log, "time", 0, column("time", {0, 1, 2}));
    Mat_VarSetStructFieldByName(log, "signals", 0, column("signals", {1, 2, 3, 4, 5, 6}, 2));
    write({log, column("row", {7, 8, 9})});
    const ForeignTable table = readForeignTable(file_);
    ASSERT_EQ(table.columns.size(), 4u);
    EXPECT_EQ(table.columns[0].name, "log.time");
    EXPECT_EQ(table.columns[2].name, "log.signals(:,2)");
    EXPECT_EQ(table.columns[2].values, (std::vector<double>{4, 5, 6}));
}

TEST_F(Mat, WholeNumbersAndSinglesAreNumbers) {
    std::size_t dims[2] = {1, 3};
    std::int16_t counts[] = {-1, 2, 300};
    float singles[] = {0.5F, 1.5F, 2.5F};
    write({Mat_VarCreate("counts", MAT_C_INT16, MAT_T_INT16, 2, dims, counts, 0),
           Mat_VarCreate("singles", MAT_C_SINGLE, MAT_T_SINGLE, 2, dims, singles, 0)});
    const ForeignTable table = readForeignTable(file_);
    EXPECT_EQ(table.columns.at(0).values, (std::vector<double>{-1, 2, 300}));
    EXPECT_EQ(table.columns.at(1).values, (std::vector<double>{0.5, 1.5, 2.5}));
}

TEST_F(Mat, WhatIsNoNumberIsPassedOverAndSaid) {
    std::size_t dims[2] = {1, 5};
    char words[] = "hello";
    std::size_t one[2] = {1, 1};
    matvar_t* const cell = Mat_VarCreate("cell", MAT_C_CELL, MAT_T_CELL, 2, one, nullptr, 0);
    Mat_VarSetCell(cell, 0, column("inside", {1, 2}));
    write({Mat_VarCreate("words", MAT_C_CHAR, MAT_T_UINT8, 2, dims, words, 0), cell, column("v", {1, 2})});
    const ForeignTable table = readForeignTable(file_);
    ASSERT_EQ(table.columns.size(), 1u);
    ASSERT_EQ(table.notes.size(), 1u);
    EXPECT_EQ(table.notes[0],
              "1 variable that tread cannot read (objects, tables, cells, complex numbers: cell) was skipped");
}

TEST_F(Mat, FaultsNameTheFileOrTheVariable) {
    const std::string file = file_.string();
    rewrite("hello");
    EXPECT_EQ(faultsOf([&] { readForeignTable(file_); }),
              file + ": is cut off within its variable number 1: 15 bytes are missing");
    rewrite("hello, this is no MATLAB file at all");
    EXPECT_EQ(faultsOf([&] { readForeignTable(file_); }),
              file + ": is not a MATLAB file that tread can read (neither version 4, 5 nor 7.3)");
    std::size_t dims[2] = {1, 5};
    char words[] = "hello";
    write({Mat_VarCreate("words", MAT_C_CHAR, MAT_T_UINT8, 2, dims, words, 0)});
    EXPECT_EQ(faultsOf([&] { readForeignTable(file_); }).find(file + ": holds no real numeric array"), 0u);
    fs::remove(file_);
    EXPECT_THROW(readForeignTable(file_), FileError);
}

// Objects (texts, tables, times) have no sizes: their name follows the flags.
TEST_F(Mat, AnObjectIsSkipped) {
    using Mat5 = fuzz::MatWriter;
    const std::string short_name = Mat5::word(3u << 16 | Mat5::kInt8) + std::string("tab\0", 4),
                      long_name = Mat5::element(Mat5::kInt8, "a_long_name"),
                      system = Mat5::word(4u << 16 | Mat5::kInt8) + "MCOS", kind = Mat5::element(Mat5::kInt8, "table"),
                      flags = Mat5::element(Mat5::kUint32, Mat5::word(17) + Mat5::word(0));
    for (const std::string& name : {short_name, long_name}) {
        write({column("v", {1, 2})});
        rewrite(bytes() + Mat5::element(Mat5::kMatrix, flags + name + system + kind));
        const ForeignTable table = readForeignTable(file_);
        ASSERT_EQ(table.columns.size(), 1u);
        EXPECT_EQ(table.columns[0].values, (std::vector<double>{1, 2}));
    }
}

TEST_F(Mat, AVersionThatDoesNotExistIsRefused) {
    write({column("v", {1, 2})});
    std::string changed = bytes();
    changed[124] = 7;
    rewrite(changed);
    EXPECT_EQ(faultsOf([&] { readForeignTable(file_); }),
              file_.string() + ": is not a MATLAB file that tread can read (neither version 4, 5 nor 7.3)");
}

// Cut off at any byte: whole variables, or a fault, never a crash; and never numbers that the file has not.
TEST_F(Mat, CutOffAnywhereItIsRefusedOrGivesWholeVariables) {
    for (const auto& [version, compression] :
         {std::pair(MAT_FT_MAT5, MAT_COMPRESSION_NONE), std::pair(MAT_FT_MAT5, MAT_COMPRESSION_ZLIB),
          std::pair(MAT_FT_MAT4, MAT_COMPRESSION_NONE)}) {
        write({column("t", {0, 1, 2, 3}), column("v", {10, 11, 12, 13})}, version, compression);
        const std::string whole = bytes();
        std::size_t refused = 0;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            rewrite(whole.substr(0, length));
            try {
                const ForeignTable table = readForeignTable(file_);
                for (const ForeignColumn& column : table.columns) {
                    ASSERT_EQ(column.values.size(), 4u) << length;
                    const double first = column.name == "t" ? 0 : 10;
                    for (std::size_t i = 0; i < 4; ++i) {
                        EXPECT_EQ(column.values[i], first + static_cast<double>(i)) << column.name << " at " << length;
                    }
                }
            } catch (const LoadError&) {
                ++refused;
            }
        }
        // Only between two variables is a cut no fault.
        EXPECT_EQ(refused, whole.size() - 1);
    }
}

}  // namespace
}  // namespace tread::import_mat_test
