#include "core/evaluation/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echotrail {
namespace {

constexpr double tail = 0.025;                         // on either side of a 95 % interval
constexpr double normal_quantile = 1.959963984540054;  // 97.5 % of a Gaussian lie below
constexpr int most_terms = 1'000'000;
constexpr double tiny = 1e-300;

/// Modified Lentz: the continued fraction 1/(1 + a₁/(1 + a₂/(1 + …))) by its terms.
template <class Numerator, class Denominator>
double continuedFraction(double first, const Numerator& a, const Denominator& b) {
    double value = std::abs(first) < tiny ? tiny : first, c = value, d = 0;
    for (int i = 1; i < most_terms; ++i) {
        d = b(i) + a(i) * d;
        c = b(i) + a(i) / c;
        if (std::abs(d) < tiny) d = tiny;
        if (std::abs(c) < tiny) c = tiny;
        d = 1 / d;
        value *= c * d;
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return value;
}

/// Regularised lower incomplete gamma function (Abramowitz & Stegun 6.5.29 and 6.5.31).
double gammaShare(double shape, double x) {
    if (x <= 0) return 0;
    const double front = std::exp(shape * std::log(x) - x - std::lgamma(shape));
    if (x >= shape + 1)
        return 1 - front / continuedFraction(
                               x + 1 - shape, [&](int i) { return -i * (i - shape); },
                               [&](int i) { return x + 2 * i + 1 - shape; });
    double term = 1 / shape, sum = term;
    for (int n = 1; n < most_terms && term > sum * 1e-16; ++n) sum += term *= x / (shape + n);
    return sum * front;
}

/// Regularised incomplete beta function (Abramowitz & Stegun 26.5.8).
double betaShare(double p, double q, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    if (x > (p + 1) / (p + q + 2)) return 1 - betaShare(q, p, 1 - x);
    const double front =
        std::exp(std::lgamma(p + q) - std::lgamma(p) - std::lgamma(q) + p * std::log(x) + q * std::log1p(-x)) / p;
    const auto numerator = [&](int i) {
        const double m = i / 2;
        if (i % 2 == 0) return m * (q - m) * x / ((p + 2 * m - 1) * (p + 2 * m));
        return -(p + m) * (p + q + m) * x / ((p + 2 * m) * (p + 2 * m + 1));
    };
    return front / continuedFraction(1, numerator, [](int) { return 1.0; });
}

/// Where a rising function reaches `target`, by halving.
template <class Rising>
double whereReaches(double target, double low, double high, const Rising& function) {
    while (function(high) < target) high *= 2;
    while (high - low > 1e-13 * (std::abs(low) + std::abs(high))) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        (function(middle) < target ? low : high) = middle;
    }
    return low + (high - low) / 2;
}

/// Of sorted values, at a share of the way from the first to the last.
double at(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

ConfidenceInterval wilsonInterval(std::size_t successes, std::size_t total) {
    if (total == 0) return {0, 1};
    const double n = static_cast<double>(total), share = static_cast<double>(successes) / n;
    const double z2 = normal_quantile * normal_quantile;
    const double centre = (share + z2 / (2 * n)) / (1 + z2 / n);
    const double half = normal_quantile / (1 + z2 / n) * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n));
    return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

MeanEstimate meanEstimate(std::span<const double> values) {
    MeanEstimate estimate{.count = values.size()};
    if (values.empty()) return estimate;
    const double n = static_cast<double>(values.size());
    for (const double value : values) estimate.mean += value / n;
    estimate.interval = {estimate.mean, estimate.mean};
    if (values.size() < 2) return estimate;
    double squares = 0;
    for (const double value : values) squares += (value - estimate.mean) * (value - estimate.mean);
    const double half = studentQuantile(1 - tail, n - 1) * std::sqrt(squares / (n - 1) / n);
    estimate.interval = {estimate.mean - half, estimate.mean + half};
    return estimate;
}

ConfidenceInterval poissonRateInterval(std::size_t events, double exposure) {
    if (exposure <= 0) return {0, std::numeric_limits<double>::infinity()};
    const double n = static_cast<double>(events);
    const double low = events == 0 ? 0 : chiSquareQuantile(tail, 2 * n) / 2;
    return {low / exposure, chiSquareQuantile(1 - tail, 2 * n + 2) / 2 / exposure};
}

ConfidenceInterval neesBounds(std::size_t samples) {
    if (samples == 0) return {0, std::numeric_limits<double>::infinity()};
    const double n = static_cast<double>(samples);
    return {chiSquareQuantile(tail, 2 * n) / n, chiSquareQuantile(1 - tail, 2 * n) / n};
}

double chiSquareQuantile(double probability, double degrees) {
    return whereReaches(probability, 0.0, degrees + 1, [&](double x) { return gammaShare(degrees / 2, x / 2); });
}

double studentQuantile(double probability, double degrees) {
    if (probability < 0.5) return -studentQuantile(1 - probability, degrees);
    return whereReaches(probability, 0.0, 2.0,
                        [&](double t) { return 1 - 0.5 * betaShare(degrees / 2, 0.5, degrees / (degrees + t * t)); });
}

FiveNumbers fiveNumbers(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values.front(), at(values, 0.25), at(values, 0.5), at(values, 0.75), values.back()};
}

double median(std::vector<double> values) { return fiveNumbers(std::move(values)).median; }

}  // namespace echotrail
