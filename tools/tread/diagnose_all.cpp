#include "diagnose_all.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "base/text/number_text.h"
#include "campaign/row.h"
#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"
#include "drive.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "output.h"
#include "recording/diagnosis_folders.h"
#include "report/html.h"
#include "shared_work.h"
#include "store/described_json.h"
#include "store/result_folder.h"
#include "store/sha256.h"
#include "store/whole_file.h"
#include "terminal.h"

namespace tread::program {
namespace {

using diagnose::answer::causesInOrder;
using diagnose::answer::Diagnosis;
using diagnose::answer::effectInWords;
using diagnose::answer::isAnswered;

// One row of the table. It is kept in the folder of its diagnosis, as the last of its files.
struct Row {
    std::string name;
    std::string inputs;
    std::string failure;
    bool answered = false;
    std::string verdict;
    std::string answer;
    std::vector<std::string> causes;
    double closed = std::nan("");
    double remaining = std::nan("");

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of the folder of the diagnosis"});
        field(TREAD_FIELD(inputs), About{"", "SHA-256 of the files in it"});
        field(TREAD_FIELD(failure), About{"", "why there is no diagnosis; empty: there is one"});
        field(TREAD_FIELD(answered), About{"", "the causes are named, or there is none"});
        field(TREAD_FIELD(verdict), About{"", "verdict, as in diagnosis.json"});
        field(TREAD_FIELD(answer), About{"", "answer in words"});
        field(TREAD_FIELD(causes), About{"", "effects that are named as causes"});
        field(TREAD_FIELD(closed), About{"-", "share of the gap that the model with the causes closes"});
        field(TREAD_FIELD(remaining), About{"-", "share of the gap that remains unexplained"});
    }
};
static_assert(describesEveryMember<Row>());

std::vector<std::string> namesIn(const Path& folder) {
    std::vector<std::string> names = recording::diagnosisFolders(folder);
    if (names.empty()) {
        throw LoadError({{folder.string(), 0, 0, "",
                          "found no folder with a diagnosis.yaml in this folder, expected one for each diagnosis"}});
    }
    return names;
}

// What a diagnosis depends on: the files of its folder and the car of the command line.
std::string inputsOf(const Path& folder, const std::string& vehicle) {
    std::vector<Path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    if (!vehicle.empty()) files.emplace_back(vehicle);
    std::string hashes;
    for (const Path& file : files) hashes += file.filename().string() + " " + sha256(readBytes(file)) + "\n";
    return sha256(hashes);
}

Row rowOf(const Diagnosis& diagnosis) {
    Row row;
    row.answered = isAnswered(diagnosis);
    row.verdict = enumNames(diagnosis.verdict)[static_cast<std::size_t>(diagnosis.verdict)];
    row.answer = diagnosis.answer;
    row.causes = causesInOrder(diagnosis);
    row.closed = closedShare(diagnosis.training);
    row.remaining = diagnosis.training.remainder.share;
    return row;
}

// The diagnoses of a folder, and where their results go.
class Cases {
public:
    Cases(const DiagnoseRequest& request, Path out)
        : request_(request), out_(std::move(out)), names_(namesIn(request.all)) {}

    void useThreads(int of_each) { threads_ = of_each; }

    std::size_t count() const { return names_.size(); }

    // A diagnosis whose folder has changed since is made again.
    bool isDone(std::uint64_t i, std::string& fault) const {
        const Path file = rowFile(i);
        if (!std::filesystem::exists(file)) return false;
        Row row;
        try {
            readJson(row, nlohmann::ordered_json::parse(readBytes(file)));
        } catch (const std::exception& error) {
            fault = fmt::format("{} is damaged ({}); the diagnosis is made again", file.string(), error.what());
            return false;
        }
        return row.inputs == inputsOf(folderOf(i), request_.vehicle);
    }

    // A diagnosis that fails is a row too.
    void diagnose(std::uint64_t i) const {
        Row row;
        try {
            const DiagnosisInputs inputs = readDiagnosisInputs(folderOf(i) / "diagnosis.yaml", {}, request_.vehicle);
            if (request_.strict && !inputs.implausible.empty()) throw LoadError(inputs.implausible);
            tread::diagnose::Options options;
            options.threads = threads_;
            row = rowOf(diagnoseInto(inputs, out_ / names_[i], options));
        } catch (const FileError&) {
            throw;  // of this call, not of the diagnosis
        } catch (const std::exception& error) {
            row.failure = error.what();
        }
        row.name = names_[i];
        row.inputs = inputsOf(folderOf(i), request_.vehicle);
        makeFolder(out_ / names_[i]);
        writeFile(rowFile(i), jsonText(tread::jsonOf(row)));
    }

    // The rows, in the order of their names; none while one is missing.
    std::vector<Row> rows() const {
        std::vector<Row> all;
        for (std::uint64_t i = 0; i < count(); ++i) {
            if (!std::filesystem::exists(rowFile(i))) return {};
            readJson(all.emplace_back(), nlohmann::ordered_json::parse(readBytes(rowFile(i))));
        }
        return all;
    }

private:
    const DiagnoseRequest& request_;
    Path out_;
    int threads_ = 1;
    std::vector<std::string> names_;

    Path folderOf(std::uint64_t i) const { return Path(request_.all) / names_[i]; }
    Path rowFile(std::uint64_t i) const { return out_ / names_[i] / "row.json"; }
};

std::string cellText(const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<T, std::string>) return value;
    else if constexpr (std::is_same_v<T, bool>) return value ? "1" : "0";
    else if constexpr (std::is_same_v<T, double>) return std::isnan(value) ? "" : numberText(value);
    else return fmt::format("{}", fmt::join(value, " "));
}

std::string table(const std::vector<Row>& rows) {
    std::vector<std::string> names;
    Row::describe(rows.front(), [&](std::string_view name, const auto&, const About& about) {
        names.push_back(std::string(name) + (about.unit.empty() ? "" : fmt::format(" [{}]", about.unit)));
    });
    std::string text = campaign::csvLine(names);
    for (const Row& row : rows) {
        std::vector<std::string> cells;
        Row::describe(row,
                      [&](std::string_view, const auto& value, const About&) { cells.push_back(cellText(value)); });
        text += campaign::csvLine(cells);
    }
    return text;
}

std::string percent(double share) {
    return std::isnan(share) ? "" : fmt::format("{:.0f} %", 100 * share);
}

std::string page(const std::vector<Row>& rows, const std::string& answer) {
    HtmlPage page("Diagnoses");
    page.answer(answer);
    std::vector<std::vector<Cell>> cells;
    for (const Row& row : rows) {
        std::vector<std::string> causes;
        for (const std::string& cause : row.causes) causes.push_back(effectInWords(cause));
        const bool failed = !row.failure.empty();
        cells.push_back({{.text = row.name, .link = failed ? "" : row.name + "/report.html"},
                         {.text = failed ? "failed" : row.verdict, .alarm = failed, .good_news = row.answered},
                         {.text = fmt::format("{}", fmt::join(causes, ", "))},
                         {.text = percent(row.closed), .number = true},
                         {.text = percent(row.remaining), .number = true},
                         {.text = failed ? row.failure : row.answer}});
    }
    page.table({"Diagnosis", "Verdict", "Causes", "Gap closed", "Unexplained", "Answer"}, cells, true);
    page.links("Files", {{"diagnoses.csv", "diagnoses.csv"}});
    return page.finish();
}

std::string answerOf(const std::vector<Row>& rows) {
    const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.failure.empty(); });
    const auto answered = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.answered; });
    const std::string text =
        fmt::format("{} of {} {} answered", answered, rows.size(), rows.size() == 1 ? "diagnosis" : "diagnoses");
    return text + (failed > 0 ? fmt::format(", {} failed", failed) : "");
}

int showAll(const std::vector<Row>& rows, const Path& out, bool json) {
    const std::string answer = answerOf(rows);
    writeFile(out / "diagnoses.csv", table(rows));
    writeFile(out / "index.html", page(rows, answer));
    if (json) {
        printJson(nlohmann::json::parse(
            nlohmann::ordered_json{{"answer", answer}, {"diagnoses", tread::jsonOf(rows)}}.dump()));
    } else {
        std::string text = answer + "\n";
        for (const Row& row : rows)
            text += fmt::format("  {:<20} {}\n", row.name, row.failure.empty() ? row.answer : "failed: " + row.failure);
        say(text);
    }
    note("report: " + (out / "index.html").string());
    const auto failed = [](const Row& row) { return !row.failure.empty(); };
    if (std::any_of(rows.begin(), rows.end(), failed)) return kRunFailed;
    const bool all = std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.answered; });
    return all ? kYes : kNo;
}

}  // namespace

int diagnoseAll(const DiagnoseRequest& request) {
    expectKind(request.all, {"folder"});
    const Path out = request.output.empty() ? Path("out") : Path(request.output);
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const int threads = request.threads > 0 ? request.threads : cores;
    // Diagnoses beside each other use the cores better than the threads of one.
    Cases cases(request, out);
    const int beside = std::min(threads, static_cast<int>(cases.count()));
    cases.useThreads(threads / beside);
    makeFolder(out);
    listenToSignals();
    WorkDone done;
    {
        Progress progress(static_cast<double>(cases.count()), "diagnoses");
        const Pieces pieces{.count = cases.count(),
                            .isDone = [&](std::uint64_t i, std::string& fault) { return cases.isDone(i, fault); },
                            .compute =
                                [&](std::uint64_t i, std::uint64_t) {
                                    cases.diagnose(i);
                                    return true;
                                }};
        done = workTogether(pieces, out, workOptions(beside, request.shard, progress));
    }
    if (done.stopped) {
        note("tread diagnose: interrupted; the same call goes on");
        return stoppedStatus();
    }
    const std::vector<Row> rows = cases.rows();
    if (rows.empty()) {
        say(fmt::format("part {} is done; the call that finds all diagnoses done writes the table\n", request.shard));
        return kYes;
    }
    return showAll(rows, out, request.json);
}

}  // namespace tread::program
