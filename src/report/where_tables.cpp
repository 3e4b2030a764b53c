// Where the gap lies: recordings and channels, and shares of phases, bands, regimes and forces.

#include <fmt/format.h>

#include <algorithm>

#include "diagnose/answer/diagnosis.h"
#include "report/diagnosis_tables.h"

namespace tread {
namespace {

using diagnose::answer::Shares;
using diagnose::answer::WhereItLies;

std::vector<std::pair<std::string, double>> sorted(const Shares& shares) {
    std::vector<std::pair<std::string, double>> order(shares.begin(), shares.end());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    return order;
}

// Groups of shares beside each other, each its own column: "1-3 Hz  45 %".
void addShares(HtmlPage& page, const std::vector<std::pair<const char*, const Shares*>>& groups) {
    std::vector<std::string> header;
    std::vector<std::vector<std::pair<std::string, double>>> columns;
    std::size_t rows = 0;
    for (const auto& [name, shares] : groups) {
        if (shares->empty()) continue;
        header.push_back(name);
        columns.push_back(sorted(*shares));
        rows = std::max(rows, columns.back().size());
    }
    std::vector<std::vector<Cell>> cells;
    for (std::size_t r = 0; r < std::min<std::size_t>(rows, 8); ++r) {
        std::vector<Cell> row;
        for (const auto& column : columns) {
            if (r >= column.size()) {
                row.push_back({""});
                continue;
            }
            Cell cell{shownName(column[r].first) + "  " + fmt::format("{:.0f} %", 100 * column[r].second)};
            cell.bar = column[r].second;
            row.push_back(std::move(cell));
        }
        cells.push_back(std::move(row));
    }
    page.table(header, cells);
}

void addHeatMap(HtmlPage& page, const WhereItLies& where) {
    std::vector<std::string> channels, header{"Recording"};
    for (const auto& [channel, share] : sorted(where.channels)) {
        channels.push_back(channel);
        header.push_back(shownName(channel));
    }
    double most = 0;
    for (const auto& [recording, shares] : where.channels_of_recording) {
        for (const auto& [channel, share] : shares) most = std::max(most, share);
    }
    std::vector<std::vector<Cell>> rows;
    for (const auto& [recording, total] : sorted(where.recordings)) {
        const auto found = where.channels_of_recording.find(recording);
        if (found == where.channels_of_recording.end()) continue;
        std::vector<Cell> row{{recording}};
        for (const std::string& channel : channels) {
            const auto part = found->second.find(channel);
            const double share = part == found->second.end() ? 0 : part->second;
            Cell cell{share > 0 ? fmt::format("{:.1f} %", 100 * share) : "", true};
            cell.heat = most > 0 ? share / most : 0;
            row.push_back(std::move(cell));
        }
        rows.push_back(std::move(row));
    }
    page.table(header, rows);
}

}  // namespace

void addWhere(HtmlPage& page, const WhereItLies& where) {
    page.text(
        "Shares of the squared gap of the nominal car, in units of what noise and usual disturbances cause: by "
        "recording "
        "and channel, then by driving phase, frequency, operating regime and missing force.");
    addHeatMap(page, where);
    addShares(page, {{"Phase", &where.phases},
                     {"Frequency", &where.bands},
                     {"Regime", &where.regimes},
                     {"Missing force", &where.generalised_force},
                     {"Side force at the axle", &where.axle_force}});
    page.text(
        "Missing force: the external force with which the nominal car, its numbers within their tolerances, would "
        "follow the measured motion. Side force at the axle: how the missing lateral force and yaw moment would divide "
        "between the axles.");
}

}  // namespace tread
