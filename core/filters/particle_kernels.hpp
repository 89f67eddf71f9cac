#pragma once

#include <Eigen/Core>

#include <span>

namespace echotrail {

/// The particle filter's inner loops: single precision, one array per coordinate, plain arithmetic the compiler turns
/// into vector instructions. Sums have a fixed order, and no step depends on how wide the vectors are.

/// Positions in metres from a common origin, one array per axis.
struct Positions {
    std::span<const float> north;
    std::span<const float> east;
};

/// weight · N(x; mean, LLᵀ), its logarithm being log_scale − ½|L⁻¹(x − mean)|².
struct GaussianTerm {
    /// `root` is L, lower triangular; `mean` is in metres from the origin of the positions.
    GaussianTerm(const Eigen::Vector2d& mean, const Eigen::Matrix2d& root, double log_weight);

    float north, east;
    float inverse_nn, inverse_en, inverse_ee;  ///< L⁻¹
    float log_scale;
};

/// log[i] = logarithm of the term at position i.
void logDensity(const GaussianTerm& term, Positions at, std::span<float> log);

/// sum[i] += term at position i / exp(log_reference[i]). The exponential is good to 2e-7 relative; quotients below
/// exp(−87) count as zero and above exp(80) as exp(80).
void addRelativeDensity(const GaussianTerm& term, Positions at, std::span<const float> log_reference,
                        std::span<float> sum);

/// out = mean ± root · normal: the first half with plus, the second with minus. `root` is lower triangular.
void placePairs(const Eigen::Vector2d& mean, const Eigen::Matrix2d& root, Positions normals, std::span<float> north,
                std::span<float> east);

/// Mean of x xᵀ over the positions.
Eigen::Matrix2d meanSquare(Positions at);

struct WeightSums {
    double total = 0.0;
    double squares = 0.0;
    Eigen::Vector2d positions{0, 0};  ///< Σ weight · position
};
WeightSums weightSums(std::span<const float> weight, Positions at);

/// Σ weight · (x − centre)(x − centre)ᵀ.
Eigen::Matrix2d weightedSquares(std::span<const float> weight, Positions at, const Eigen::Vector2d& centre);

}  // namespace echotrail
