#pragma once

#include "core/base/parameters.hpp"
#include "core/data/region.hpp"

namespace echotrail {

enum class Fusion { Product, Sum };
enum class ReferenceForm { Scaled, FirstLook };

struct LikenessParams {
    double area_sigma = 0.7;
    double moment_sigma = 0.6;
    double strength_sigma_db = 8.0;
    double level_sigma_db = 10.0;
    ReferenceForm reference = ReferenceForm::Scaled;
    Fusion fusion = Fusion::Product;
    double area_share = 0.5;
    double likeness_floor = 0.05;
    double low_beam_width_deg = 3.0;
    double high_beam_width_deg = 1.5;
    double point_echo_length_percent = 1.0;
    double reference_learning = 0.1;
    double learning_score = 0.6;
};

template <>
struct Described<LikenessParams> {
    using P = LikenessParams;
    static constexpr std::string_view group = "Likeness to the target";
    static constexpr auto fields = std::tuple{
        Field{&P::area_sigma, "area_sigma", "", 0.02, 5,
              "Deviation of the logarithm of the area that still counts as alike; 0.7 is a factor of 2"},
        Field{&P::moment_sigma, "moment_sigma", "decades", 0.02, 5,
              "Deviation of the moment feature that still counts as alike"},
        Field{&P::strength_sigma_db, "strength_sigma_db", "dB", 1, 1000,
              "Deviation of the echo's strength that still counts as alike; 1000 leaves strength out"},
        Field{&P::level_sigma_db, "level_sigma_db", "dB", 1, 1000,
              "Deviation of the echo's own level that still counts as alike; 1000 leaves it out"},
        ChoiceField<P, ReferenceForm, 2>{
            &P::reference,
            "reference",
            {"scaled", "first_look"},
            "What a region is compared with: the target as it would look at this range, or its first region as it was"},
        ChoiceField<P, Fusion, 2>{&P::fusion, "fusion", {"product", "sum"}, "How area and moment scores are combined"},
        Field{&P::area_share, "area_share", "", 0, 1, "Share of the area in the sum; the moment has the rest"},
        Field{&P::likeness_floor, "likeness_floor", "", 0, 1,
              "Added to every likeness, so that a strange shape alone rules nothing out"},
        Field{&P::low_beam_width_deg, "low_beam_width_deg", "deg", 0.2, 20, "Beam width below 500 kHz"},
        Field{&P::high_beam_width_deg, "high_beam_width_deg", "deg", 0.2, 20, "Beam width at 500 kHz and above"},
        Field{&P::point_echo_length_percent, "point_echo_length_percent", "% of range scale", 0.1, 10,
              "Length in range of the echo of a point"},
        Field{&P::reference_learning, "reference_learning", "", 0, 1,
              "How much of a good look goes into the reference"},
        Field{&P::learning_score, "learning_score", "", 0, 1, "Score a look needs for that"}};
};

/// What a scan makes of a point: the sonar's own contribution to the size of an echo at a range.
struct EchoGeometry {
    double range_m = 0.0;
    double beam_width_rad = 0.0;  ///< of the beam and the step between beams together
    double point_length_m = 0.0;
};

/// What the target looks like, freed from the sonar's footprint. A small target's echo is mostly the footprint, which
/// grows with range, so area and moment are predicted for the present range: width² = own² + footprint², along and
/// across the line of sight (method card, section e). An echo smaller than the footprint has no extent of its own, and
/// scales the footprint down: the footprint is a model, and heads differ.
class TargetReference {
public:
    /// From the first region of a track.
    TargetReference(const RegionFeatures& seen, const EchoGeometry& geometry);

    RegionFeatures expected(const EchoGeometry& geometry) const;
    /// Whether the first few looks are in.
    bool settled() const;
    /// Learns from a good look. The first few are averaged, smaller and stronger ones with more weight: the very first
    /// may have been half a look, or one that had run into something else. From then on widths change by 5 % at most at
    /// a time, and never beyond twice or half of what that average would be at this range.
    void learn(const RegionFeatures& seen, const EchoGeometry& geometry, double share);

private:
    struct Extent {
        double across_m = 0.0, along_m = 0.0;          ///< own
        double across_scale = 1.0, along_scale = 1.0;  ///< of the footprint, at most 1
        double fill = 1.0;                             ///< area relative to the ellipse of the same widths
        double strength_db = 0.0;
        double level_db = 0.0;
    };
    void average(const RegionFeatures& seen, const RegionFeatures& now, const EchoGeometry& geometry);
    static Extent own(const RegionFeatures& seen, const EchoGeometry& geometry);
    static RegionFeatures look(const Extent& extent, const EchoGeometry& geometry);
    Extent first_;
    Extent now_;
    int looks_ = 1;
};

/// Likeness of two regions, 0…1: Gaussians of the difference in area and in the moment feature (method card, section
/// f), as a product or weighted sum. The area's difference is that of the logarithms, which for small ones is the
/// relative difference: a target seen twice as large is then as strange as one seen half as large. Against the first
/// look it is the relative difference, as published.
double likeness(const RegionFeatures& seen, const RegionFeatures& expected, const LikenessParams& params);

/// Likeness of two echo levels, 0…1. Where level is left out, 1.
double levelLikeness(double level_db, double expected_db, const LikenessParams& params);

/// How much better a region's strength fits the target than clutter: N(strength; expected, σ) over the exponential
/// density of clutter strengths, which begins at `faintest_db` and has mean excess `clutter_excess_db`. An addition to
/// the published method: on real recordings it tells a target from speckle of the same size. Within [0.01, 100].
double strengthRatio(double strength_db, double expected_db, double faintest_db, double clutter_excess_db,
                     const LikenessParams& params);

}  // namespace echotrail
