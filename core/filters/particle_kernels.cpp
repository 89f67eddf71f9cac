#include "core/filters/particle_kernels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace echotrail {
namespace {

constexpr float least_exponent = -88.0F;  // its power of two has exponent bits 0: it is zero
constexpr float largest_exponent = 80.0F;

inline float bounded(float x) {
    const float raised = x > least_exponent ? x : least_exponent;  // also takes in what is not a number
    return raised < largest_exponent ? raised : largest_exponent;
}

/// exp within the limits: t = k ln 2 + r with |r| ≤ ½ ln 2, 2^k by its exponent bits, exp(r) by its series.
inline float boundedExp(float t) {
    constexpr float rounding = 0x1.8p23F;  // adding it leaves the nearest whole number in the low bits
    const float shifted = t * std::numbers::log2e_v<float> + rounding;
    const float k = shifted - rounding;
    const float r = (t - k * 0.693359375F) + k * 2.12194440e-4F;  // ln 2 in two parts, the first exact in few bits
    const float series =
        1.0F + r * (1.0F + r * (1.0F / 2 + r * (1.0F / 6 + r * (1.0F / 24 + r * (1.0F / 120 + r * (1.0F / 720))))));
    const std::uint32_t power = (std::bit_cast<std::uint32_t>(shifted) + 127U) << 23;
    return series * std::bit_cast<float>(power);
}

inline float logTerm(const GaussianTerm& term, float north, float east) {
    const float dn = north - term.north, de = east - term.east;
    const float u = term.inverse_nn * dn;
    const float v = term.inverse_en * dn + term.inverse_ee * de;
    return term.log_scale - 0.5F * (u * u + v * v);
}

/// Σ value(i) in eight interleaved partial sums: a fixed order that vector instructions can keep.
template <class Value>
inline double laneSum(std::size_t count, Value value) {
    constexpr std::size_t lanes = 8;
    std::array<double, lanes> sums{};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += value(i + lane);
    for (std::size_t lane = 0; i < count; ++i, ++lane) sums[lane] += value(i);
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

}  // namespace

GaussianTerm::GaussianTerm(const Eigen::Vector2d& mean, const Eigen::Matrix2d& root, double log_weight)
    : north(static_cast<float>(mean.x())),
      east(static_cast<float>(mean.y())),
      inverse_nn(static_cast<float>(1.0 / root(0, 0))),
      inverse_en(static_cast<float>(-root(1, 0) / (root(0, 0) * root(1, 1)))),
      inverse_ee(static_cast<float>(1.0 / root(1, 1))),
      log_scale(static_cast<float>(log_weight - std::log(2.0 * std::numbers::pi) - std::log(root(0, 0)) -
                                   std::log(root(1, 1)))) {}

void logDensity(const GaussianTerm& term, Positions at, std::span<float> log) {
    const GaussianTerm t = term;  // a copy the output cannot alias
    for (std::size_t i = 0; i < log.size(); ++i) log[i] = logTerm(t, at.north[i], at.east[i]);
}

void addRelativeDensity(const GaussianTerm& term, Positions at, std::span<const float> log_reference,
                        std::span<float> sum) {
    const GaussianTerm t = term;
    constexpr std::size_t longest = 256;
    std::array<float, longest> exponent;
    for (std::size_t begin = 0; begin < sum.size(); begin += longest) {
        const std::size_t count = std::min(longest, sum.size() - begin);
        // Two loops: in one, the compiler branches around the exponential of a bound and gives up its vectors.
        for (std::size_t i = 0; i < count; ++i)
            exponent[i] = bounded(logTerm(t, at.north[begin + i], at.east[begin + i]) - log_reference[begin + i]);
        for (std::size_t i = 0; i < count; ++i) sum[begin + i] += boundedExp(exponent[i]);
    }
}

void placePairs(const Eigen::Vector2d& mean, const Eigen::Matrix2d& root, Positions normals, std::span<float> north,
                std::span<float> east) {
    const Eigen::Vector2f centre = mean.cast<float>();
    const Eigen::Matrix2f r = root.cast<float>();
    const float mean_north = centre.x(), mean_east = centre.y(), nn = r(0, 0), en = r(1, 0), ee = r(1, 1);
    const std::size_t pairs = normals.north.size();
    for (std::size_t i = 0; i < pairs; ++i) {
        const float dn = nn * normals.north[i];
        const float de = en * normals.north[i] + ee * normals.east[i];
        north[i] = mean_north + dn;
        east[i] = mean_east + de;
        north[pairs + i] = mean_north - dn;
        east[pairs + i] = mean_east - de;
    }
}

Eigen::Matrix2d meanSquare(Positions at) {
    const std::size_t count = at.north.size();
    const auto north = [&](std::size_t i) { return double{at.north[i]}; };
    const auto east = [&](std::size_t i) { return double{at.east[i]}; };
    const double nn = laneSum(count, [&](std::size_t i) { return north(i) * north(i); });
    const double ne = laneSum(count, [&](std::size_t i) { return north(i) * east(i); });
    const double ee = laneSum(count, [&](std::size_t i) { return east(i) * east(i); });
    return Eigen::Matrix2d{{nn, ne}, {ne, ee}} / static_cast<double>(count);
}

WeightSums weightSums(std::span<const float> weight, Positions at) {
    const auto w = [&](std::size_t i) { return double{weight[i]}; };
    const std::size_t count = weight.size();
    return {.total = laneSum(count, w),
            .squares = laneSum(count, [&](std::size_t i) { return w(i) * w(i); }),
            .positions = {laneSum(count, [&](std::size_t i) { return w(i) * double{at.north[i]}; }),
                          laneSum(count, [&](std::size_t i) { return w(i) * double{at.east[i]}; })}};
}

Eigen::Matrix2d weightedSquares(std::span<const float> weight, Positions at, const Eigen::Vector2d& centre) {
    const double centre_north = centre.x(), centre_east = centre.y();
    const auto w = [&](std::size_t i) { return double{weight[i]}; };
    const auto north = [&](std::size_t i) { return double{at.north[i]} - centre_north; };
    const auto east = [&](std::size_t i) { return double{at.east[i]} - centre_east; };
    const std::size_t count = weight.size();
    const double nn = laneSum(count, [&](std::size_t i) { return w(i) * north(i) * north(i); });
    const double ne = laneSum(count, [&](std::size_t i) { return w(i) * north(i) * east(i); });
    const double ee = laneSum(count, [&](std::size_t i) { return w(i) * east(i) * east(i); });
    return Eigen::Matrix2d{{nn, ne}, {ne, ee}};
}

}  // namespace echotrail
