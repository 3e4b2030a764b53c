// What a campaign computes with: samples, plans, pieces, shares of variance. The runs themselves are a two-line model.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "campaign/correlated.h"
#include "campaign/draws.h"
#include "campaign/folder.h"
#include "campaign/piece.h"
#include "campaign/plan.h"
#include "campaign/row.h"
#include "campaign/sensitivity.h"
#include "places/places.h"
#include "scenario/load.h"
#include "shared/scratch.h"
#include "tread/load.h"
#include "tread/problem.h"

namespace tread::campaign::campaign_test {
namespace {

// ---- Samples in the unit cube ----

TEST(CampaignSobol, EveryDimensionFillsEveryStratumOnce) {
    constexpr std::uint32_t kPoints = 1024;
    for (std::size_t dimension = 0; dimension < kSobolDimensions; ++dimension) {
        std::set<std::uint32_t> strata;
        for (std::uint32_t i = 0; i < kPoints; ++i) strata.insert(sobolPoint(i, dimension) >> 22);
        EXPECT_EQ(strata.size(), kPoints) << dimension;
    }
}

// The first two dimensions are a (0, 2)-sequence: 2^m points have one in each elementary box of area 2^-m.
TEST(CampaignSobol, FirstTwoDimensionsFillEveryElementaryBox) {
    constexpr int m = 8;
    for (int bits = 0; bits <= m; ++bits) {
        std::set<std::uint32_t> boxes;
        for (std::uint32_t i = 0; i < 1u << m; ++i) {
            const std::uint64_t x = sobolPoint(i, 0), y = sobolPoint(i, 1);
            boxes.insert(static_cast<std::uint32_t>((x >> (32 - bits)) << (m - bits) | y >> (32 - (m - bits))));
        }
        EXPECT_EQ(boxes.size(), 1u << m) << bits;
    }
}

// Integration of a smooth function in ten dimensions, all of them from the table: far closer than the 0.017 of as many
// random points.
TEST(CampaignSobol, IntegratesBetterThanChance) {
    for (std::size_t first = 0; first + 10 <= kSobolDimensions; first += 10) {
        double sum = 0;
        for (std::uint32_t i = 0; i < 4096; ++i) {
            double product = 1;
            for (std::size_t d = first; d < first + 10; ++d) product *= 1 + (sobolPoint(i, d) * 0x1p-32 - 0.5) * 0.5;
            sum += product;
        }
        EXPECT_NEAR(sum / 4096, 1, 0.002) << first;
    }
}

TEST(CampaignDraws, LatinHypercubeFillsEveryStratumOnceInItsOwnOrder) {
    constexpr std::size_t kSamples = 97;
    const Draws draws(Sampling::latin_hypercube, 5, kSamples, 3);
    std::set<std::vector<std::size_t>> orders;
    for (std::size_t d = 0; d < 3; ++d) {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < kSamples; ++i) order.push_back(static_cast<std::size_t>(draws.at(i, d) * kSamples));
        orders.insert(order);
        std::sort(order.begin(), order.end());
        for (std::size_t i = 0; i < kSamples; ++i) EXPECT_EQ(order[i], i);
    }
    EXPECT_EQ(orders.size(), 3u);
}

TEST(CampaignDraws, AreThoseOfTheSeed) {
    for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
        const Draws draws(sampling, 5, 10, 2), again(sampling, 5, 10, 2), other(sampling, 6, 10, 2);
        EXPECT_EQ(draws.at(7, 1), again.at(7, 1));
        EXPECT_NE(draws.at(7, 1), other.at(7, 1));
    }
}

TEST(CampaignDraws, QuantileIsTheInverseOfTheShare) {
    for (const double z : {-30.0, -8.0, -3.0, -0.1, 0.0, 0.7, 2.5, 7.0})
        EXPECT_NEAR(normalQuantile(normalShare(z)), z, z < 5 ? 1e-9 * std::max(1.0, std::abs(z)) : 1e-4);
    EXPECT_NEAR(normalQuantile(0.975), 1.959963984540054, 1e-12);
}

// ---- Covariances ----

TEST(CampaignCorrelated, RootSquaredIsTheCovariance) {
    const std::vector<std::vector<double>> covariance{{4, 1.2, 0}, {1.2, 9, -2}, {0, -2, 1}};
    std::string fault;
    const auto root = rootOf(covariance, fault);
    ASSERT_EQ(fault, "");
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            double product = 0;
            for (std::size_t k = 0; k < 3; ++k) product += root[i][k] * root[j][k];
            EXPECT_NEAR(product, covariance[i][j], 1e-12);
        }
    }
}

std::string faultOfCovariance(const std::vector<std::vector<double>>& covariance) {
    std::string fault;
    rootOf(covariance, fault);
    return fault;
}

TEST(CampaignCorrelated, WhatIsNoCovarianceIsNamed) {
    EXPECT_NE(faultOfCovariance({{1, 0.5}, {0.4, 1}}).find("symmetric"), std::string::npos);
    EXPECT_NE(faultOfCovariance({{1, 0}, {0, -1}}).find("negative variance -1 in row 2"), std::string::npos);
    EXPECT_NE(faultOfCovariance({{1, 2}, {2, 1}}).find("correlation beyond 1"), std::string::npos);
    EXPECT_NE(faultOfCovariance({{1, 0.9, -0.9}, {0.9, 1, 0.9}, {-0.9, 0.9, 1}}).find("contradict each other"),
              std::string::npos);
    EXPECT_EQ(faultOfCovariance({{1, 1}, {1, 1}}), "") << "numbers that are the same one";
}

TEST(CampaignCorrelated, IdentifiedNumbersHaveTheirErrorsAndCorrelation) {
    const Scratch scratch;
    Correlated group;
    group.identified = scratch.file("identify.json",
                                    R"({"paths": ["mass", "load.x"], "correlation": [[1, 0.5], [0.5, 1]],
            "numbers": {"load.x": {"value": 0.2, "sd": 0.1}, "mass": {"value": 1400, "sd": 20}}})");
    const JointNormal joint = jointNormal(group);
    EXPECT_EQ(joint.paths, (std::vector<std::string>{"mass", "load.x"}));
    EXPECT_EQ(joint.mean, (std::vector<double>{1400, 0.2}));
    EXPECT_DOUBLE_EQ(joint.covariance[0][0], 400);
    EXPECT_DOUBLE_EQ(joint.covariance[0][1], 1);
    group.identified = scratch.file("other.json", "{}");
    EXPECT_THROW(jointNormal(group), LoadError);
}

// ---- Plans ----

CampaignInputs inputs() {
    CampaignInputs all;
    all.campaign.vehicles = {"compact", "rear_drive_sedan"};
    all.campaign.scenarios = {"step_steer_80"};
    for (const std::string& name : all.campaign.vehicles)
        all.vehicles.push_back({name, loadVehicle(sourceFile("vehicles/" + name + ".yaml"))});
    all.scenarios.push_back({"step_steer_80", loadScenario(sourceFile("scenarios/step_steer_80.yaml"))});
    return all;
}

Plan planWith(const CampaignFile& file) {
    CampaignInputs all = inputs();
    CampaignFile campaign = file;
    campaign.vehicles = all.campaign.vehicles;
    campaign.scenarios = all.campaign.scenarios;
    all.campaign = campaign;
    return planOf(all, {{{"response", "Response time", "s", ""}}}, "campaign.yaml");
}

std::string faultOfPlan(const CampaignFile& file) {
    try {
        planWith(file);
    } catch (const LoadError& error) {
        return error.what();
    }
    return "";
}

Factor factorOf(const std::string& path) {
    Factor factor;
    factor.path = path;
    return factor;
}

Factor listOf(const std::string& path, const std::vector<std::string>& list) {
    Factor factor = factorOf(path);
    factor.list = list;
    return factor;
}

Factor uniformOf(const std::string& path, const std::string& from, const std::string& to) {
    Factor factor = factorOf(path);
    factor.uniform = Uniform{from, to};
    return factor;
}

TEST(CampaignPlan, CombinesListedValuesAndRepeatsSamplesAtEach) {
    CampaignFile file;
    file.samples = 3;
    file.factors = {listOf("load.mass", {"0", "100 kg"}), uniformOf("scenario.start.speed", "60 km/h", "90 km/h")};
    file.factors.push_back(factorOf("front.tyre.lambda.mux"));
    file.factors.back().grid = Grid{"0.5", "1.5", 3};
    const Plan plan = planWith(file);
    ASSERT_EQ(plan.runs, 2u * 2 * 3 * 3);
    std::set<std::vector<double>> points;
    for (RunNumber run = 0; run < plan.runs; ++run) {
        const PlannedRun planned = plannedRun(plan, run);
        const Subject subject = subjectOf(plan, planned);
        EXPECT_EQ(subject.vehicle.load.mass, planned.values[0]);
        EXPECT_EQ(subject.scenario.start.speed, planned.values[1]);
        EXPECT_EQ(subject.vehicle.front.tyre.lambda.mux, planned.values[2]);
        EXPECT_EQ(planned.values[1], plannedRun(plan, run % 3).values[1]) << "the same samples everywhere";
        points.insert({static_cast<double>(planned.cell), planned.values[0], planned.values[1], planned.values[2]});
    }
    EXPECT_EQ(points.size(), plan.runs);
    EXPECT_EQ(plannedRun(plan, 0).values[2], 0.5);
    EXPECT_EQ(plannedRun(plan, plan.runs - 1).values[2], 1.5);
}

TEST(CampaignPlan, ConditionRestrictsAFactor) {
    CampaignFile file;
    file.factors = {listOf("load.mass", {"0", "100 kg", "200 kg"})};
    file.factors[0].when.vehicles = {"rear_drive_sedan"};
    const Plan plan = planWith(file);
    EXPECT_EQ(plan.runs, 1u + 3);
    EXPECT_TRUE(std::isnan(plannedRun(plan, 0).values[0]));
    EXPECT_EQ(plannedRun(plan, 3).values[0], 200);
}

TEST(CampaignPlan, RelativeValuesMultiplyWhatEachCarHas) {
    CampaignFile file;
    file.factors = {listOf("front.suspension.spring", {"1.1"})};
    file.factors[0].relative = true;
    file.factors[0].also = {"rear.suspension.spring"};
    const Plan plan = planWith(file);
    for (const RunNumber run : {0u, 1u}) {
        const Subject subject = subjectOf(plan, plannedRun(plan, run));
        const VehicleParams& nominal = plan.cells[run].nominal.vehicle;
        EXPECT_DOUBLE_EQ(subject.vehicle.front.suspension.spring, 1.1 * nominal.front.suspension.spring);
        EXPECT_DOUBLE_EQ(subject.vehicle.rear.suspension.spring, 1.1 * nominal.rear.suspension.spring);
    }
}

TEST(CampaignPlan, CorrelatedNumbersHaveTheirCovariance) {
    CampaignFile file;
    file.sampling = Sampling::sobol;
    file.samples = 4096;
    file.correlated = {{{"mass", "load.x"}, {1350, 0.2}, {{400, 3}, {3, 0.04}}, "", {}}};
    const Plan plan = planWith(file);
    std::array<double, 2> sum{};
    std::array<double, 3> squares{};
    for (RunNumber run = 0; run < 4096; ++run) {
        const std::vector<double> v = plannedRun(plan, run).values;
        const double a = v[0] - 1350, b = v[1] - 0.2;
        sum[0] += a / 4096, sum[1] += b / 4096;
        squares[0] += a * a / 4096, squares[1] += a * b / 4096, squares[2] += b * b / 4096;
    }
    EXPECT_NEAR(sum[0], 0, 0.05);
    EXPECT_NEAR(sum[1], 0, 0.001);
    EXPECT_NEAR(squares[0], 400, 4);
    EXPECT_NEAR(squares[1], 3, 0.05);
    EXPECT_NEAR(squares[2], 0.04, 0.0004);
}

TEST(CampaignPlan, NormalIsCutOff) {
    CampaignFile file;
    file.samples = 200;
    file.factors = {factorOf("load.mass")};
    file.factors[0].normal = Normal{"100 kg", "50 kg", "80 kg", "150 kg"};
    const Plan plan = planWith(file);
    double low = 1e9, high = -1e9;
    for (RunNumber run = 0; run < 200; ++run) {
        low = std::min(low, plannedRun(plan, run).values[0]);
        high = std::max(high, plannedRun(plan, run).values[0]);
    }
    EXPECT_GE(low, 80);
    EXPECT_LT(low, 81);
    EXPECT_LE(high, 150);
    EXPECT_GT(high, 149);
}

// A row of B differs from A in all columns, the others in one.
TEST(CampaignPlan, IndicesHaveTheirDesign) {
    CampaignFile file;
    file.sampling = Sampling::sobol_indices;
    file.samples = 4;
    file.factors = {uniformOf("load.mass", "0", "100"), uniformOf("load.x", "-1", "1"), uniformOf("load.y", "-1", "1")};
    const Plan plan = planWith(file);
    ASSERT_EQ(plan.runs, 2u * 4 * 5);
    const auto at = [&](RunNumber run) { return plannedRun(plan, run).values; };
    for (RunNumber block = 0; block < 8; ++block) {
        const auto a = at(5 * block), b = at(5 * block + 1);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto mixed = at(5 * block + 2 + i);
            for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(mixed[j], j == i ? b[j] : a[j]);
            EXPECT_NE(a[i], b[i]);
        }
    }
}

TEST(CampaignPlan, RepetitionsDifferInTheirSeeds) {
    CampaignFile file;
    file.repetitions = 2;
    const Plan plan = planWith(file);
    EXPECT_EQ(plan.runs, 4u);
    EXPECT_NE(subjectOf(plan, plannedRun(plan, 0)).scenario.road.roughness.seed,
              subjectOf(plan, plannedRun(plan, 1)).scenario.road.roughness.seed);
}

TEST(CampaignPlan, FaultsAreNamed) {
    const auto expectFault = [](const CampaignFile& file, const std::string& words) {
        const std::string fault = faultOfPlan(file);
        EXPECT_NE(fault.find(words), std::string::npos) << fault;
    };
    CampaignFile file;
    file.factors = {listOf("front.suspension.sprong", {"1"})};
    expectFault(file, "did you mean \"front.suspension.spring\"?");
    file.factors = {listOf("load.mass", {"1"}), listOf("load.mass", {"2"})};
    expectFault(file, "found \"load.mass\" here and in factors.0, expected each path in one factor only");
    file.factors = {listOf("mass", {"-5 kg"})};
    expectFault(file, "mass becomes -5, expected a value above 0");
    file.factors = {listOf("mass", {"5 m"})};
    expectFault(file, "expected kg; correct the unit");
    file.factors = {uniformOf("load.mass", "5", "5")};
    expectFault(file, "expected from < to");
    file.factors = {uniformOf("brakes.anti_lock.enabled", "0", "1")};
    expectFault(file, "which is no number, expected list");
    file.factors = {listOf("load.mass", {"1"})};
    file.factors[0].when.vehicles = {"compct"};
    expectFault(file, "did you mean \"compact\"?");
    file.factors = {};
    file.samples = 5;
    expectFault(file, "found 5 samples, but no factor is drawn");
    file.sampling = Sampling::sobol_indices;
    file.correlated = {{{"mass"}, {}, {{400}}, "", {}}};
    expectFault(file, "independent factors only");
}

// ---- Rows and pieces ----

TEST(CampaignRow, CellsComeBack) {
    const std::vector<std::string> cells{"1", "a,b", "say \"no\"", "", "1.5"};
    std::string line = csvLine(cells);
    EXPECT_EQ(line, "1,\"a,b\",\"say \"\"no\"\"\",,1.5\n");
    line.pop_back();
    EXPECT_EQ(cellsOf(line), cells);
}

TEST(CampaignPiece, DamageIsNoticed) {
    CampaignFile file;
    const Plan plan = planWith(file);
    ASSERT_EQ(plan.pieces(), 1u);
    std::vector<std::string> cells(columnNames(plan).size());
    cells[5] = "a message";
    const Piece piece{csvLine(cells) + csvLine(cells), "0,0.1\n1,0.2\n"};
    const std::string text = pieceText(plan, 0, piece);
    Piece read;
    std::string fault;
    ASSERT_TRUE(readPiece(plan, 0, text, read, fault)) << fault;
    EXPECT_EQ(read.rows, piece.rows);
    EXPECT_EQ(read.timings, piece.timings);
    for (std::size_t i = 0; i < text.size(); i += 7) {
        std::string damaged = text;
        damaged[i] = static_cast<char>(damaged[i] ^ 1);
        EXPECT_FALSE(readPiece(plan, 0, damaged, read, fault)) << i;
        EXPECT_FALSE(readPiece(plan, 0, text.substr(0, i), read, fault)) << i;
    }
}

TEST(CampaignFolder, DifferenceIsTold) {
    EXPECT_EQ(firstDifference("a: 1\nb:\n  c: 2\n", "a: 1\nb:\n  c: 3\n"),
              "in b it has \"c: 2\" in line 3, this one has \"c: 3\"");
    EXPECT_EQ(firstDifference("a: 1\n", "a: 1\n"), "");
}

// ---- Shares of variance, against closed forms ----

// Ishigami & Homma 1990, on the unit cube.
double ishigami(double x, double y, double z) {
    const auto angle = [](double share) { return std::numbers::pi * (2 * share - 1); };
    return std::sin(angle(x)) + 7 * std::pow(std::sin(angle(y)), 2) + 0.1 * std::pow(angle(z), 4) * std::sin(angle(x));
}
constexpr std::array kFirst{0.3139, 0.4424, 0.0};
constexpr std::array kTotal{0.5576, 0.4424, 0.2437};

TEST(CampaignSensitivity, SobolIndicesOfIshigami) {
    constexpr std::size_t kSamples = 2048;
    const Draws draws(Sampling::sobol_indices, 3, kSamples, 3);
    std::vector<double> values;
    for (std::size_t i = 0; i < kSamples; ++i) {
        std::array<double, 3> a{}, b{};
        for (std::size_t d = 0; d < 3; ++d) a[d] = draws.at(i, d), b[d] = draws.at(i, 3 + d);
        values.push_back(1000 + ishigami(a[0], a[1], a[2]));
        values.push_back(1000 + ishigami(b[0], b[1], b[2]));
        for (std::size_t d = 0; d < 3; ++d) {
            std::array<double, 3> mixed = a;
            mixed[d] = b[d];
            values.push_back(1000 + ishigami(mixed[0], mixed[1], mixed[2]));
        }
    }
    const auto indices = sobolIndices(values, 3);
    for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(indices[d].first.value, kFirst[d], 0.02) << d;
        EXPECT_NEAR(indices[d].total.value, kTotal[d], 0.02) << d;
        EXPECT_LE(indices[d].first.low, kFirst[d]);
        EXPECT_GE(indices[d].first.high, kFirst[d]);
        EXPECT_LE(indices[d].total.low, kTotal[d]);
        EXPECT_GE(indices[d].total.high, kTotal[d]);
        EXPECT_LT(indices[d].total.high - indices[d].total.low, 0.15);
    }
}

TEST(CampaignSensitivity, MainEffectsOfIshigami) {
    constexpr std::size_t kSamples = 4000;
    const Draws draws(Sampling::latin_hypercube, 3, kSamples, 3);
    std::array<std::vector<double>, 3> factors;
    std::vector<double> values;
    for (std::size_t i = 0; i < kSamples; ++i) {
        for (std::size_t d = 0; d < 3; ++d) factors[d].push_back(draws.at(i, d));
        values.push_back(ishigami(factors[0][i], factors[1][i], factors[2][i]));
    }
    for (std::size_t d = 0; d < 3; ++d) {
        const Share share = mainEffect(factors[d], values, Values::drawn);
        EXPECT_NEAR(share.value, kFirst[d], 0.03) << d;
        EXPECT_LT(share.low, share.high);
    }
}

// The same twenty samples in each of ten cars: each factor has as many values as there are samples.
TEST(CampaignSensitivity, FactorsDrawnTogetherAreToldApart) {
    const Draws draws(Sampling::latin_hypercube, 4, 20, 2);
    std::vector<double> cause, bystander, values;
    for (std::size_t i = 0; i < 200; ++i) {
        cause.push_back(draws.at(i % 20, 0));
        bystander.push_back(draws.at(i % 20, 1));
        values.push_back(cause.back());
    }
    EXPECT_GT(mainEffect(cause, values, Values::drawn).value, 0.9);
    EXPECT_LT(mainEffect(bystander, values, Values::drawn).value, 0.4);
}

TEST(CampaignSensitivity, WhatDoesNotVaryHasNoShares) {
    const std::vector<double> same(50, 0.1), factor(50, 1);
    EXPECT_TRUE(std::isnan(mainEffect(factor, same, Values::listed).value));
    EXPECT_TRUE(std::isnan(sobolIndices(same, 3).front().total.value));
}

}  // namespace
}  // namespace tread::campaign::campaign_test
