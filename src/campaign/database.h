// results.sqlite. Tables:
//
//     results    a row per run: run (the key), vehicle, scenario, repetition, status, message, missed, then a column
//     for
//                each factor and each metric, named as in results.csv; NULL where there is no value
//     columns    name, kind ("factor" or "metric"), unit, definition: of these columns
//     campaign   key, value: title, version, hash, runs
//
// Views: runs (all but factors and metrics), factors and metrics (run and the columns of that kind).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/plan.h"
#include "store/whole_file.h"

struct sqlite3;
struct sqlite3_stmt;

namespace tread::campaign {

// A database in the making, as a whole file. The same rows give the same bytes.
class DatabaseWriter {
public:
    DatabaseWriter(const std::filesystem::path& file, const Plan& plan);  // throws FileError
    ~DatabaseWriter();
    DatabaseWriter(const DatabaseWriter&) = delete;
    DatabaseWriter& operator=(const DatabaseWriter&) = delete;

    void add(const std::vector<std::string>& cells);  // of a row of results.csv
    void finish();

private:
    std::filesystem::path name_;
    WholeFile file_;
    sqlite3* database_ = nullptr;
    sqlite3_stmt* insert_ = nullptr;
    std::vector<bool> is_text_;  // by column

    void execute(const std::string& statement);
    [[noreturn]] void fail();
    void close();
};

// Columns of the table of results, read one by one: 10^6 runs need not be in memory whole.
class DatabaseReader {
public:
    explicit DatabaseReader(const std::filesystem::path& file);  // throws FileError
    ~DatabaseReader();
    DatabaseReader(const DatabaseReader&) = delete;
    DatabaseReader& operator=(const DatabaseReader&) = delete;

    // In the order of the runs; not a number where there is none. `condition` is SQL, empty: all rows.
    std::vector<double> numbers(const std::string& column, const std::string& condition = {}) const;
    std::vector<std::string> texts(const std::string& column, const std::string& condition = {}) const;

private:
    sqlite3* database_ = nullptr;
};

// A name of a column, and a text, as SQL writes them.
std::string sqlName(std::string_view name);
std::string sqlText(std::string_view text);

}  // namespace tread::campaign
