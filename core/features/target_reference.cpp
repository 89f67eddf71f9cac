#include "core/features/target_reference.hpp"

#include "core/features/likeness_deviations.hpp"
#include "core/features/region_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

// Half the width of a Gaussian beam's echo on the contour Δ = 12 dB below its peak, in beam widths: √(Δ/6.02)/2.
constexpr double contour_factor = 1.41;
constexpr double strength_left_out_db = 1000.0;
constexpr int averaged_looks = 6;
constexpr double purer_share = 0.5;
constexpr double least_fill = 0.2, greatest_fill = 2.0;

double footprintAcross(const EchoGeometry& geometry) {
    return contour_factor * geometry.beam_width_rad * geometry.range_m;
}

double ellipseArea(double across, double along) { return std::numbers::pi / 4.0 * across * along; }

double squared(double value) { return value * value; }

double without(double whole, double part) { return std::sqrt(std::max(squared(whole) - squared(part), 0.0)); }

double learned(double now, double seen, double first, double share) {
    const double next = now + std::clamp(share * (seen - now), -0.05 * now, 0.05 * now);
    return std::clamp(next, first / 2.0, first * 2.0);
}

}  // namespace

TargetReference::TargetReference(const RegionFeatures& seen, const EchoGeometry& geometry)
    : first_(own(seen, geometry)), now_(first_) {}

TargetReference::Extent TargetReference::own(const RegionFeatures& seen, const EchoGeometry& geometry) {
    const double across = footprintAcross(geometry), along = geometry.point_length_m;
    const double ellipse = ellipseArea(seen.across_range_m, seen.along_range_m);
    return {.across_m = without(seen.across_range_m, across),
            .along_m = without(seen.along_range_m, along),
            .across_scale = std::min(1.0, seen.across_range_m / across),
            .along_scale = std::min(1.0, seen.along_range_m / along),
            .fill = std::clamp(seen.area_m2 / ellipse, least_fill, greatest_fill),
            .strength_db = seen.strength_db,
            .level_db = seen.level_db};
}

RegionFeatures TargetReference::look(const Extent& extent, const EchoGeometry& geometry) {
    RegionFeatures features;
    features.across_range_m = std::hypot(extent.across_m, extent.across_scale * footprintAcross(geometry));
    features.along_range_m = std::hypot(extent.along_m, extent.along_scale * geometry.point_length_m);
    const double elongation = features.across_range_m / features.along_range_m;
    features.area_m2 = extent.fill * ellipseArea(features.across_range_m, features.along_range_m);
    // M2 of an ellipse, its second moments taken relative to the area it really has.
    const double root = (elongation - 1.0 / elongation) / (4.0 * std::numbers::pi * extent.fill);
    features.moment = momentFeature(root * root);
    features.strength_db = extent.strength_db;
    features.level_db = extent.level_db;
    return features;
}

RegionFeatures TargetReference::expected(const EchoGeometry& geometry) const { return look(now_, geometry); }

bool TargetReference::settled() const { return looks_ >= averaged_looks; }

void TargetReference::learn(const RegionFeatures& seen, const EchoGeometry& geometry, double share) {
    if (share <= 0) return;
    const RegionFeatures now = look(now_, geometry), first = look(first_, geometry);
    if (!settled()) return average(seen, now, geometry);
    RegionFeatures next;
    next.across_range_m = learned(now.across_range_m, seen.across_range_m, first.across_range_m, share);
    next.along_range_m = learned(now.along_range_m, seen.along_range_m, first.along_range_m, share);
    const double fill = learned(now_.fill, own(seen, geometry).fill, first_.fill, share);
    next.area_m2 = fill * ellipseArea(next.across_range_m, next.along_range_m);
    // Strength is followed faster than shape: it changes with aspect and range.
    const auto followed = [share](double before, double after) {
        return before + (after > before ? 3.0 : 1.0) * share * (after - before);
    };
    next.strength_db = followed(now_.strength_db, seen.strength_db);
    next.level_db = followed(now_.level_db, seen.level_db);
    now_ = own(next, geometry);
}

void TargetReference::average(const RegionFeatures& seen, const RegionFeatures& now, const EchoGeometry& geometry) {
    const double part = 1.0 / ++looks_;
    // Echoes run into others' and fade; neither makes them smaller or stronger than they are.
    const auto mixed = [&](double RegionFeatures::*what, bool purer) {
        return now.*what + (purer ? purer_share : part / 2.0) * (seen.*what - now.*what);
    };
    const bool smaller = seen.area_m2 < now.area_m2;
    RegionFeatures next;
    next.area_m2 = mixed(&RegionFeatures::area_m2, smaller);
    next.across_range_m = mixed(&RegionFeatures::across_range_m, smaller);
    next.along_range_m = mixed(&RegionFeatures::along_range_m, smaller);
    next.strength_db = mixed(&RegionFeatures::strength_db, seen.strength_db > now.strength_db);
    next.level_db = mixed(&RegionFeatures::level_db, seen.level_db > now.level_db);
    first_ = now_ = own(next, geometry);
}

LikenessDeviations likenessDeviations(const RegionFeatures& seen, const RegionFeatures& expected,
                                      const LikenessParams& params) {
    LikenessDeviations off;
    off.area = (params.reference == ReferenceForm::Scaled ? std::log(seen.area_m2 / expected.area_m2)
                                                          : (seen.area_m2 - expected.area_m2) / expected.area_m2) /
               params.area_sigma;
    off.moment = (seen.moment - expected.moment) / params.moment_sigma;
    if (params.level_sigma_db < strength_left_out_db)
        off.level = (seen.level_db - expected.level_db) / params.level_sigma_db;
    if (params.strength_sigma_db < strength_left_out_db)
        off.strength = (seen.strength_db - expected.strength_db) / params.strength_sigma_db;
    return off;
}

double likeness(const RegionFeatures& seen, const RegionFeatures& expected, const LikenessParams& params) {
    const LikenessDeviations off = likenessDeviations(seen, expected, params);
    const double area_score = std::exp(-0.5 * off.area * off.area);
    const double moment_score = std::exp(-0.5 * off.moment * off.moment);
    if (params.fusion == Fusion::Product) return area_score * moment_score;
    return params.area_share * area_score + (1 - params.area_share) * moment_score;
}

double levelLikeness(double level_db, double expected_db, const LikenessParams& params) {
    if (params.level_sigma_db >= strength_left_out_db) return 1.0;
    const double off = (level_db - expected_db) / params.level_sigma_db;
    return std::exp(-0.5 * off * off);
}

double strengthRatio(double strength_db, double expected_db, double faintest_db, double clutter_excess_db,
                     const LikenessParams& params) {
    if (params.strength_sigma_db >= strength_left_out_db) return 1.0;
    const double off = (strength_db - expected_db) / params.strength_sigma_db;
    const double target = std::exp(-0.5 * off * off) / (params.strength_sigma_db * std::sqrt(2.0 * std::numbers::pi));
    const double above = std::max(strength_db - faintest_db, 0.0);
    const double clutter = std::exp(-above / clutter_excess_db) / clutter_excess_db;
    return std::clamp(target / clutter, 0.01, 100.0);
}

}  // namespace echotrail
