#include "core/features/target_reference.hpp"

#include "core/features/region_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

// A point's echo is 2κ times as wide as from the axis to half power on the contour 12 dB below the peak: κ =
// √(12/6.02).
constexpr double contour_factor = 1.41;
constexpr double least_extent_m = 0.05;  // so that a factor of two about nothing is still something

double footprintAcross(const EchoGeometry& geometry) {
    return contour_factor * geometry.beam_width_rad * geometry.range_m;
}

double without(double whole, double part) { return std::sqrt(std::max(0.0, whole * whole - part * part)); }

double limitedStep(double from, double to, double first) {
    const double scale = std::max(from, least_extent_m);
    const double step = std::clamp(to - from, -0.05 * scale, 0.05 * scale);
    const double anchor = std::max(first, least_extent_m);
    return std::clamp(from + step, first < least_extent_m ? 0.0 : anchor / 2.0, anchor * 2.0);
}

}  // namespace

TargetReference::TargetReference(const RegionFeatures& seen, const EchoGeometry& geometry)
    : first_(own(seen, geometry)), now_(first_) {}

TargetReference::Extent TargetReference::own(const RegionFeatures& seen, const EchoGeometry& geometry) {
    return {without(seen.across_range_m, footprintAcross(geometry)),
            without(seen.along_range_m, geometry.point_length_m)};
}

RegionFeatures TargetReference::expected(const EchoGeometry& geometry) const {
    RegionFeatures features;
    features.across_range_m = std::hypot(now_.across_m, footprintAcross(geometry));
    features.along_range_m = std::hypot(now_.along_m, geometry.point_length_m);
    const double elongation = features.across_range_m / features.along_range_m;
    features.area_m2 = std::numbers::pi / 4.0 * features.across_range_m * features.along_range_m;
    const double root = (elongation - 1.0 / elongation) / (4.0 * std::numbers::pi);
    features.moment = momentFeature(root * root);
    return features;
}

void TargetReference::learn(const RegionFeatures& seen, const EchoGeometry& geometry, double share) {
    const Extent extent = own(seen, geometry);
    now_.across_m =
        limitedStep(now_.across_m, now_.across_m + share * (extent.across_m - now_.across_m), first_.across_m);
    now_.along_m = limitedStep(now_.along_m, now_.along_m + share * (extent.along_m - now_.along_m), first_.along_m);
}

double likeness(const RegionFeatures& seen, const RegionFeatures& expected, const LikenessParams& params) {
    const double area = (seen.area_m2 - expected.area_m2) / expected.area_m2 / params.area_sigma;
    const double moment = (seen.moment - expected.moment) / params.moment_sigma;
    const double area_score = std::exp(-0.5 * area * area);
    const double moment_score = std::exp(-0.5 * moment * moment);
    if (params.fusion == Fusion::Sum) return params.area_share * area_score + (1 - params.area_share) * moment_score;
    return area_score * moment_score;
}

}  // namespace echotrail
