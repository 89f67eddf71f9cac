#pragma once

#include <vector>

namespace echotrail {

/// A cluster of tracks that share regions: what each pairing is worth before the others are considered.
struct AssociationProblem {
    std::vector<std::vector<double>> weight;  ///< [track][region] r·P_D·likeness·N(innovation)/λ; 0: not in the gate
    std::vector<double> miss;                 ///< [track] 1 − r·P_D: no object (its existence is r), or not detected
};

/// Chances that region j is track t's echo, given that no region is the echo of two tracks and no track has two
/// echoes. Rows with their `none` add up to 1.
struct Association {
    std::vector<std::vector<double>> probability;  ///< [track][region]
    std::vector<double> none;                      ///< [track]
};

/// Pairings of less than 1 in 1000 are left out first; what they no longer tie together is decided apart. Of each part
/// all joint events are enumerated (joint probabilistic data association, Fortmann, Bar-Shalom & Scheffe 1983), up to
/// 10 000. Beyond, it takes the one best assignment, each pairing then weighed against a miss alone.
Association associate(const AssociationProblem& problem);

/// What each track would say if it were alone.
Association associateAlone(const AssociationProblem& problem);

/// Column for each row such that the sum of costs is least (shortest augmenting paths). rows ≤ columns.
std::vector<int> leastCostAssignment(const std::vector<std::vector<double>>& cost);

}  // namespace echotrail
