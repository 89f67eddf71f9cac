#include "core/imaging/wedge_painter.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

namespace echotrail {
namespace {

constexpr double widest_gap_steps = 2.5;
constexpr double widest_wedge_rad = std::numbers::pi / 4.0;  // in the local frame, the vehicle's own turn included
constexpr double farthest_m = 1e6;                           // from the local frame's origin: pixel numbers are ints
// A pixel this close to a ray belongs to both its wedges, so that rounding leaves no seam between them.
constexpr float shared_edge_px = 1.0F / 1024.0F;

// Everything below is done in stages over small arrays, in single precision and without branches: that is what
// compilers turn into vector instructions. Only sums, products, quotients and square roots are used, which are rounded
// alike by all of them, so every build paints the same bytes.

/// The wedge is painted in lines across the beam: along rows where the beam points more north or south, else along
/// columns. A pixel's `major` number names its line, `minor` its place in the line. Both are whole pixels of the
/// world's grid, north and east positive, told from a base near the head.
struct Axes {
    bool rows;  ///< major is north, minor is east
    int base_major, base_minor;
};

/// One of the wedge's two rays, in pixels.
struct Side {
    float origin_major, origin_minor;  ///< from the base
    float ahead;                       ///< +1 or -1: which way the line numbers grow along the beam
    float slope, curvature;            ///< on the axis, M lines from the head, minor = origin + M (slope + curvature M)
    float across;                      ///< distance from the axis per pixel along a line
    float bins_per_pixel;              ///< of range; the head's movement along the beam makes it more or less
    float near_px, far_px;             ///< painted ranges
    float last_pair;                   ///< the last bin that has a next one
    std::vector<std::int32_t> pairs;   ///< each bin's level, and above it the next one's: fetched together
    std::int32_t time_ms;
};

Side sideOf(const Ray& ray, const Axes& axes, RangeInterval metres, double pixel) {
    const double north = std::cos(ray.azimuth_rad), east = std::sin(ray.azimuth_rad);
    const double major = axes.rows ? north : east, minor = axes.rows ? east : north;
    const double drift_major = axes.rows ? ray.drift_north : ray.drift_east;
    const double drift_minor = axes.rows ? ray.drift_east : ray.drift_north;
    const double origin_major = axes.rows ? ray.origin_north_m : ray.origin_east_m;
    const double origin_minor = axes.rows ? ray.origin_east_m : ray.origin_north_m;
    const double clockwise = axes.rows ? 1.0 : -1.0;
    const double along = 1.0 + ray.drift_north * north + ray.drift_east * east;
    Side side{};
    side.origin_major = static_cast<float>(origin_major / pixel - axes.base_major);
    side.origin_minor = static_cast<float>(origin_minor / pixel - axes.base_minor);
    side.ahead = major > 0.0 ? 1.0F : -1.0F;
    side.slope = static_cast<float>((minor + drift_minor) / (major + drift_major));
    // At range r = M / major the turn has moved the axis sideways by turn * r * r; a line cuts that at an angle.
    side.curvature = static_cast<float>(clockwise * ray.turn_rad_per_m * pixel / (major * major * major));
    side.across = static_cast<float>(std::abs(major));
    side.bins_per_pixel = static_cast<float>(pixel / (ray.bin_size_m * along));
    side.near_px = static_cast<float>(metres.near_m * along / pixel);
    side.far_px = static_cast<float>(std::min(metres.far_m, ray.farEnd()) * along / pixel);
    side.last_pair = static_cast<float>(ray.levels.size() - 2);
    side.pairs.resize(ray.levels.size() - 1);
    for (std::size_t i = 0; i < side.pairs.size(); ++i) side.pairs[i] = ray.levels[i] | ray.levels[i + 1] << 8;
    side.time_ms = ray.time_ms;
    return side;
}

/// Where the tile lies, seen along the wedge's axes and from their base.
struct Window {
    int first_major, last_major, first_minor, last_minor;
    std::int32_t origin, major_step, minor_step;  ///< pixel (major, minor) is element origin + … of the tile
};

Window windowOf(const FanImage& tile, const Axes& axes) {
    const int north = axes.rows ? axes.base_major : axes.base_minor;
    const int east = axes.rows ? axes.base_minor : axes.base_major;
    const int top = static_cast<int>(std::lround(tile.north_m / tile.pixel_m)) - north;
    const int left = static_cast<int>(std::lround(tile.east_m / tile.pixel_m)) - east;
    const int bottom = top - tile.levels.rows + 1, right = left + tile.levels.cols - 1;
    const int row_step = tile.levels.cols, origin = top * row_step - left;
    if (axes.rows) return {bottom, top, left, right, origin, -row_step, 1};
    return {left, right, bottom, top, origin, 1, -row_step};
}

constexpr int lines_at_once = 64;
constexpr int pixels_at_once = 256;
constexpr int block_pixels = 8;
template <class T>
using PerLine = T[lines_at_once];  // GCC 12 does not vectorise loops that store to a std::array member
template <class T>
using PerPixel = T[pixels_at_once];

/// Consecutive lines of a wedge: what all pixels of a line have in common.
struct Lines {
    PerLine<float> squared_a, squared_b;  ///< of the distance from each head
    PerLine<float> edge_a, edge_b;        ///< where the rays' axes cut the line
    PerLine<int> first, last;             ///< pixels between the axes and in the tile; none where last < first
};

/// Pixels of a wedge, of any lines. a is the previous ray, b the current one.
struct Pixels {
    int count = 0;
    PerPixel<float> squared_a, squared_b;  ///< of the range from each head
    PerPixel<float> from_a, from_b;        ///< distance from each axis
    PerPixel<std::int32_t> element;        ///< of the tile
};

// std::ceil and std::floor would keep the loops from being vectorised.
int ceilToInt(float value) {
    const int truncated = static_cast<int>(value);
    return truncated + (static_cast<float>(truncated) < value);
}

int floorToInt(float value) {
    const int truncated = static_cast<int>(value);
    return truncated - (static_cast<float>(truncated) > value);
}

Lines linesFrom(int first_line, const Side& a, const Side& b, const Window& window) {
    const float lowest = static_cast<float>(window.first_minor), highest = static_cast<float>(window.last_minor);
    const float none = lowest - 1.0F;
    Lines lines;
    for (int i = 0; i < lines_at_once; ++i) {
        const float major = static_cast<float>(first_line + i);
        const float from_a = major - a.origin_major, from_b = major - b.origin_major;
        const float edge_a = a.origin_minor + from_a * (a.slope + a.curvature * from_a);
        const float edge_b = b.origin_minor + from_b * (b.slope + b.curvature * from_b);
        const float low = std::max(std::min(edge_a, edge_b) - shared_edge_px, lowest);
        const float high = std::min(std::max(edge_a, edge_b) + shared_edge_px, highest);
        const float behind = std::min(from_a * a.ahead, from_b * b.ahead);
        lines.squared_a[i] = from_a * from_a;
        lines.squared_b[i] = from_b * from_b;
        lines.edge_a[i] = edge_a;
        lines.edge_b[i] = edge_b;
        lines.first[i] = ceilToInt(low);
        lines.last[i] = floorToInt(behind < 0.0F ? none : high);
    }
    return lines;
}

class Painter {
public:
    Painter(const Side& a, const Side& b, const Window& window, FanImage& tile)
        : a_(a), b_(b), window_(window), tile_(tile) {}
    void paint();

private:
    void collectPixels(const Lines& lines, int first_line, int line_count);
    void paintPixels();

    const Side &a_, &b_;
    const Window window_;
    FanImage& tile_;
    Pixels pixels_{};  ///< whole blocks are computed, so what lies beyond the count must be numbers, too
};

/// The lines that the wedge can reach: between its nearest and its farthest point along the major axis.
std::pair<int, int> linesOf(const Side& a, const Side& b, const Window& window) {
    const bool holds_major_axis = a.slope * b.slope <= 0.0F;
    const float nearest = std::min(a.near_px * a.across, b.near_px * b.across);
    const float farthest =
        holds_major_axis ? std::max(a.far_px, b.far_px) : std::max(a.far_px * a.across, b.far_px * b.across);
    const auto [low, high] = std::minmax(a.origin_major, b.origin_major);
    const float begin = (a.ahead > 0.0F ? low + nearest : low - farthest) - 1.0F;
    const float end = (a.ahead > 0.0F ? high + farthest : high - nearest) + 1.0F;
    return {static_cast<int>(std::max(begin, static_cast<float>(window.first_major))),
            static_cast<int>(std::min(end, static_cast<float>(window.last_major)))};
}

void Painter::paint() {
    const auto [first, last] = linesOf(a_, b_, window_);
    for (int line = first; line <= last; line += lines_at_once) {
        collectPixels(linesFrom(line, a_, b_, window_), line, std::min(lines_at_once, last - line + 1));
    }
    paintPixels();
}

void Painter::collectPixels(const Lines& lines, int first_line, int line_count) {
    const float origin_a = a_.origin_minor, origin_b = b_.origin_minor, scale_a = a_.across, scale_b = b_.across;
    const int minor_step = window_.minor_step;
    for (int i = 0; i < line_count; ++i) {
        const float squared_a = lines.squared_a[i], squared_b = lines.squared_b[i];
        const float edge_a = lines.edge_a[i], edge_b = lines.edge_b[i];
        const std::int32_t line_element = window_.origin + (first_line + i) * window_.major_step;
        for (int minor = lines.first[i]; minor <= lines.last[i]; minor += block_pixels) {
            if (pixels_.count > pixels_at_once - block_pixels) paintPixels();
            // A whole block each time; what is beyond the end of the line is overwritten by the next one.
            const int start = pixels_.count;
#pragma GCC unroll 1
            for (int k = 0; k < block_pixels; ++k) {
                const int at = start + k;
                const float x = static_cast<float>(minor + k);
                const float across_a = x - origin_a, across_b = x - origin_b;
                pixels_.squared_a[at] = squared_a + across_a * across_a;
                pixels_.squared_b[at] = squared_b + across_b * across_b;
                pixels_.from_a[at] = (x - edge_a) * scale_a;
                pixels_.from_b[at] = (edge_b - x) * scale_b;
                pixels_.element[at] = line_element + (minor + k) * minor_step;
            }
            pixels_.count = start + std::min(block_pixels, lines.last[i] - minor + 1);
        }
    }
}

/// The levels that a ray has at these ranges.
void sampleRay(const Side& side, const PerPixel<float>& range, int count, PerPixel<float>& level) {
    const std::int32_t* pairs = side.pairs.data();
    for (int i = 0; i < count; ++i) {
        const float bin = std::min(std::max(range[i] * side.bins_per_pixel - 0.5F, 0.0F), side.last_pair + 1.0F);
        const auto nearer_bin = static_cast<std::int32_t>(std::min(bin, side.last_pair));
        const std::int32_t pair = pairs[nearer_bin];
        const float nearer = static_cast<float>(pair & 0xFF), farther = static_cast<float>(pair >> 8);
        level[i] = nearer + (bin - static_cast<float>(nearer_bin)) * (farther - nearer);
    }
}

void Painter::paintPixels() {
    // Whole blocks: no loop needs a remainder.
    const int count = (pixels_.count + block_pixels - 1) / block_pixels * block_pixels;
    PerPixel<float> range_a, range_b, share, level_a, level_b;
    PerPixel<std::int32_t> time_ms, inside;
    const float near_a = a_.near_px, far_a = a_.far_px, near_b = b_.near_px, far_b = b_.far_px;
    const std::int32_t time_a = a_.time_ms, time_b = b_.time_ms;
    for (int i = 0; i < count; ++i) {
        range_a[i] = std::sqrt(pixels_.squared_a[i]);
        range_b[i] = std::sqrt(pixels_.squared_b[i]);
        const float u = pixels_.from_a[i] / (pixels_.from_a[i] + pixels_.from_b[i]);
        share[i] = u > 0.0F ? std::min(u, 1.0F) : 0.0F;  // where the axes cross it is not a number
        time_ms[i] = u < 0.5F ? time_a : time_b;
        inside[i] = (range_a[i] >= near_a) & (range_a[i] <= far_a) & (range_b[i] >= near_b) & (range_b[i] <= far_b);
    }
    sampleRay(a_, range_a, count, level_a);
    sampleRay(b_, range_b, count, level_b);
    PerPixel<std::int32_t> level;
    for (int i = 0; i < count; ++i)
        level[i] = static_cast<std::int32_t>(level_a[i] + share[i] * (level_b[i] - level_a[i]) + 0.5F);
    std::uint8_t* levels = tile_.levels.data;
    auto* times = tile_.beam_time_ms.ptr<std::int32_t>();
    for (int i = 0, end = pixels_.count; i < end; ++i) {
        if (!inside[i]) continue;
        const std::int32_t element = pixels_.element[i];
        levels[element] = static_cast<std::uint8_t>(level[i]);
        times[element] = time_ms[i];
    }
    pixels_.count = 0;
}

bool isWedge(const Ray& previous, const Ray& current) {
    const auto is_usable = [](const Ray& ray) {
        return ray.levels.size() >= 2 && ray.bin_size_m > 0.0 && std::abs(ray.origin_north_m) < farthest_m &&
               std::abs(ray.origin_east_m) < farthest_m;
    };
    const double turned = std::abs(current.head_bearing - previous.head_bearing);
    const double wedge = std::abs(wrapRadians(current.azimuth_rad - previous.azimuth_rad));
    return turned > 0.0 && turned <= widest_gap_steps * previous.step_rad && wedge <= widest_wedge_rad &&
           is_usable(previous) && is_usable(current);
}

}  // namespace

void paintWedge(const Ray& previous, const Ray& current, RangeInterval metres, FanImage& tile) {
    assert(tile.pixel_m > 0.0 && tile.levels.size() == tile.beam_time_ms.size());
    assert(tile.levels.isContinuous() && tile.beam_time_ms.isContinuous());
    if (!isWedge(previous, current)) return;
    const double middle = previous.azimuth_rad + wrapRadians(current.azimuth_rad - previous.azimuth_rad) / 2.0;
    const int north = static_cast<int>(std::floor(previous.origin_north_m / tile.pixel_m));
    const int east = static_cast<int>(std::floor(previous.origin_east_m / tile.pixel_m));
    const bool rows = std::abs(std::cos(middle)) >= std::abs(std::sin(middle));
    const Axes axes{rows, rows ? north : east, rows ? east : north};
    const Side a = sideOf(previous, axes, metres, tile.pixel_m), b = sideOf(current, axes, metres, tile.pixel_m);
    Painter(a, b, windowOf(tile, axes), tile).paint();
}

}  // namespace echotrail
