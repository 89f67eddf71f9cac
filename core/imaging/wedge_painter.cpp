#include "core/imaging/wedge_painter.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <numbers>

namespace echotrail {
namespace {

constexpr double widest_gap_steps = 2.5;
constexpr double widest_wedge_rad = std::numbers::pi / 4.0;  // in the local frame, the vehicle's own turn included
// A pixel this close to a line belongs to both its wedges, so that rounding leaves no seam between them.
constexpr double shared_edge_px = 1.0 / 1024.0;

/// The wedge is painted in lines across the beam: along rows where the beam points more north or south, else along
/// columns. A pixel's `major` number names its line, `minor` its place in the line: whole pixels of the world's grid,
/// north and east positive.
struct Axes {
    bool rows;  ///< major is north, minor is east
    int base;   ///< minor numbers are told from here, near the head, so that single precision holds them
};

/// One of the wedge's two rays, in pixels.
struct Side {
    double origin_major;
    float origin_minor;       ///< from the base
    double ahead;             ///< +1 or -1: which way the line numbers grow along the beam
    double slope, curvature;  ///< on the axis, M lines from the head, minor = origin + M (slope + curvature M)
    float across;             ///< distance from the axis per pixel along the line
    float bins_per_pixel;     ///< of range; the head's movement along the beam lengthens or shortens it
    float near_px, far_px;    ///< painted ranges
    int last_pair;            ///< the last bin that has a next one
    const std::uint8_t* levels;
    std::int32_t time_ms;
};

Side sideOf(const Ray& ray, Axes axes, RangeInterval metres, double pixel) {
    const double north = std::cos(ray.azimuth_rad), east = std::sin(ray.azimuth_rad);
    const double major = axes.rows ? north : east, minor = axes.rows ? east : north;
    const double drift_major = axes.rows ? ray.drift_north : ray.drift_east;
    const double drift_minor = axes.rows ? ray.drift_east : ray.drift_north;
    const double clockwise = axes.rows ? 1.0 : -1.0;
    const double along = 1.0 + ray.drift_north * north + ray.drift_east * east;
    Side side{};
    side.origin_major = (axes.rows ? ray.origin_north_m : ray.origin_east_m) / pixel;
    side.origin_minor = static_cast<float>((axes.rows ? ray.origin_east_m : ray.origin_north_m) / pixel - axes.base);
    side.ahead = major > 0.0 ? 1.0 : -1.0;
    side.slope = (minor + drift_minor) / (major + drift_major);
    // At range r the turn has moved the axis sideways by turn * r * r; a line cuts it off at an angle, hence c^3.
    side.curvature = clockwise * ray.turn_rad_per_m * pixel / (major * major * major);
    side.across = static_cast<float>(std::abs(major));
    side.bins_per_pixel = static_cast<float>(pixel / (ray.bin_size_m * along));
    side.near_px = static_cast<float>(metres.near_m * along / pixel);
    side.far_px = static_cast<float>(std::min(metres.far_m, ray.farEnd()) * along / pixel);
    side.last_pair = static_cast<int>(ray.levels.size()) - 2;
    side.levels = ray.levels.data();
    side.time_ms = ray.time_ms;
    return side;
}

bool isWedge(const Ray& previous, const Ray& current) {
    const double turned = std::abs(current.head_bearing - previous.head_bearing);
    const double wedge = std::abs(wrapRadians(current.azimuth_rad - previous.azimuth_rad));
    return turned > 0.0 && turned <= widest_gap_steps * previous.step_rad && wedge <= widest_wedge_rad &&
           previous.levels.size() >= 2 && current.levels.size() >= 2 && previous.bin_size_m > 0.0 &&
           current.bin_size_m > 0.0;
}

/// What a line of the wedge has in common.
struct Line {
    float squared[2];  ///< of its distance from the heads
    float edge[2];     ///< where the rays' axes cut it, from the base
};

constexpr int block_pixels = 8;

/// Up to eight neighbouring pixels: computed together without branches, so that the compiler makes vector
/// instructions of it.
struct Block {
    std::array<float, block_pixels> level;
    std::array<std::int32_t, block_pixels> time_ms;
    std::array<std::int32_t, block_pixels> inside;
};

struct Wedge {
    Side side[2];
};

void sampleRay(const Side& side, const std::array<float, block_pixels>& range, std::array<float, block_pixels>& level) {
    std::array<std::int32_t, block_pixels> pair;
    std::array<float, block_pixels> fraction;
    const float last = static_cast<float>(side.last_pair);
    for (int k = 0; k < block_pixels; ++k) {
        const float bin = std::min(std::max(range[k] * side.bins_per_pixel - 0.5F, 0.0F), last + 1.0F);
        pair[k] = static_cast<std::int32_t>(std::min(bin, last));
        fraction[k] = bin - static_cast<float>(pair[k]);
    }
    std::array<std::int32_t, block_pixels> levels;  // of both bins: one in the low byte, the next above it
    for (int k = 0; k < block_pixels; ++k) {
        std::uint16_t both;
        std::memcpy(&both, side.levels + pair[k], sizeof both);
        levels[k] = both;
    }
    for (int k = 0; k < block_pixels; ++k) {
        const float nearer = static_cast<float>(levels[k] & 0xFF), farther = static_cast<float>(levels[k] >> 8);
        level[k] = nearer + fraction[k] * (farther - nearer);
    }
}

void compute(const Wedge& wedge, const Line& line, int first, Block& block) {
    const Side &a = wedge.side[0], &b = wedge.side[1];
    std::array<float, block_pixels> range_a, range_b, share, level_a, level_b;
    for (int k = 0; k < block_pixels; ++k) {
        const float x = static_cast<float>(first + k);
        const float ma = x - a.origin_minor, mb = x - b.origin_minor;
        range_a[k] = std::sqrt(line.squared[0] + ma * ma);
        range_b[k] = std::sqrt(line.squared[1] + mb * mb);
        const float from_a = (x - line.edge[0]) * a.across, from_b = (line.edge[1] - x) * b.across;
        const float u = from_a / (from_a + from_b);
        share[k] = u > 0.0F ? std::min(u, 1.0F) : 0.0F;  // where the lines cross it is not a number
        block.time_ms[k] = u < 0.5F ? a.time_ms : b.time_ms;
        block.inside[k] =
            (range_a[k] >= a.near_px) & (range_a[k] <= a.far_px) & (range_b[k] >= b.near_px) & (range_b[k] <= b.far_px);
    }
    sampleRay(a, range_a, level_a);
    sampleRay(b, range_b, level_b);
    for (int k = 0; k < block_pixels; ++k) block.level[k] = level_a[k] + share[k] * (level_b[k] - level_a[k]);
}

/// Where the tile lies on the world's grid, seen along the wedge's axes.
struct Window {
    int first_major, last_major, first_minor, last_minor;
    std::ptrdiff_t origin, major_step, minor_step;  ///< element number of (major, minor) in the tile
};

Window windowOf(const FanImage& tile, Axes axes) {
    const int top = static_cast<int>(std::lround(tile.north_m / tile.pixel_m));
    const int left = static_cast<int>(std::lround(tile.east_m / tile.pixel_m));
    const int bottom = top - tile.levels.rows + 1, right = left + tile.levels.cols - 1;
    const std::ptrdiff_t row_step = tile.levels.cols;
    if (axes.rows) return {bottom, top, left, right, top * row_step - left, -row_step, 1};
    return {left, right, bottom, top, top * row_step - left, 1, -row_step};
}

/// The lines that the wedge can reach: between its nearest and its farthest point along the major axis.
std::pair<int, int> linesOf(const Wedge& wedge, const Window& window) {
    double nearest = 1e9, farthest = 0.0;
    const bool holds_axis = wedge.side[0].slope * wedge.side[1].slope <= 0.0;
    for (const Side& side : wedge.side) {
        nearest = std::min(nearest, double{side.near_px} * side.across);
        farthest = std::max(farthest, double{side.far_px} * (holds_axis ? 1.0F : side.across));
    }
    const double ahead = wedge.side[0].ahead;
    const auto [low_origin, high_origin] = std::minmax(wedge.side[0].origin_major, wedge.side[1].origin_major);
    const double begin = (ahead > 0 ? low_origin + nearest : low_origin - farthest) - 1.0;
    const double end = (ahead > 0 ? high_origin + farthest : high_origin - nearest) + 1.0;
    return {static_cast<int>(std::floor(std::max(begin, double(window.first_major)))),
            static_cast<int>(std::ceil(std::min(end, double(window.last_major))))};
}

}  // namespace

void paintWedge(const Ray& previous, const Ray& current, RangeInterval metres, FanImage& tile) {
    assert(tile.pixel_m > 0.0 && tile.levels.size() == tile.beam_time_ms.size());
    assert(tile.levels.isContinuous() && tile.beam_time_ms.isContinuous());
    if (!isWedge(previous, current)) return;
    const double middle = previous.azimuth_rad + wrapRadians(current.azimuth_rad - previous.azimuth_rad) / 2.0;
    const bool rows = std::abs(std::cos(middle)) >= std::abs(std::sin(middle));
    const double origin_minor = rows ? previous.origin_east_m : previous.origin_north_m;
    const Axes axes{rows, static_cast<int>(std::floor(origin_minor / tile.pixel_m))};
    const Wedge wedge{{sideOf(previous, axes, metres, tile.pixel_m), sideOf(current, axes, metres, tile.pixel_m)}};
    const Window window = windowOf(tile, axes);

    const auto [first_line, last_line] = linesOf(wedge, window);
    for (int major = first_line; major <= last_line; ++major) {
        Line line{};
        bool behind = false;
        double low = 1e9, high = -1e9;
        for (int i = 0; i < 2; ++i) {
            const Side& side = wedge.side[i];
            const double lines = major - side.origin_major;
            behind |= lines * side.ahead < 0.0;
            const double edge = double{side.origin_minor} + lines * (side.slope + side.curvature * lines);
            line.squared[i] = static_cast<float>(lines * lines);
            line.edge[i] = static_cast<float>(edge);
            low = std::min(low, edge);
            high = std::max(high, edge);
        }
        if (behind) continue;
        const int first = std::max(static_cast<int>(std::ceil(low - shared_edge_px)), window.first_minor - axes.base);
        const int last = std::min(static_cast<int>(std::floor(high + shared_edge_px)), window.last_minor - axes.base);
        const std::ptrdiff_t start = window.origin + major * window.major_step + axes.base * window.minor_step;
        for (int minor = first; minor <= last; minor += block_pixels) {
            Block block;
            compute(wedge, line, minor, block);
            const int count = std::min(block_pixels, last - minor + 1);
            for (int k = 0; k < count; ++k) {
                if (!block.inside[k]) continue;
                const std::ptrdiff_t element = start + (minor + k) * window.minor_step;
                tile.levels.data[element] = static_cast<std::uint8_t>(block.level[k] + 0.5F);
                tile.beam_time_ms.ptr<std::int32_t>()[element] = block.time_ms[k];
            }
        }
    }
}

}  // namespace echotrail
