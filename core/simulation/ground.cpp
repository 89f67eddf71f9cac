#include "core/simulation/ground.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail {

namespace {

enum Purpose : std::uint64_t { texture_numbers = 10, rock_numbers = 11 };

constexpr std::int64_t remembered_side = 256;  // cells to a side of the remembered square; a power of 2
constexpr double rock_size_m = 4.0;            // between the knots of the noise that rock rises from

/// Both numbers of a cell in one; unique within 16 km.
std::uint64_t indexOf(std::int64_t north, std::int64_t east) {
    return (static_cast<std::uint64_t>(north & 0xFFFF) << 32) | static_cast<std::uint32_t>(east);
}

/// Gaussian noise of unit variance that changes over some metres: knots of a grid, joined by straight lines.
double smoothNoise(std::uint64_t seed, double north_m, double east_m) {
    const double n = north_m / rock_size_m, e = east_m / rock_size_m;
    const double north_part = n - std::floor(n), east_part = e - std::floor(e);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const double weight = (i == 0 ? 1.0 - north_part : north_part) * (j == 0 ? 1.0 - east_part : east_part);
            RandomStream knot(
                seed, rock_numbers,
                indexOf(static_cast<std::int64_t>(std::floor(n)) + i, static_cast<std::int64_t>(std::floor(e)) + j));
            sum += weight * knot.gaussian();
            squares += weight * weight;
        }
    return sum / std::sqrt(squares);
}

}  // namespace

double gammaNumber(double shape, std::uint64_t seed, std::uint64_t purpose, std::uint64_t index) {
    RandomStream random(seed, purpose, index);
    const double boost = shape < 1.0 ? std::pow(random.uniform(), 1.0 / shape) : 1.0;
    const double d = (shape < 1.0 ? shape + 1.0 : shape) - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
    while (true) {  // some 95 % of the turns are accepted
        const double x = random.gaussian(), v = 1.0 + c * x;
        if (v <= 0.0) continue;
        const double cube = v * v * v;
        if (std::log(random.uniform()) < 0.5 * x * x + d - d * cube + d * std::log(cube))
            return d * cube * boost / shape;
    }
}

double gaussianAbove(double probability) {
    double low = -9.0, high = 9.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2.0;
        (0.5 * std::erfc(middle / std::numbers::sqrt2) > probability ? low : high) = middle;
    }
    return low;
}

bool isRock(std::uint64_t seed, double north_m, double east_m, double rock_above) {
    return smoothNoise(seed, north_m, east_m) > rock_above;
}

double groundStrength(const Scenario& scenario, std::uint64_t seed, std::int64_t cell_north, std::int64_t cell_east,
                      double rock_above) {
    double strength = 1.0;
    if (scenario.bottom_texture > 0.0)
        strength = gammaNumber(scenario.bottom_texture, seed, texture_numbers, indexOf(cell_north, cell_east));
    if (scenario.rock_share > 0.0) {
        const double north_m = (static_cast<double>(cell_north) + 0.5) * ground_cell_m;
        const double east_m = (static_cast<double>(cell_east) + 0.5) * ground_cell_m;
        if (isRock(seed, north_m, east_m, rock_above)) strength *= acoustics::powerOf(scenario.rock_db);
    }
    return strength;
}

GroundMemory::GroundMemory(const Scenario& scenario, std::uint64_t seed)
    : scenario_(scenario),
      seed_(seed),
      even_(scenario.bottom_texture == 0.0 && scenario.rock_share == 0.0),
      rock_above_(gaussianAbove(scenario.rock_share)),
      entries_(even_ ? 0 : static_cast<std::size_t>(remembered_side * remembered_side)) {}

double GroundMemory::strengthAt(std::int64_t cell_north, std::int64_t cell_east) {
    // Cells about one place of the world have places of their own: the square repeats beyond it.
    constexpr std::int64_t mask = remembered_side - 1;
    Entry& entry = entries_[static_cast<std::size_t>((cell_north & mask) * remembered_side + (cell_east & mask))];
    if (entry.strength < 0.0 || entry.cell_north != cell_north || entry.cell_east != cell_east)
        entry = {cell_north, cell_east, groundStrength(scenario_, seed_, cell_north, cell_east, rock_above_)};
    return entry.strength;
}

GroundAlongBeam::GroundAlongBeam(GroundMemory& ground, const Pose& pose, Bearing direction, double height_m,
                                 const acoustics::Lobe& lobe)
    : ground_(ground), pose_(pose), height_m_(height_m) {
    for (std::size_t i = 0; i < strands_.size(); ++i) {
        const double off_rad = (static_cast<double>(i) - 1.0) * lobe.integralWidth() / 3.0;
        strands_[i].north = std::cos(direction.inRadians() + off_rad);
        strands_[i].east = std::sin(direction.inRadians() + off_rad);
    }
}

double GroundAlongBeam::at(double range_m) {
    if (ground_.isEven() || range_m < height_m_) return 1.0;
    const double out_m = std::sqrt(range_m * range_m - height_m_ * height_m_);
    double sum = 0.0;
    for (Strand& strand : strands_) {
        const auto north =
            static_cast<std::int64_t>(std::floor((pose_.north_m + out_m * strand.north) / ground_cell_m));
        const auto east = static_cast<std::int64_t>(std::floor((pose_.east_m + out_m * strand.east) / ground_cell_m));
        if (strand.strength < 0.0 || north != strand.cell_north || east != strand.cell_east)
            strand = {strand.north, strand.east, north, east, ground_.strengthAt(north, east)};
        sum += strand.strength;
    }
    return sum / static_cast<double>(strands_.size());
}

}  // namespace echotrail
