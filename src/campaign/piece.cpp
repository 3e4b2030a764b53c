#include "campaign/piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "campaign/row.h"
#include "store/sha256.h"

namespace tread::campaign {
namespace {

std::string headOf(const Plan& plan, std::uint64_t number) {
    return fmt::format("tread campaign piece 1\ncampaign {}\nruns {} {}\n", plan.hash, plan.firstOf(number),
                       plan.countOf(number));
}

}  // namespace

std::string pieceText(const Plan& plan, std::uint64_t number, const Piece& piece) {
    const std::string body = piece.rows + piece.timings;
    return headOf(plan, number) + "sha256 " + sha256(body) + "\n" + body;
}

bool readPiece(const Plan& plan, std::uint64_t number, std::string_view text, Piece& piece, std::string& fault) {
    const std::string head = headOf(plan, number);
    if (!text.starts_with(head)) {
        fault = text.starts_with("tread campaign piece 1\n") ? "it belongs to another campaign" : "its head is damaged";
        return false;
    }
    text.remove_prefix(head.size());
    const std::size_t end = text.find('\n');
    const std::string_view sum = text.substr(0, std::min(end, text.size()));
    std::string_view body = end == std::string_view::npos ? "" : text.substr(end + 1);
    if (sum != "sha256 " + sha256(body)) {
        fault = "its checksum does not fit";
        return false;
    }
    std::size_t split = 0;
    for (std::uint64_t i = 0; i < plan.countOf(number) && split != std::string_view::npos; ++i) {
        split = body.find('\n', split);
        if (split != std::string_view::npos) ++split;
    }
    if (split == std::string_view::npos) {
        fault = "it lacks rows";
        return false;
    }
    piece = {std::string(body.substr(0, split)), std::string(body.substr(split))};
    const std::size_t cells = columnNames(plan).size();
    for (const std::string_view line : linesIn(piece.rows)) {
        if (cellsOf(line).size() == cells) continue;
        fault = "it has a row with another number of cells";
        return false;
    }
    return true;
}

std::vector<std::string_view> linesIn(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

}  // namespace tread::campaign
