#include "tyre_steady.h"

#include "base/fields/numbers.h"
#include "output_table.h"
#include "tyre_table.h"

namespace tread::program {

std::size_t writeSteadyTable(const TyreParams& tyre, const Path& input, Axes axes, const std::string& output) {
    TyreParams scaled = tyre;
    TyreSlip slip;
    Columns inputs;
    addFields(inputs, slip, axes);
    for (const Number& n : numbers(scaled.lambda)) inputs.add({"lambda_" + n.path, n.about, false}, *n.value);
    const InputTable table = readTable(input, inputs.kinds);

    TyreSteadyState result;
    Columns results;
    addFields(results, result, axes);

    OutputTable out(output, table, results);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        fill(inputs, table, row);
        result = steadyState(scaled, slip);
        out.write(row);
    }
    out.finish();
    return table.rows();
}

}  // namespace tread::program
