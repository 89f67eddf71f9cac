#pragma once

#include "core/simulation/acoustics.hpp"
#include "core/simulation/scenario.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace echotrail {

/// What the bottom scatters at a place, relative to its mean sand: the gamma texture of its patches of 0.5 m and its
/// rock, which is where smooth noise exceeds `rock_above` = gaussianAbove(rock_share). Both are fixed to the world, by
/// the seed: a patch is met again in the next sweep.
double groundStrength(const Scenario& scenario, std::uint64_t seed, std::int64_t cell_north, std::int64_t cell_east,
                      double rock_above);
inline constexpr double ground_cell_m = 0.5;

/// Whether there is rock at a place of the world.
bool isRock(std::uint64_t seed, double north_m, double east_m, double rock_above);

/// groundStrength of the cells met lately: most are met again by the next beam, and it costs many random numbers.
/// State: that memory, of bounded size. It depends on nothing else.
class GroundMemory {
public:
    /// `scenario` lives longer.
    GroundMemory(const Scenario& scenario, std::uint64_t seed);
    /// Whether the bottom is the same everywhere.
    bool isEven() const { return even_; }
    double strengthAt(std::int64_t cell_north, std::int64_t cell_east);

private:
    struct Entry {
        std::int64_t cell_north = 0, cell_east = 0;
        double strength = -1.0;  ///< below 0: empty
    };
    const Scenario& scenario_;
    std::uint64_t seed_;
    bool even_;
    double rock_above_;
    std::vector<Entry> entries_;  ///< a cell has one place in it
};

/// The bottom along one beam, near to far. The lobe takes in several patches far out: three places across it stand
/// for them.
class GroundAlongBeam {
public:
    /// `direction` of the beam from north, out from `pose`, `height_m` above the bottom.
    GroundAlongBeam(GroundMemory& ground, const Pose& pose, Bearing direction, double height_m,
                    const acoustics::Lobe& lobe);
    /// Mean strength in the lobe at a slant range.
    double at(double range_m);

private:
    struct Strand {
        double north = 0.0, east = 0.0;  ///< unit vector
        std::int64_t cell_north = 0, cell_east = 0;
        double strength = -1.0;  ///< of that cell; below 0 before the first
    };
    GroundMemory& ground_;
    Pose pose_;
    double height_m_;
    std::array<Strand, 3> strands_;
};

/// A number of the gamma law with unit mean and the given shape (Marsaglia and Tsang, 2000).
double gammaNumber(double shape, std::uint64_t seed, std::uint64_t purpose, std::uint64_t index);

/// The value that a Gaussian number exceeds with this probability.
double gaussianAbove(double probability);

}  // namespace echotrail
