#include "tyre_steady.h"

#include <vector>

#include "base/numbers.h"
#include "output_table.h"
#include "tyre_table.h"

namespace tread::program {

std::size_t writeSteadyTable(const TyreParams& tyre, const Path& input, Axes axes, const std::string& output) {
    TyreParams scaled = tyre;
    TyreSlip slip;
    Columns inputs;
    for (const Number& n : numbers(slip)) inputs.add({n.path, n.about}, *n.value, axisSign(n.path, axes));
    for (const Number& n : numbers(scaled.lambda)) inputs.add({"lambda_" + n.path, n.about, false}, *n.value);
    const InputTable table = readTable(input, inputs.kinds);

    TyreSteadyState result;
    Columns results;
    for (const Number& n : numbers(result)) results.add({n.path, n.about}, *n.value, axisSign(n.path, axes));

    OutputTable out(output, table, results.kinds);
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        fill(inputs, table, row);
        result = steadyState(scaled, slip);
        gather(results, values);
        out.write(row, values);
    }
    out.finish();
    return table.rows();
}

}  // namespace tread::program
