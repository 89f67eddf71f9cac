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

struct Centre {
    double row = 0, column = 0;
};
Centre centreOf(const RegionPixels& region) {
    Centre centre;
    for (const RegionPixel& pixel : region.pixels) {
        centre.row += pixel.row;
        centre.column += pixel.column;
    }
    const auto n = static_cast<double>(region.pixels.size());
    return {centre.row / n, centre.column / n};
}

struct Box {
    int top = INT16_MAX, bottom = INT16_MIN, left = INT16_MAX, right = INT16_MIN;
};
Box boxOf(const RegionPixels& region) {
    Box box;
    for (const RegionPixel& pixel : region.pixels) {
        box.top = std::min<int>(box.top, pixel.row);
        box.bottom = std::max<int>(box.bottom, pixel.row);
        box.left = std::min<int>(box.left, pixel.column);
        box.right = std::max<int>(box.right, pixel.column);
    }
    return box;
}

/// Whether any two pixels are within `gap` pixels of each other.
bool within(const RegionPixels& a, const RegionPixels& b, double gap) {
    const Box box = boxOf(b);
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
    labels_.create(picture.levels.size(), CV_32S);
    labels_.setTo(0);
    findSeeds(std::max(seed_excess, 1));

    const Limits limits{levelsFromDb(params_.grow_excess_db), levelsFromDb(params_.peak_drop_db),
                        levelsFromDb(params_.deviation_floor_db), levelsFromDb(params_.edge_db_per_pixel)};
    const double max_pixels = params_.max_area_m2 / (picture.pixel_m * picture.pixel_m);
    std::vector<RegionPixels> regions;
    std::uint32_t label = 0;
    for (const Seed& seed : seeds_)
        if (labels_.at<std::int32_t>(seed.row, seed.column) == 0) regions.push_back(grow(seed, limits, ++label));
    merge(regions);

    std::vector<RegionPixels> inside;
    for (RegionPixels& region : regions) {
        region.clutter_mass = static_cast<double>(region.pixels.size()) > max_pixels;
        if (!region.clutter_mass) continue;
        for (RegionPixels& found : reseed(region, label)) inside.push_back(std::move(found));
    }
    std::move(inside.begin(), inside.end(), std::back_inserter(regions));
    std::erase_if(regions,
                  [&](const RegionPixels& r) { return static_cast<int>(r.pixels.size()) < params_.min_pixels; });
    std::sort(regions.begin(), regions.end(),
              [](const RegionPixels& a, const RegionPixels& b) { return strongerFirst(a.peak, b.peak); });
    return regions;
}

void RegionGrower::findSeeds(int seed_excess) {
    seeds_.clear();
    const cv::Mat& levels = picture_.levels;
    const auto isPeak = [&](int row, int column, int level) {
        for (int r = std::max(row - seed_radius, 0); r <= std::min(row + seed_radius, levels.rows - 1); ++r) {
            const std::uint8_t* line = levels.ptr(r);
            for (int c = std::max(column - seed_radius, 0); c <= std::min(column + seed_radius, levels.cols - 1); ++c)
                if (line[c] > level) return false;
        }
        return true;
    };
    for (int row = 0; row < levels.rows; ++row) {
        const std::uint8_t* excess = excess_.ptr(row);
        for (int column = 0; column < levels.cols; ++column) {
            if (excess[column] < seed_excess) continue;
            const int level = levels.ptr(row)[column];
            if (isPeak(row, column, level)) seeds_.push_back({level, row, column});
        }
    }
    std::stable_sort(seeds_.begin(), seeds_.end(), [](const Seed& a, const Seed& b) { return a.level > b.level; });
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
RegionPixels RegionGrower::grow(const Seed& seed, const Limits& limits, std::uint32_t label) {
    const cv::Mat& levels = picture_.levels;
    queue_.resize(256);
    int top = seed.level;
    const auto push = [&](int row, int column) {
        labels_.at<std::int32_t>(row, column) = static_cast<std::int32_t>(label);
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
                if (labels_.at<std::int32_t>(r, c) == 0) push(r, c);
    }
    for (const std::uint32_t place : refused)
        labels_.at<std::int32_t>(static_cast<int>(place >> 16), static_cast<int>(place & 0xFFFF)) = 0;
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
    const int saddle = levelsFromDb(params_.merge_saddle_db);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        for (std::size_t j = i + 1; j < regions.size(); ++j) {
            const int lower_peak = std::min(regions[i].peak.level, regions[j].peak.level);
            const Centre a = centreOf(regions[i]), b = centreOf(regions[j]);
            const bool near = squaredDistance(a.row, a.column, b.row, b.column) <= distance * distance;
            if (!near && !within(regions[i], regions[j], gap)) continue;
            if (saddleLevel(regions[i], regions[j]) < lower_peak - saddle) continue;
            auto& into = regions[i].pixels;
            into.insert(into.end(), regions[j].pixels.begin(), regions[j].pixels.end());
            if (strongerFirst(regions[j].peak, regions[i].peak)) regions[i].peak = regions[j].peak;
            regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(j));
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
std::vector<RegionPixels> RegionGrower::reseed(const RegionPixels& mass, std::uint32_t& label) {
    const int contrast = levelsFromDb(params_.reseed_contrast_db);
    const Limits tight{levelsFromDb(params_.grow_excess_db), contrast / 2, levelsFromDb(params_.deviation_floor_db),
                       levelsFromDb(params_.edge_db_per_pixel)};
    for (const RegionPixel& pixel : mass.pixels) labels_.at<std::int32_t>(pixel.row, pixel.column) = 0;
    const double max_pixels = params_.max_area_m2 / (picture_.pixel_m * picture_.pixel_m);
    std::vector<RegionPixels> found;
    for (const Seed& seed : seeds_) {
        if (labels_.at<std::int32_t>(seed.row, seed.column) != 0) continue;
        const bool inside = std::any_of(mass.pixels.begin(), mass.pixels.end(), [&](const RegionPixel& pixel) {
            return pixel.row == seed.row && pixel.column == seed.column;
        });
        if (!inside || seed.level - ringLevel(seed.row, seed.column) < contrast) continue;
        RegionPixels region = grow(seed, tight, ++label);
        if (static_cast<double>(region.pixels.size()) <= max_pixels) found.push_back(std::move(region));
    }
    return found;
}

}  // namespace echotrail
