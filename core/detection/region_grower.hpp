#pragma once

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"
#include "core/data/region_pixels.hpp"

#include <cstdint>
#include <vector>

namespace echotrail {

struct RegionGrowerParams {
    double grow_excess_db = 6.0;
    double peak_drop_db = 12.0;
    double deviation_factor = 3.0;
    double deviation_floor_db = 3.0;
    double edge_db_per_pixel = 4.0;
    double merge_gap_m = 0.4;
    double merge_distance_m = 1.5;
    double merge_saddle_db = 8.0;
    double merge_peak_drop_db = 12.0;
    int min_pixels = 6;
    double max_area_m2 = 8.0;
    double reseed_contrast_db = 10.0;
};

template <>
struct Described<RegionGrowerParams> {
    using P = RegionGrowerParams;
    static constexpr std::string_view group = "Region growing";
    static constexpr auto fields = std::tuple{
        Field{&P::grow_excess_db, "grow_excess_db", "dB", 1, 30,
              "A region takes in pixels that stand out this far from the background"},
        Field{&P::peak_drop_db, "peak_drop_db", "dB", 3, 40, "… and are at most this far below its peak"},
        Field{&P::deviation_factor, "deviation_factor", "", 1, 10,
              "… and within this many deviations of the region's mean level"},
        Field{&P::deviation_floor_db, "deviation_floor_db", "dB", 0.5, 10,
              "A region's deviation counts as at least this"},
        Field{&P::edge_db_per_pixel, "edge_db_per_pixel", "dB/pixel", 1, 20,
              "A steeper ridge of the gradient is a boundary: taken in, but not grown across"},
        Field{&P::merge_gap_m, "merge_gap_m", "m", 0, 3, "Regions closer than this are one, if the saddle allows"},
        Field{&P::merge_distance_m, "merge_distance_m", "m", 0, 10,
              "Regions whose centres are closer than this are one, if the saddle allows"},
        Field{&P::merge_saddle_db, "merge_saddle_db", "dB", 0, 30,
              "Between merged regions the level stays within this of the lower peak"},
        Field{&P::merge_peak_drop_db, "merge_peak_drop_db", "dB", 0, 80,
              "… and their peaks differ by no more: what is fainter is a wake, a ghost or a side lobe, not the same "
              "thing"},
        Field{&P::min_pixels, "min_pixels", "pixels", 1, 200, "Smaller regions are dropped"},
        Field{&P::max_area_m2, "max_area_m2", "m²", 0.1, 500, "Larger regions are clutter masses, not targets"},
        Field{&P::reseed_contrast_db, "reseed_contrast_db", "dB", 3, 40,
              "Inside a clutter mass a peak this far above its surroundings is a region of its own"}};
};

/// Region growing that uses region and boundary information (method card, section d; after Muñoz et al. 2003).
/// Decided in whole numbers throughout, so that every build finds the same regions; a region does not depend on
/// where the picture's origin lies or in which order seeds are visited.
/// State: working memory only.
class RegionGrower {
public:
    explicit RegionGrower(const RegionGrowerParams& params) : params_(params) {}
    void setParams(const RegionGrowerParams& params) { params_ = params; }

    /// `picture.levels` is the smoothed echo, `background` (8-bit, the same size) what it stands out from. Seeds are
    /// local maxima that stand out by `seed_excess` levels or more. The strongest region comes first.
    std::vector<RegionPixels> operator()(const FanImage& picture, const cv::Mat& background, int seed_excess);

private:
    struct Limits {
        int grow_excess, peak_drop, deviation_floor, edge;
    };
    const std::vector<RegionPixel>& seedCandidates();
    bool isPeak(const RegionPixel& pixel) const;
    RegionPixels grow(const RegionPixel& seed, const Limits& limits);
    bool isBoundary(int row, int column, int edge) const;
    int gradientSquared(int row, int column) const;
    void merge(std::vector<RegionPixels>& regions) const;
    int saddleLevel(const RegionPixels& a, const RegionPixels& b) const;
    std::vector<RegionPixels> reseed(const RegionPixels& mass);
    int ringLevel(int row, int column) const;
    std::uint8_t& taken(int row, int column) { return taken_.ptr(row)[column]; }

    RegionGrowerParams params_;
    FanImage picture_;
    cv::Mat excess_;
    int seed_excess_ = 1;
    std::vector<std::vector<RegionPixel>> by_level_;
    std::vector<RegionPixel> candidates_;
    cv::Mat taken_;                                  ///< 8-bit; 0 is free, 1 waits or is in a region
    std::vector<std::vector<std::uint32_t>> queue_;  ///< pixels waiting, by level
};

}  // namespace echotrail
