#include "core/detection/region_grower.hpp"

#include "core/data/ping.hpp"

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace echotrail {
namespace {

constexpr int seed_radius = 3;         // a seed is the maximum of its 7×7 neighbourhood
constexpr int seed_block = 64;         // pixels looked at together in the search for seeds
constexpr double ring_radius_m = 2.0;  // what a peak inside a clutter mass is compared with

int levelsFromDb(double db) { return static_cast<int>(std::lround(db * levels_per_db)); }

/// Whether pixel a comes before b in the order of seeds: stronger first, then by place.
bool strongerFirst(const RegionPixel& a, const RegionPixel& b) {
    if (a.level != b.level) return a.level > b.level;
    return a.row != b.row ? a.row < b.row : a.column < b.column;
}

double squaredDistance(double row_a, double column_a, double row_b, double column_b) {
    return (row_a - row_b) * (row_a - row_b) + (column_a - column_b) * (column_a - column_b);
}

/// Where a region lies: what merging asks first, and often enough.
struct Extent {
    double row = 0, column = 0;  ///< of its centre
    int top = INT16_MAX, bottom = INT16_MIN, left = INT16_MAX, right = INT16_MIN;
};
Extent extentOf(const RegionPixels& region) {
    Extent extent;
    for (const RegionPixel& pixel : region.pixels) {
        extent.row += pixel.row;
        extent.column += pixel.column;
        extent.top = std::min<int>(extent.top, pixel.row);
        extent.bottom = std::max<int>(extent.bottom, pixel.row);
        extent.left = std::min<int>(extent.left, pixel.column);
        extent.right = std::max<int>(extent.right, pixel.column);
    }
    const auto n = static_cast<double>(region.pixels.size());
    extent.row /= n;
    extent.column /= n;
    return extent;
}

/// Whether any two pixels are within `gap` pixels of each other.
bool within(const RegionPixels& a, const Extent& around_a, const RegionPixels& b, const Extent& box, double gap) {
    if (around_a.top > box.bottom + gap || around_a.bottom < box.top - gap || around_a.left > box.right + gap ||
        around_a.right < box.left - gap)
        return false;
    for (const RegionPixel& p : a.pixels) {
        if (p.row < box.top - gap || p.row > box.bottom + gap || p.column < box.left - gap ||
            p.column > box.right + gap)
            continue;
        for (const RegionPixel& q : b.pixels)
            if (squaredDistance(p.row, p.column, q.row, q.column) <= gap * gap) return true;
    }
    return false;
}

}  // namespace

std::vector<RegionPixels> RegionGrower::operator()(const FanImage& picture, const cv::Mat& background,
                                                   int seed_excess) {
    assert(picture.levels.type() == CV_8U && background.size() == picture.levels.size());
    assert(picture.levels.cols <= INT16_MAX && picture.levels.rows <= INT16_MAX);
    picture_ = picture;
    cv::subtract(picture.levels, background, excess_);
    taken_.create(picture.levels.size(), CV_8U);
    taken_.setTo(0);
    seed_excess_ = std::max(seed_excess, 1);

    const Limits limits{levelsFromDb(params_.grow_excess_db), levelsFromDb(params_.peak_drop_db),
                        levelsFromDb(params_.deviation_floor_db), levelsFromDb(params_.edge_db_per_pixel)};
    const double max_pixels = params_.max_area_m2 / (picture.pixel_m * picture.pixel_m);
    std::vector<RegionPixels> regions;
    for (const RegionPixel& seed : seedCandidates())
        if (!taken(seed.row, seed.column) && isPeak(seed)) regions.push_back(grow(seed, limits));
    merge(regions);

    std::vector<RegionPixels> inside;
    for (RegionPixels& region : regions) {
        region.clutter_mass = static_cast<double>(region.pixels.size()) > max_pixels;
        if (!region.clutter_mass) continue;
        for (RegionPixels& found : reseed(region)) inside.push_back(std::move(found));
    }
    std::move(inside.begin(), inside.end(), std::back_inserter(regions));
    std::erase_if(regions,
                  [&](const RegionPixels& r) { return static_cast<int>(r.pixels.size()) < params_.min_pixels; });
    std::sort(regions.begin(), regions.end(),
              [](const RegionPixels& a, const RegionPixels& b) { return strongerFirst(a.peak, b.peak); });
    return regions;
}

/// All pixels that stand out by the seed's excess, the strongest first. Whether one is a peak is asked when its turn
/// comes: by then most lie in a region already.
const std::vector<RegionPixel>& RegionGrower::seedCandidates() {
    by_level_.resize(256);
    for (auto& places : by_level_) places.clear();
    for (int row = 0; row < excess_.rows; ++row) {
        const std::uint8_t* excess = excess_.ptr(row);
        const std::uint8_t* level = picture_.levels.ptr(row);
        for (int block = 0; block < excess_.cols; block += seed_block) {
            const int end = std::min(block + seed_block, excess_.cols);
            // Most of a picture is background: blocks without a seed are passed over at vector speed.
            std::uint8_t highest = 0;
            for (int column = block; column < end; ++column) highest = std::max(highest, excess[column]);
            if (highest < seed_excess_) continue;
            for (int column = block; column < end; ++column)
                if (excess[column] >= seed_excess_)
                    by_level_[level[column]].push_back({static_cast<std::int16_t>(row),
                                                        static_cast<std::int16_t>(column), level[column],
                                                        excess[column]});
        }
    }
    candidates_.clear();
    for (auto places = by_level_.rbegin(); places != by_level_.rend(); ++places)
        candidates_.insert(candidates_.end(), places->begin(), places->end());
    return candidates_;
}

bool RegionGrower::isPeak(const RegionPixel& pixel) const {
    const cv::Mat& levels = picture_.levels;
    const int left = std::max(pixel.column - seed_radius, 0);
    const int right = std::min(pixel.column + seed_radius, levels.cols - 1);
    for (int r = std::max(pixel.row - seed_radius, 0); r <= std::min(pixel.row + seed_radius, levels.rows - 1); ++r) {
        const std::uint8_t* line = levels.ptr(r);
        for (int c = left; c <= right; ++c)
            if (line[c] > pixel.level) return false;
    }
    return true;
}

/// Squared central-difference gradient, in (2 levels per pixel)²; outside the picture its edge repeats.
int RegionGrower::gradientSquared(int row, int column) const {
    const cv::Mat& levels = picture_.levels;
    const auto at = [&](int r, int c) {
        return int{levels.ptr(std::clamp(r, 0, levels.rows - 1))[std::clamp(c, 0, levels.cols - 1)]};
    };
    const int down = at(row + 1, column) - at(row - 1, column);
    const int right = at(row, column + 1) - at(row, column - 1);
    return down * down + right * right;
}

/// A pixel on the ridge of the gradient: steep, and no less steep than its neighbours up and down the slope.
bool RegionGrower::isBoundary(int row, int column, int edge) const {
    const int here = gradientSquared(row, column);
    if (here <= 4 * edge * edge) return false;
    const cv::Mat& levels = picture_.levels;
    const auto at = [&](int r, int c) {
        return int{levels.ptr(std::clamp(r, 0, levels.rows - 1))[std::clamp(c, 0, levels.cols - 1)]};
    };
    const int down = at(row + 1, column) - at(row - 1, column);
    const int right = at(row, column + 1) - at(row, column - 1);
    // The slope's direction, to the nearest of eight neighbours: a component counts if it is over half the other.
    const int row_step = 2 * std::abs(down) > std::abs(right) ? (down > 0 ? 1 : -1) : 0;
    const int column_step = 2 * std::abs(right) > std::abs(down) ? (right > 0 ? 1 : -1) : 0;
    return here >= gradientSquared(row + row_step, column + column_step) &&
           here >= gradientSquared(row - row_step, column - column_step);
}

/// Takes in the strongest waiting neighbour first; `limits` are the growth rules of the method card, section d.
RegionPixels RegionGrower::grow(const RegionPixel& seed, const Limits& limits) {
    const cv::Mat& levels = picture_.levels;
    queue_.resize(256);
    int top = seed.level;
    const auto push = [&](int row, int column) {
        taken(row, column) = 1;
        const int level = levels.ptr(row)[column];
        queue_[level].push_back(static_cast<std::uint32_t>(row) << 16 | static_cast<std::uint32_t>(column));
        top = std::max(top, level);
    };
    RegionPixels region;
    std::vector<std::uint32_t> refused;  // touched but not taken: free for other regions again
    std::int64_t n = 0, sum = 0, squares = 0;
    push(seed.row, seed.column);
    while (top >= 0) {
        if (queue_[top].empty()) {
            --top;
            continue;
        }
        const std::uint32_t place = queue_[top].back();
        queue_[top].pop_back();
        const int row = static_cast<int>(place >> 16), column = static_cast<int>(place & 0xFFFF);
        const int level = top, excess = excess_.ptr(row)[column];
        if (n > 0) {
            // |level − mean| ≤ factor · max(deviation, floor), multiplied by n to stay in whole numbers
            const std::int64_t off = std::abs(level * n - sum);
            const std::int64_t variance = squares * n - sum * sum;
            const std::int64_t floor = n * limits.deviation_floor;
            const auto factor = params_.deviation_factor * params_.deviation_factor;
            const auto spread = static_cast<double>(std::max(variance, floor * floor));
            if (excess < limits.grow_excess || level < seed.level - limits.peak_drop ||
                static_cast<double>(off) * static_cast<double>(off) > factor * spread) {
                refused.push_back(place);
                continue;
            }
        }
        ++n;
        sum += level;
        squares += std::int64_t{level} * level;
        region.pixels.push_back({static_cast<std::int16_t>(row), static_cast<std::int16_t>(column),
                                 static_cast<std::uint8_t>(level), static_cast<std::uint8_t>(excess)});
        if (n > 1 && isBoundary(row, column, limits.edge)) continue;
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, levels.rows - 1); ++r)
            for (int c = std::max(column - 1, 0); c <= std::min(column + 1, levels.cols - 1); ++c)
                if (!taken(r, c)) push(r, c);
    }
    for (const std::uint32_t place : refused)
        taken(static_cast<int>(place >> 16), static_cast<int>(place & 0xFFFF)) = 0;
    region.peak = region.pixels.front();
    return region;
}

/// The lowest level on the straight line between two peaks.
int RegionGrower::saddleLevel(const RegionPixels& a, const RegionPixels& b) const {
    const int steps = std::max(std::abs(a.peak.row - b.peak.row), std::abs(a.peak.column - b.peak.column));
    int lowest = std::min(a.peak.level, b.peak.level);
    for (int i = 1; i < steps; ++i) {
        // rounded to the nearest pixel, in whole numbers
        const int row = a.peak.row + ((b.peak.row - a.peak.row) * i * 2 + steps) / (2 * steps);
        const int column = a.peak.column + ((b.peak.column - a.peak.column) * i * 2 + steps) / (2 * steps);
        lowest = std::min<int>(lowest, picture_.levels.ptr(row)[column]);
    }
    return lowest;
}

/// A target often shows as detached patches: those that belong together become one.
void RegionGrower::merge(std::vector<RegionPixels>& regions) const {
    const double gap = params_.merge_gap_m / picture_.pixel_m + 1.0;  // neighbours are one pixel apart without a gap
    const double distance = params_.merge_distance_m / picture_.pixel_m;
    const int saddle = levelsFromDb(params_.merge_saddle_db), drop = levelsFromDb(params_.merge_peak_drop_db);
    std::vector<Extent> extents;
    for (const RegionPixels& region : regions) extents.push_back(extentOf(region));
    for (std::size_t i = 0; i < regions.size(); ++i) {
        for (std::size_t j = i + 1; j < regions.size(); ++j) {
            const int lower_peak = std::min(regions[i].peak.level, regions[j].peak.level);
            if (std::abs(regions[i].peak.level - regions[j].peak.level) > drop) continue;
            const Extent &a = extents[i], &b = extents[j];
            const bool near = squaredDistance(a.row, a.column, b.row, b.column) <= distance * distance;
            if (!near && !within(regions[i], a, regions[j], b, gap)) continue;
            if (saddleLevel(regions[i], regions[j]) < lower_peak - saddle) continue;
            auto& into = regions[i].pixels;
            into.insert(into.end(), regions[j].pixels.begin(), regions[j].pixels.end());
            if (strongerFirst(regions[j].peak, regions[i].peak)) regions[i].peak = regions[j].peak;
            extents[i] = extentOf(regions[i]);
            regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(j));
            extents.erase(extents.begin() + static_cast<std::ptrdiff_t>(j));
            j = i;  // the larger region may reach others now
        }
    }
}

/// Mean level on a ring about a pixel.
int RegionGrower::ringLevel(int row, int column) const {
    constexpr int points = 24;
    const double radius = ring_radius_m / picture_.pixel_m;
    int sum = 0, count = 0;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * CV_PI * i / points;
        const int r = row + static_cast<int>(std::lround(radius * std::sin(angle)));
        const int c = column + static_cast<int>(std::lround(radius * std::cos(angle)));
        if (r < 0 || c < 0 || r >= picture_.levels.rows || c >= picture_.levels.cols) continue;
        sum += picture_.levels.ptr(r)[c];
        ++count;
    }
    return count == 0 ? 0 : sum / count;
}

/// Peaks inside a clutter mass that stand out from it: each is grown again within half the contrast of its peak.
std::vector<RegionPixels> RegionGrower::reseed(const RegionPixels& mass) {
    const int contrast = levelsFromDb(params_.reseed_contrast_db);
    const Limits tight{levelsFromDb(params_.grow_excess_db), contrast / 2, levelsFromDb(params_.deviation_floor_db),
                       levelsFromDb(params_.edge_db_per_pixel)};
    for (const RegionPixel& pixel : mass.pixels) taken(pixel.row, pixel.column) = 0;
    const double max_pixels = params_.max_area_m2 / (picture_.pixel_m * picture_.pixel_m);
    std::vector<RegionPixel> pixels = mass.pixels;
    std::sort(pixels.begin(), pixels.end(), strongerFirst);
    std::vector<RegionPixels> found;
    for (const RegionPixel& seed : pixels) {
        if (seed.excess < seed_excess_ || taken(seed.row, seed.column) || !isPeak(seed) ||
            seed.level - ringLevel(seed.row, seed.column) < contrast)
            continue;
        RegionPixels region = grow(seed, tight);
        if (static_cast<double>(region.pixels.size()) <= max_pixels) found.push_back(std::move(region));
    }
    return found;
}

}  // namespace echotrail
