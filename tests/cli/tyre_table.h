// Tables as the tests of `tread tyre` write and read them, without the product's reader and writer.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/program.h"
#include "places/places.h"
#include "shared/car_205_60R15.h"

namespace tread {

inline const std::string kCarTyre = sourceFile("vehicles/tyres/car_205_60R15.yaml");

// The tyre has no overturning couple of its own; with these, every result is there to be compared.
inline const std::vector<std::string> kCouples{"--set", "parameters.qx1=2e-6", "--set", "parameters.qx2=0.03",
                                               "--set", "parameters.qy2=4e-7"};
inline TyreParams tyreWithCouples() {
    TyreParams tyre = reference::car205();
    tyre.parameters.qx1 = 2e-6;
    tyre.parameters.qx2 = 0.03;
    tyre.parameters.qy2 = 4e-7;
    return tyre;
}

struct TyreTable {
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;

    const double& at(std::size_t row, const std::string& name) const {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (names[i] == name) return rows.at(row).at(i);
        }
        throw std::runtime_error("no column " + name);
    }
    double& at(std::size_t row, const std::string& name) {
        return const_cast<double&>(static_cast<const TyreTable&>(*this).at(row, name));
    }
};

inline std::string csv(const TyreTable& table) {
    std::string text;
    for (const std::string& name : table.names) text += (text.empty() ? "" : ",") + name;
    for (const std::vector<double>& row : table.rows) {
        text += '\n';
        for (std::size_t i = 0; i < row.size(); ++i) {
            char digits[40];
            std::snprintf(digits, sizeof digits, i == 0 ? "%.17g" : ",%.17g", row[i]);
            text += digits;
        }
    }
    return text + '\n';
}

inline TyreTable parse(const std::string& text) {
    TyreTable table;
    std::istringstream lines(text);
    std::string line, cell;
    std::getline(lines, line);
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) table.names.push_back(cell);
    while (std::getline(lines, line)) {
        table.rows.emplace_back();
        for (std::istringstream cells(line); std::getline(cells, cell, ',');) {
            char* end = nullptr;
            table.rows.back().push_back(std::strtod(cell.c_str(), &end));
            if (cell.empty() || *end != '\0') throw std::runtime_error("not a number: " + cell);
        }
        if (table.rows.back().size() != table.names.size()) throw std::runtime_error("ragged row: " + line);
    }
    return table;
}

// The program's table for an input table; the option is --table or --transient.
inline TyreTable programTable(const std::string& option, const TyreTable& input, const std::vector<std::string>& more) {
    const Scratch scratch;
    std::vector<std::string> words{
        "tyre", kCarTyre, option, scratch.file("in.csv", csv(input)), "-o", scratch.path("out.csv")};
    words.insert(words.end(), kCouples.begin(), kCouples.end());
    words.insert(words.end(), more.begin(), more.end());
    const Result result = runProgram(words);
    if (result.status != 0) throw std::runtime_error(result.err);
    return parse(contentOf(scratch.path("out.csv")));
}

}  // namespace tread
