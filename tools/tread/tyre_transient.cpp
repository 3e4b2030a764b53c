#include "tyre_transient.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/fields/numbers.h"
#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "output_table.h"
#include "tread/problem.h"
#include "tyre_table.h"

namespace tread::program {
namespace {

// Relative difference up to which two intervals of a table count as equal.
constexpr double kEqualSampling = 1e-6;

TransientRow rowOf(const TyreState& state, const TyreForces& forces) {
    return {.u = state.u,
            .v = state.v,
            .du = state.du,
            .dv = state.dv,
            .Fx = forces.Fx,
            .Fy = forces.Fy,
            .Mx = forces.Mx,
            .My = forces.My,
            .Mz = forces.Mz};
}

// Interval between the rows, which must be constant.
double samplingInterval(const InputTable& table) {
    const auto time_column = std::find_if(table.columns.begin(), table.columns.end(),
                                          [](const TableColumn& column) { return column.kind == 0; });
    const auto column = static_cast<std::size_t>(time_column - table.columns.begin());
    const auto time = [&](std::size_t row) { return table.si(row, column); };
    if (table.rows() < 2) return 0;
    const double first = time(1) - time(0);
    for (std::size_t row = 1; row < table.rows(); ++row) {
        const auto fail = [&](std::string text) {
            throw LoadError({{table.file, table.lines[row], table.place(row, column), "t", std::move(text)}});
        };
        const double interval = time(row) - time(row - 1);
        if (!(interval > 0)) {
            fail(concat({"found ", numberText(table.given(row, column)), " after ",
                         numberText(table.given(row - 1, column)), ", expected a time that increases"}));
        }
        if (std::abs(interval - first) > kEqualSampling * first) {
            fail(concat({"found an interval of ", numberText(interval), " s after intervals of ", numberText(first),
                         " s, expected a fixed sampling interval; resample the table"}));
        }
    }
    return (time(table.rows() - 1) - time(0)) / static_cast<double>(table.rows() - 1);
}

// Advances the contact patch from one row to the next.
class Interval {
public:
    Interval(const TyreParams& tyre, const TransientOptions& options, double length)
        : tyre_(tyre), options_(options), step_(length / options.substeps) {}

    void advancePatch(TyreState& state, const TyreMotion& begin, const TyreMotion& next) {
        from_ = begin;
        to_ = options_.linear ? next : begin;
        at_ = from_;
        for (int i = 1; i <= options_.substeps; ++i) {
            const TyreMotion start = at_;
            const double share = static_cast<double>(i) / options_.substeps;
            for (std::size_t j = 0; j < at_numbers_.size(); ++j) {
                const double a = *from_numbers_[j].value, b = *to_numbers_[j].value;
                *at_numbers_[j].value = a + share * (b - a);
            }
            advance(state, tyre_, start, at_, step_, options_.standstill);
        }
    }

private:
    const TyreParams& tyre_;
    const TransientOptions& options_;
    double step_;
    TyreMotion from_, to_, at_;
    std::vector<Number> from_numbers_ = numbers(from_), to_numbers_ = numbers(to_), at_numbers_ = numbers(at_);
};

}  // namespace

std::size_t writeTransientTable(const TyreParams& tyre, const Path& input, const TransientOptions& options,
                                const std::string& output) {
    double t = 0;
    TyreMotion motion;
    Columns inputs;
    inputs.add({"t", About{"s", "time"}}, t);
    addFields(inputs, motion, options.axes);
    const InputTable table = readTable(input, inputs.kinds);
    const double interval = samplingInterval(table);

    TransientRow result;
    Columns results;
    addFields(results, result, options.axes);

    OutputTable out(output, table, results);
    Interval between(tyre, options, interval);
    TyreState state;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const TyreMotion before = motion;
        fill(inputs, table, row);
        if (row > 0) between.advancePatch(state, before, motion);
        result = rowOf(state, rimForces(state, tyre, motion, options.standstill));
        out.write(row);
    }
    out.finish();
    return table.rows();
}

}  // namespace tread::program
