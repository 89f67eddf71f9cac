#include "core/tracking/association.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace echotrail {
namespace {

AssociationProblem randomProblem(std::size_t tracks, std::size_t regions, RandomStream& random) {
    AssociationProblem problem;
    for (std::size_t t = 0; t < tracks; ++t) {
        problem.miss.push_back(0.05 + 0.5 * random.uniform());
        auto& row = problem.weight.emplace_back();
        for (std::size_t j = 0; j < regions; ++j) row.push_back(random.uniform() < 0.3 ? 0.0 : 3 * random.uniform());
    }
    return problem;
}

/// Every choice of region or none per track, counted with base (regions + 1), the clashing ones left out.
Association bruteForce(const AssociationProblem& problem) {
    const std::size_t tracks = problem.miss.size(), regions = problem.weight.front().size();
    Association sums{std::vector(tracks, std::vector(regions, 0.0)), std::vector(tracks, 0.0)};
    double total = 0;
    std::size_t events = 1;
    for (std::size_t t = 0; t < tracks; ++t) events *= regions + 1;
    for (std::size_t code = 0; code < events; ++code) {
        std::vector<std::size_t> choice;
        for (std::size_t t = 0, rest = code; t < tracks; ++t, rest /= regions + 1)
            choice.push_back(rest % (regions + 1));
        double weight = 1;
        for (std::size_t t = 0; t < tracks; ++t) {
            weight *= choice[t] == regions ? problem.miss[t] : problem.weight[t][choice[t]];
            for (std::size_t s = 0; s < t; ++s)
                if (choice[s] == choice[t] && choice[t] != regions) weight = 0;
        }
        total += weight;
        for (std::size_t t = 0; t < tracks; ++t)
            (choice[t] == regions ? sums.none[t] : sums.probability[t][choice[t]]) += weight;
    }
    for (auto& value : sums.none) value /= total;
    for (auto& row : sums.probability)
        for (auto& value : row) value /= total;
    return sums;
}

TEST(Association, EqualsBruteForce) {
    RandomStream random(3, 0, 0);
    for (int trial = 0; trial < 50; ++trial) {
        const auto problem = randomProblem(1 + trial % 4, 1 + trial % 5, random);
        const Association found = associate(problem), expected = bruteForce(problem);
        for (std::size_t t = 0; t < problem.miss.size(); ++t) {
            EXPECT_NEAR(found.none[t], expected.none[t], 1e-12);
            for (std::size_t j = 0; j < problem.weight[t].size(); ++j)
                EXPECT_NEAR(found.probability[t][j], expected.probability[t][j], 1e-12);
        }
    }
}

TEST(Association, TwoTracksDoNotShareOneEcho) {
    const AssociationProblem problem{{{10.0}, {5.0}}, {0.1, 0.1}};
    const Association joint = associate(problem), alone = associateAlone(problem);
    EXPECT_LE(joint.probability[0][0] + joint.probability[1][0], 1.0 + 1e-12);
    EXPECT_GT(alone.probability[0][0] + alone.probability[1][0], 1.9);
}

TEST(Association, LargeClusterStillPairsEachTrackWithItsOwn) {
    AssociationProblem problem;
    for (std::size_t t = 0; t < 7; ++t) {
        problem.miss.push_back(0.1);
        problem.weight.push_back(std::vector<double>(7, 0.5));
        problem.weight.back()[6 - t] = 50.0;
    }
    const Association found = associate(problem);
    for (std::size_t t = 0; t < 7; ++t) {
        EXPECT_GT(found.probability[t][6 - t], 0.9);
        EXPECT_NEAR(std::accumulate(found.probability[t].begin(), found.probability[t].end(), found.none[t]), 1, 1e-12);
    }
}

TEST(Association, TiesTooWeakToMatterDoNotMakeItAllOrNothing) {
    constexpr std::size_t tracks = 12;
    AssociationProblem problem{std::vector(tracks, std::vector(tracks, 1e-6)), std::vector(tracks, 0.1)};
    for (std::size_t t = 1; t < tracks; ++t) problem.weight[t][t] = 50.0;
    problem.weight[0][0] = 10.0;
    problem.weight[1] = problem.weight[0];
    problem.weight[1][0] = 9.0;  // the first two claim the same region, the others have one each
    const Association joint = associate(problem), pair = associate({{{10.0}, {9.0}}, {0.1, 0.1}});
    EXPECT_NEAR(joint.probability[0][0], pair.probability[0][0], 1e-12);
    EXPECT_NEAR(joint.probability[1][0], pair.probability[1][0], 1e-12);
    EXPECT_GT(joint.probability[2][2], 0.99);
}

TEST(Association, TrackWithoutRegionsIsAMiss) {
    EXPECT_EQ(associate({{{}}, {0.1}}).none[0], 1.0);
    EXPECT_EQ(associate({{{0.0}}, {0.0}}).none[0], 1.0);
}

TEST(LeastCostAssignment, EqualsTryingEveryPermutation) {
    RandomStream random(4, 0, 0);
    for (int trial = 0; trial < 40; ++trial) {
        const std::size_t rows = 1 + trial % 4, columns = rows + trial % 3;
        std::vector cost(rows, std::vector<double>(columns));
        for (auto& row : cost)
            for (auto& value : row) value = 10 * random.uniform() - 3;
        std::vector<std::size_t> order(columns);
        std::iota(order.begin(), order.end(), std::size_t{0});
        double least = 1e9;
        do {
            double sum = 0;
            for (std::size_t r = 0; r < rows; ++r) sum += cost[r][order[r]];
            least = std::min(least, sum);
        } while (std::next_permutation(order.begin(), order.end()));
        const auto assigned = leastCostAssignment(cost);
        double sum = 0;
        for (std::size_t r = 0; r < rows; ++r) sum += cost[r][assigned[r]];
        EXPECT_NEAR(sum, least, 1e-9);
    }
}

}  // namespace
}  // namespace echotrail
