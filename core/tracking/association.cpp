#include "core/tracking/association.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace echotrail {
namespace {

constexpr double most_events = 10'000;  // joint events that are enumerated
constexpr double negligible = 1e-3;     // of a track's alternatives: a pairing this unlikely ties no tracks together
constexpr double impossible = 1e9;      // cost of a pairing outside the gate

std::size_t regionsOf(const AssociationProblem& problem) {
    return problem.weight.empty() ? 0 : problem.weight.front().size();
}

Association zero(const AssociationProblem& problem) {
    return {std::vector(problem.weight.size(), std::vector(regionsOf(problem), 0.0)),
            std::vector(problem.weight.size(), 0.0)};
}

void normalise(Association& association) {
    for (std::size_t t = 0; t < association.none.size(); ++t) {
        double sum = association.none[t];
        for (const double p : association.probability[t]) sum += p;
        if (!(sum > 0)) {  // nothing fits: a miss for certain
            association.none[t] = sum = 1.0;
        }
        association.none[t] /= sum;
        for (double& p : association.probability[t]) p /= sum;
    }
}

/// Walks through the joint events: the tracks before `track` have chosen, `taken` regions are gone.
class Enumeration {
public:
    Enumeration(const AssociationProblem& problem, Association& sums)
        : problem_(problem), sums_(sums), choice_(problem.miss.size(), -1), taken_(regionsOf(problem), false) {}

    void run(std::size_t track = 0, double weight = 1.0) {
        if (weight <= 0) return;
        if (track == choice_.size()) {
            for (std::size_t t = 0; t < choice_.size(); ++t)
                (choice_[t] < 0 ? sums_.none[t] : sums_.probability[t][choice_[t]]) += weight;
            return;
        }
        choice_[track] = -1;
        run(track + 1, weight * problem_.miss[track]);
        for (std::size_t region = 0; region < taken_.size(); ++region) {
            if (taken_[region]) continue;
            taken_[region] = true;
            choice_[track] = static_cast<int>(region);
            run(track + 1, weight * problem_.weight[track][region]);
            taken_[region] = false;
        }
    }

private:
    const AssociationProblem& problem_;
    Association& sums_;
    std::vector<int> choice_;
    std::vector<bool> taken_;
};

Association associateBest(const AssociationProblem& problem) {
    const std::size_t tracks = problem.miss.size(), regions = regionsOf(problem);
    std::vector cost(tracks, std::vector(regions + tracks, impossible));
    for (std::size_t t = 0; t < tracks; ++t) {
        for (std::size_t j = 0; j < regions; ++j)
            if (problem.weight[t][j] > 0) cost[t][j] = -std::log(problem.weight[t][j]);
        cost[t][regions + t] = -std::log(std::max(problem.miss[t], 1e-12));  // each track has its own "none"
    }
    const std::vector<int> column = leastCostAssignment(cost);
    Association result = zero(problem);
    for (std::size_t t = 0; t < tracks; ++t) {
        result.none[t] = problem.miss[t];
        if (static_cast<std::size_t>(column[t]) < regions)
            result.probability[t][column[t]] = problem.weight[t][column[t]];
    }
    normalise(result);
    return result;
}

}  // namespace

Association associateAlone(const AssociationProblem& problem) {
    Association alone{problem.weight, problem.miss};
    normalise(alone);
    return alone;
}

namespace {

Association associateTied(const AssociationProblem& problem) {
    if (problem.miss.size() == 1) return associateAlone(problem);
    double events = 1.0;
    for (const auto& weights : problem.weight)
        events *= 1.0 + static_cast<double>(std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0; }));
    if (events > most_events) return associateBest(problem);
    Association result = zero(problem);
    Enumeration(problem, result).run();
    normalise(result);
    return result;
}

/// The tracks that are tied to track `first` by regions they both may claim, in order.
std::vector<std::size_t> tiedTo(std::size_t first, const AssociationProblem& problem) {
    std::vector<std::size_t> tied{first};
    std::vector<bool> known(problem.miss.size(), false);
    known[first] = true;
    for (std::size_t i = 0; i < tied.size(); ++i)  // grows while it is walked
        for (std::size_t t = 0; t < known.size(); ++t) {
            if (known[t]) continue;
            for (std::size_t j = 0; j < regionsOf(problem) && !known[t]; ++j)
                known[t] = problem.weight[t][j] > 0 && problem.weight[tied[i]][j] > 0;
            if (known[t]) tied.push_back(t);
        }
    std::sort(tied.begin(), tied.end());
    return tied;
}

}  // namespace

Association associate(const AssociationProblem& whole) {
    AssociationProblem problem = whole;
    const Association alone = associateAlone(whole);
    for (std::size_t t = 0; t < problem.miss.size(); ++t)
        for (std::size_t j = 0; j < regionsOf(problem); ++j)
            if (alone.probability[t][j] < negligible) problem.weight[t][j] = 0.0;
    Association result = zero(problem);
    std::vector<bool> done(problem.miss.size(), false);
    for (std::size_t first = 0; first < done.size(); ++first) {
        if (done[first]) continue;
        const std::vector<std::size_t> tied = tiedTo(first, problem);
        AssociationProblem part;
        for (const std::size_t t : tied) {
            part.weight.push_back(problem.weight[t]);
            part.miss.push_back(problem.miss[t]);
        }
        const Association joint = associateTied(part);
        for (std::size_t i = 0; i < tied.size(); ++i) {
            result.probability[tied[i]] = joint.probability[i];
            result.none[tied[i]] = joint.none[i];
            done[tied[i]] = true;
        }
    }
    return result;
}

std::vector<int> leastCostAssignment(const std::vector<std::vector<double>>& cost) {
    const std::size_t rows = cost.size(), columns = rows == 0 ? 0 : cost.front().size();
    assert(rows <= columns);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    // Potentials u, v keep reduced costs non-negative; index 0 is a dummy that holds the row being placed.
    std::vector<double> u(rows + 1, 0.0), v(columns + 1, 0.0);
    std::vector<std::size_t> row_of(columns + 1, 0), previous(columns + 1, 0);
    for (std::size_t row = 1; row <= rows; ++row) {
        row_of[0] = row;
        std::size_t column = 0;
        std::vector<double> shortest(columns + 1, infinite);
        std::vector<bool> done(columns + 1, false);
        do {
            done[column] = true;
            double step = infinite;
            std::size_t next = 0;
            for (std::size_t j = 1; j <= columns; ++j) {
                if (done[j]) continue;
                const double reduced = cost[row_of[column] - 1][j - 1] - u[row_of[column]] - v[j];
                if (reduced < shortest[j]) shortest[j] = reduced, previous[j] = column;
                if (shortest[j] < step) step = shortest[j], next = j;
            }
            for (std::size_t j = 0; j <= columns; ++j) {
                if (done[j])
                    u[row_of[j]] += step, v[j] -= step;
                else
                    shortest[j] -= step;
            }
            column = next;
        } while (row_of[column] != 0);
        for (; column != 0; column = previous[column]) row_of[column] = row_of[previous[column]];
    }
    std::vector<int> assigned(rows, -1);
    for (std::size_t j = 1; j <= columns; ++j)
        if (row_of[j] != 0) assigned[row_of[j] - 1] = static_cast<int>(j - 1);
    return assigned;
}

}  // namespace echotrail
