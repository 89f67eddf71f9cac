#pragma once

#include "core/base/parameters.hpp"
#include "core/data/region.hpp"

namespace echotrail {

enum class Fusion { Product, Sum };

struct LikenessParams {
    double area_sigma = 0.25;
    double moment_sigma = 0.25;
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
        Field{&P::area_sigma, "area_sigma", "", 0.02, 5, "Relative deviation of the area that still counts as alike"},
        Field{&P::moment_sigma, "moment_sigma", "decades", 0.02, 5,
              "Deviation of the moment feature that still counts as alike"},
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

/// What the target looks like, freed from the sonar's footprint: its own extent. Area and moment are predicted from
/// it at the present range, for a small target's echo is mostly the beam's footprint (method card, section e).
class TargetReference {
public:
    /// From the first region of a track.
    TargetReference(const RegionFeatures& seen, const EchoGeometry& geometry);

    RegionFeatures expected(const EchoGeometry& geometry) const;
    /// Learns from a good look: at most 5 % of change at a time, and never beyond twice or half the first extent.
    void learn(const RegionFeatures& seen, const EchoGeometry& geometry, double share);

private:
    struct Extent {
        double across_m = 0.0, along_m = 0.0;
    };
    static Extent own(const RegionFeatures& seen, const EchoGeometry& geometry);
    Extent first_;
    Extent now_;
};

/// Likeness of two regions, 0…1: Gaussians of the relative difference of area and of the difference of the moment
/// feature (method card, section 0 for the corrected form of the equations), as a product or weighted sum.
double likeness(const RegionFeatures& seen, const RegionFeatures& expected, const LikenessParams& params);

}  // namespace echotrail
