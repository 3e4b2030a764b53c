#include "campaign/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <charconv>
#include <limits>
#include <system_error>

#include "campaign/row.h"
#include "log/csv.h"

namespace tread::campaign {
namespace {

std::string doubled(std::string_view text, char quote) {
    std::string out(1, quote);
    for (const char c : text) {
        if (c == quote) out += c;
        out += c;
    }
    return out + quote;
}

std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + sqlName(name);
    return list;
}

struct Statement {
    Statement(sqlite3* from, const std::string& text) : database(from) {
        if (sqlite3_prepare_v2(database, text.c_str(), -1, &handle, nullptr) != SQLITE_OK) fail();
    }
    ~Statement() { sqlite3_finalize(handle); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;
    bool hasRow() const {
        const int step = sqlite3_step(handle);
        if (step != SQLITE_ROW && step != SQLITE_DONE) fail();
        return step == SQLITE_ROW;
    }
    [[noreturn]] void fail() const {
        throw FileError(fmt::format("cannot read the results: {}", sqlite3_errmsg(database)));
    }

    sqlite3* database;
    sqlite3_stmt* handle = nullptr;
};

std::string selectOf(const std::string& column, const std::string& condition) {
    return "SELECT " + sqlName(column) + " FROM results" + (condition.empty() ? "" : " WHERE " + condition) +
           " ORDER BY run";
}

}  // namespace

std::string sqlName(std::string_view name) {
    return doubled(name, '"');
}

std::string sqlText(std::string_view text) {
    return doubled(text, '\'');
}

DatabaseWriter::DatabaseWriter(const std::filesystem::path& file, const Plan& plan) : name_(file), file_(file) {
    // Nobody else writes to it, so it needs no locks.
    if (sqlite3_open_v2(file_.part().c_str(), &database_, SQLITE_OPEN_READWRITE, "unix-none") != SQLITE_OK) fail();
    // The file is new and gets its name only when it is whole: a journal would guard nothing.
    execute("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA page_size = 4096; PRAGMA encoding = 'UTF-8'");
    execute("BEGIN");
    const std::vector<std::string> names = columnNames(plan);
    const std::vector<std::string> fixed(names.begin(), names.begin() + kFixedColumns);
    std::vector<std::string> factors{"run"}, metrics{"run"};
    std::string columns = "run INTEGER PRIMARY KEY";
    is_text_ = {false, true, true, false, true, true, true};
    for (std::size_t i = 1; i < kFixedColumns; ++i)
        columns += ", " + sqlName(names[i]) + (is_text_[i] ? " TEXT" : " INTEGER");
    std::string about;
    for (std::size_t i = kFixedColumns; i < names.size(); ++i) {
        const std::size_t factor = i - kFixedColumns;
        const bool is_factor = factor < plan.variables.size();
        is_text_.push_back(is_factor && plan.variables[factor].words);
        columns += ", " + sqlName(names[i]) + (is_text_[i] ? " TEXT" : " REAL");
        (is_factor ? factors : metrics).push_back(names[i]);
        const MetricDefinition none;
        const MetricDefinition& metric = is_factor ? none : plan.metrics[factor - plan.variables.size()];
        about += fmt::format("INSERT INTO columns VALUES ({}, {}, {}, {});", sqlText(names[i]),
                             is_factor ? "'factor'" : "'metric'",
                             sqlText(is_factor ? plan.variables[factor].unit : metric.unit),
                             sqlText(is_factor ? plan.variables[factor].meaning : metric.definition));
    }
    execute("CREATE TABLE campaign (key TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID");
    for (const auto& [key, value] :
         std::vector<std::pair<std::string, std::string>>{{"title", plan.inputs.campaign.title},
                                                          {"tread_version", plan.inputs.tread_version},
                                                          {"sha256 of inputs.yaml", plan.hash},
                                                          {"runs", std::to_string(plan.runs)}})
        execute(fmt::format("INSERT INTO campaign VALUES ({}, {})", sqlText(key), sqlText(value)));
    execute("CREATE TABLE columns (name TEXT PRIMARY KEY, kind TEXT, unit TEXT, definition TEXT) WITHOUT ROWID");
    execute(about);
    execute("CREATE TABLE results (" + columns + ")");
    execute("CREATE VIEW runs AS SELECT " + listOf(fixed) + " FROM results");
    execute("CREATE VIEW factors AS SELECT " + listOf(factors) + " FROM results");
    execute("CREATE VIEW metrics AS SELECT " + listOf(metrics) + " FROM results");
    std::string places = "?";
    for (std::size_t i = 1; i < names.size(); ++i) places += ", ?";
    if (sqlite3_prepare_v2(database_, ("INSERT INTO results VALUES (" + places + ")").c_str(), -1, &insert_, nullptr) !=
        SQLITE_OK)
        fail();
}

DatabaseWriter::~DatabaseWriter() {
    close();
}

void DatabaseWriter::add(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < is_text_.size(); ++i) {
        const std::string& cell = cells.at(i);
        const int place = static_cast<int>(i) + 1;
        double value = 0;
        if (cell.empty()) {
            sqlite3_bind_null(insert_, place);
        } else if (is_text_[i]) {
            sqlite3_bind_text(insert_, place, cell.data(), static_cast<int>(cell.size()), SQLITE_STATIC);
        } else if (std::from_chars(cell.data(), cell.data() + cell.size(), value).ec == std::errc{}) {
            if (i < kFixedColumns) sqlite3_bind_int64(insert_, place, static_cast<sqlite3_int64>(value));
            else sqlite3_bind_double(insert_, place, value);
        } else {
            sqlite3_bind_null(insert_, place);
        }
    }
    if (sqlite3_step(insert_) != SQLITE_DONE) fail();
    sqlite3_reset(insert_);
}

void DatabaseWriter::finish() {
    sqlite3_finalize(insert_);
    insert_ = nullptr;
    execute("COMMIT");
    close();
    file_.finish();
}

void DatabaseWriter::execute(const std::string& statement) {
    if (sqlite3_exec(database_, statement.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void DatabaseWriter::fail() {
    const int system = database_ ? sqlite3_system_errno(database_) : 0;
    const std::string reason = system != 0 ? std::generic_category().message(system)
                                           : std::string(database_ ? sqlite3_errmsg(database_) : "no memory");
    close();
    throw FileError(fmt::format("cannot write '{}': {}", name_.string(), reason));
}

void DatabaseWriter::close() {
    sqlite3_finalize(insert_);
    insert_ = nullptr;
    sqlite3_close(database_);
    database_ = nullptr;
}

DatabaseReader::DatabaseReader(const std::filesystem::path& file) {
    if (sqlite3_open_v2(file.c_str(), &database_, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK) return;
    const std::string reason = database_ ? sqlite3_errmsg(database_) : "no memory";
    sqlite3_close(database_);
    throw FileError(fmt::format("cannot read '{}': {}", file.string(), reason));
}

DatabaseReader::~DatabaseReader() {
    sqlite3_close(database_);
}

std::vector<double> DatabaseReader::numbers(const std::string& column, const std::string& condition) const {
    const Statement select(database_, selectOf(column, condition));
    std::vector<double> values;
    while (select.hasRow()) {
        const bool none = sqlite3_column_type(select.handle, 0) == SQLITE_NULL;
        values.push_back(none ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(select.handle, 0));
    }
    return values;
}

std::vector<std::string> DatabaseReader::texts(const std::string& column, const std::string& condition) const {
    const Statement select(database_, selectOf(column, condition));
    std::vector<std::string> values;
    while (select.hasRow()) {
        const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(select.handle, 0));
        values.emplace_back(text ? text : "");
    }
    return values;
}

}  // namespace tread::campaign
