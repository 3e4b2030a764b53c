// Runs that are computed and kept together. A piece is a text file:
//
//     tread campaign piece 1
//     campaign <SHA-256 of inputs.yaml>
//     runs <first> <count>
//     sha256 <of all that follows>
//     <count lines as in results.csv>
//     <count lines: run,seconds>
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/plan.h"

namespace tread::campaign {

struct Piece {
    std::string rows;     // lines of the table of results
    std::string timings;  // lines "run,seconds"
};

std::string pieceText(const Plan& plan, std::uint64_t number, const Piece& piece);

// Nothing, and what is wrong in `fault`, when the text is not that piece of this campaign, whole and undamaged.
bool readPiece(const Plan& plan, std::uint64_t number, std::string_view text, Piece& piece, std::string& fault);

// The lines of a text, without their ends.
std::vector<std::string_view> linesIn(std::string_view text);

}  // namespace tread::campaign
