#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// The few laws of statistics that an evaluation needs. Intervals and bounds are 95 % ones, two-sided.
namespace echotrail {

struct ConfidenceInterval {
    double low = 0.0;
    double high = 0.0;
};

/// Of the share behind `successes` of `total` independent trials (Wilson 1927): inside [0, 1] also for none and all.
/// No trials say nothing: [0, 1].
ConfidenceInterval wilsonInterval(std::size_t successes, std::size_t total);

/// A mean with the interval that its scatter allows it (Student's t).
struct MeanEstimate {
    std::size_t count = 0;
    double mean = 0.0;
    ConfidenceInterval interval;  ///< the mean itself where there are fewer than two values
};
MeanEstimate meanEstimate(std::span<const double> values);

/// Events per unit of `exposure`, from the exact law of Poisson counts (Garwood 1936).
ConfidenceInterval poissonRateInterval(std::size_t events, double exposure);

/// Between what the mean of `samples` independent errors e'P⁻¹e of two dimensions lies where the covariance is honest.
ConfidenceInterval neesBounds(std::size_t samples);
/// e'P⁻¹e on the ellipse that holds 95 % of a Gaussian in the plane.
inline constexpr double nees_of_ellipse = 5.991464547107979;

/// The value that a share `probability`, in (0, 1), of the distribution lies below.
double chiSquareQuantile(double probability, double degrees);
double studentQuantile(double probability, double degrees);

/// Least, quartiles and greatest, between neighbours linearly; all 0 where there are no values.
struct FiveNumbers {
    double least = 0.0, lower = 0.0, median = 0.0, upper = 0.0, greatest = 0.0;
};
FiveNumbers fiveNumbers(std::vector<double> values);
double median(std::vector<double> values);

}  // namespace echotrail
