#include "output_table.h"

#include <string>

#include "base/text/concat.h"
#include "base/text/number_text.h"

namespace tread::program {

OutputTable::OutputTable(const Path& path, const InputTable& input, const Columns& added)
    : file_(path), input_(input), added_(added) {
    std::string header;
    for (const TableColumn& column : input.columns) header += (header.empty() ? "" : ",") + column.header;
    for (const ColumnKind& kind : added.kinds) {
        header += concat({",", kind.name});
        if (input.has_units) header += concat({" [", kind.about.unit, "]"});
    }
    file_.write(header + "\n");
}

void OutputTable::write(std::size_t input_row) {
    std::string row;
    const auto add = [&](double value) {
        if (!row.empty()) row += ',';
        appendNumber(row, value);
    };
    for (std::size_t column = 0; column < input_.columns.size(); ++column) add(input_.given(input_row, column));
    for (const auto& [value, sign] : added_.variables) add(sign * *value + 0.0);  // never -0
    file_.write(row + "\n");
}

}  // namespace tread::program
