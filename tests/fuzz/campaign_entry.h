// What the fuzzer and the tests do with the files of a campaign: its task, and a piece of its results.
#pragma once

#include <string>
#include <string_view>

#include "campaign/campaign_file.h"
#include "campaign/piece.h"
#include "campaign/row.h"
#include "fuzz/demand.h"
#include "fuzz/yaml_entry.h"
#include "store/sha256.h"

namespace tread::fuzz {

inline bool readHostileCampaign(std::string_view text) {
    return readAs<campaign::CampaignFile>(text);
}

inline campaign::Plan planOfTwoRuns() {
    campaign::Plan plan;
    plan.runs = plan.runs_per_piece = 2;
    plan.hash = sha256("");
    return plan;
}

inline bool readHostileWholePiece(const campaign::Plan& plan, std::string_view text) {
    campaign::Piece piece;
    std::string fault;
    if (!campaign::readPiece(plan, 0, text, piece, fault)) {
        demand(!fault.empty());
        return false;
    }
    const auto rows = campaign::linesIn(piece.rows);
    demand(rows.size() == 2);
    for (const std::string_view row : rows) demand(campaign::cellsOf(row).size() == campaign::kFixedColumns);
    return true;
}

// The text as it is, and as the rows of a piece whose checksum fits.
inline bool readHostilePiece(std::string_view text) {
    static const campaign::Plan plan = planOfTwoRuns();
    const bool bare = readHostileWholePiece(plan, text);
    const bool inside = readHostileWholePiece(plan, campaign::pieceText(plan, 0, {std::string(text), ""}));
    return bare || inside;
}

}  // namespace tread::fuzz
