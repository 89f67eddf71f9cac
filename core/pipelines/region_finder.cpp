#include "core/pipelines/region_finder.hpp"

#include "core/features/region_shape.hpp"
#include "core/imaging/filters.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr std::uint64_t flank_pings = EchoScreen::closing_pings;
constexpr double flank_m = 1.0;                // of the tile beyond the strong cells
constexpr double pixels_per_range = 400.0;     // of the tiles: regions must not depend on the display's fan
constexpr std::uint64_t longest_sweep = 2048;  // rows; of a longer one the last ones are looked at
constexpr double same_peak_s = 2.0;            // two candidates of a sweep show the same region within this time
constexpr MultipathRule multipath{.farthest_m = 3.0, .weaker_db = 6.0};

int levelsFromDb(double db) { return static_cast<int>(std::lround(db * levels_per_db)); }

/// A header onto `memory`, which grows when needed and is never given back: no allocation per candidate.
cv::Mat viewOf(cv::Mat& memory, int rows, int columns, int type, const cv::Scalar& fill) {
    if (memory.total() < static_cast<std::size_t>(rows) * columns) memory.create(1, rows * columns, type);
    cv::Mat view(rows, columns, type, memory.data);
    view.setTo(fill);
    return view;
}

}  // namespace

RegionFinder::RegionFinder(const RegionFinderParams& params, const LocalEnhancementParams& enhancement)
    : params_(params),
      enhancement_(enhancement),
      conditioner_(params.conditioner),
      screen_(params.screen),
      grower_(params.grower),
      rows_(longest_sweep) {}

void RegionFinder::setParams(const RegionFinderParams& params, const LocalEnhancementParams& enhancement) {
    params_ = params;
    enhancement_ = enhancement;
    conditioner_.setParams(params.conditioner);
    screen_.setParams(params.screen);
    grower_.setParams(params.grower);
}

void RegionFinder::breakOff(std::vector<Region>& regions) {
    candidates_.clear();
    screen_.endSweep(candidates_);
    if (waitsForSweep()) {
        growInSweep(regions);
    } else {
        for (const Candidate& candidate : candidates_) growRegions(candidate, regions);
    }
    flagMultipath(regions);
    sweep_first_row_ = next_row_;
    found_.clear();  // the beam sees the same place again on its way back: another look at it
}

void RegionFinder::add(const Ping& ping, const Ray& ray, const Pose& head, Timestamp epoch,
                       std::span<const RangeOfInterest> interests, std::vector<Region>& regions) {
    epoch_ = epoch;
    Row& row = rowAt(next_row_);
    conditioner_.condition(ping, row.echo);
    row.ray = ray;
    row.ray.levels = row.echo.level;
    row.ray.bin_size_m = row.echo.cell_m;
    row.head = head;
    row.time = ping.time;
    row.pixel_m = ping.range_scale_m / pixels_per_range;
    ++next_row_;
    candidates_.clear();
    screen_.add(row.echo, interests, candidates_);
    if (waitsForSweep()) return;
    for (const Candidate& candidate : candidates_) growRegions(candidate, regions);
    flagMultipath(regions);
}

bool RegionFinder::isOpenWithin(double near_m, double far_m) const {
    // The ping that begins a sweep comes together with the regions of the last one.
    return waitsForSweep() ? next_row_ > sweep_first_row_ + 1 : screen_.isOpenWithin(near_m, far_m);
}

std::uint64_t RegionFinder::sweepFirstRow() const {
    return std::max(sweep_first_row_, next_row_ > rows_.size() ? next_row_ - rows_.size() : 0);
}

BeamLine RegionFinder::lastLine() const {
    if (next_row_ == 0) return {};
    const Row& row = rowAt(next_row_ - 1);
    BeamLine line{.time = row.time, .cell_m = row.echo.cell_m, .level = row.echo.smooth};
    const auto excess = screen_.lastThreshold();
    line.threshold.assign(line.level.size(), BeamLine::never);
    for (std::size_t i = 0; i < std::min(excess.size(), line.level.size()); ++i)
        line.threshold[i] =
            static_cast<std::uint8_t>(std::min<int>(row.echo.background[i] + excess[i], BeamLine::never));
    return line;
}

std::optional<Timestamp> RegionFinder::settledUntil() const {
    if (next_row_ == sweep_first_row_) return std::nullopt;
    if (waitsForSweep()) return rowAt(sweepFirstRow()).time;
    const std::uint64_t oldest = screen_.oldestOpenRow();
    const std::uint64_t first = oldest > sweep_first_row_ + flank_pings ? oldest - flank_pings : sweep_first_row_;
    return rowAt(std::min(first, next_row_ - 1)).time;
}

/// Paints the part of the fan that holds the candidate with its flanks, and grows regions in it.
void RegionFinder::growRegions(const Candidate& candidate, std::vector<Region>& regions) {
    const std::uint64_t first =
        candidate.first_ping < sweep_first_row_ + flank_pings ? sweep_first_row_ : candidate.first_ping - flank_pings;
    const std::uint64_t last = std::min(candidate.last_ping + flank_pings, next_row_ - 1);
    const double cell_m = rowAt(candidate.last_ping).echo.cell_m;
    const double near_m = candidate.first_cell * cell_m, far_m = (candidate.last_cell + 1) * cell_m;
    if (!layTile(first, last, std::max(near_m - flank_m, 0.0), far_m + flank_m)) return;
    paintTile(first, last, std::max(near_m - flank_m, 0.0), far_m + flank_m);
    paintBackground(first, last, std::max(near_m - flank_m, 0.0), far_m + flank_m);
    smoothGaussian(tile_.levels, params_.smoothing);

    const double lowering = candidate.of_interest ? params_.screen.interest_lowering_db : 0.0;
    const int seed_excess = std::max(levelsFromDb(params_.screen.seed_excess_db - lowering), 1);
    // What lies in the flanks is another candidate's, which has flanks of its own there.
    for (const RegionPixels& pixels : grower_(tile_, background_tile_.levels, seed_excess))
        keepRegion(pixels, first, last, {near_m - cell_m, far_m + cell_m}, regions);
}

/// The same in the whole picture of the sweep. What is nearer than the blanked range is no region here.
void RegionFinder::growInSweep(std::vector<Region>& regions) {
    const std::uint64_t first = sweepFirstRow();
    if (next_row_ <= first + 1) return;
    const std::uint64_t last = next_row_ - 1;
    const EchoRow& line = rowAt(last).echo;
    const double far_m = line.cell_m * static_cast<double>(line.level.size());
    if (!layTile(first, last, 0.0, far_m)) return;
    paintTile(first, last, 0.0, far_m);
    smoothGaussian(tile_.levels, params_.smoothing);
    if (params_.picture.detect_on == DetectOn::EnhancedSweep)
        enhanceLocally(tile_, enhancement_).levels.copyTo(tile_.levels);
    const int seed_excess = std::max(levelsFromDb(params_.screen.seed_excess_db), 1);
    for (const RegionPixels& pixels : grower_(tile_, medianBackground(tile_), seed_excess))
        keepRegion(pixels, first, last, {params_.screen.blank_range_m, far_m}, regions);
    std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) { return a.time < b.time; });
}

/// Measures a region of the tile, which shows rows `first` to `last`; it counts if it is new and `inside`.
void RegionFinder::keepRegion(const RegionPixels& pixels, std::uint64_t first, std::uint64_t last, RangeInterval inside,
                              std::vector<Region>& regions) {
    Region region = measureRegion(pixels, tile_, epoch_, params_.shape);
    const Row& row = rowNearest(region.time, first, last);
    seenFromHead(region, pixels, tile_, row.head);
    if (region.range_m < inside.near_m || region.range_m > inside.far_m || !isNew(pixels, region.time)) return;
    region.beam_hits = beamHits(region, first, last);
    region.only_expected =
        region.contrast_db < params_.screen.seed_excess_db || region.range_m < params_.screen.blank_range_m;
    region.id = next_id_++;
    regions.push_back(std::move(region));
}

/// Places the tile about the rays' ends on the pixel grid of the whole fan. False where there is nothing to paint.
bool RegionFinder::layTile(std::uint64_t first, std::uint64_t last, double near_m, double far_m) {
    const double pixel = rowAt(last).pixel_m;
    if (last <= first || !(pixel > 0)) return false;
    double north_most = -1e12, south_most = 1e12, east_most = -1e12, west_most = 1e12;
    for (std::uint64_t k = first; k <= last; ++k) {
        for (const double range : {near_m, far_m}) {
            const Eigen::Vector2d end = rowAt(k).ray.at(range);
            north_most = std::max(north_most, end.x());
            south_most = std::min(south_most, end.x());
            east_most = std::max(east_most, end.y());
            west_most = std::min(west_most, end.y());
        }
    }
    constexpr int margin = 3;  // pixels: for the smoothing, and the arc between two rays
    const auto grid = [pixel](double metres) { return static_cast<int>(std::floor(metres / pixel)); };
    const int top = grid(north_most) + margin, bottom = grid(south_most) - margin;
    const int left = grid(west_most) - margin, right = grid(east_most) + margin;
    const int rows = top - bottom + 1, columns = right - left + 1;
    const auto lay = [&](FanImage& tile, cv::Mat& memory, cv::Mat& time_memory) {
        tile.levels = viewOf(memory, rows, columns, CV_8U, 0);
        tile.beam_time_ms = viewOf(time_memory, rows, columns, CV_32S, FanImage::never_scanned);
        tile.pixel_m = pixel;
        tile.north_m = top * pixel;
        tile.east_m = left * pixel;
    };
    lay(tile_, tile_memory_, time_memory_);
    lay(background_tile_, background_memory_, background_time_memory_);
    return true;
}

void RegionFinder::paintTile(std::uint64_t first, std::uint64_t last, double near_m, double far_m) {
    for (std::uint64_t k = first + 1; k <= last; ++k)
        paintWedge(rowAt(k - 1).ray, rowAt(k).ray, {near_m, far_m}, tile_);
}

void RegionFinder::paintBackground(std::uint64_t first, std::uint64_t last, double near_m, double far_m) {
    for (std::uint64_t k = first + 1; k <= last; ++k) {
        const Row& a = rowAt(k - 1);
        const Row& b = rowAt(k);
        Ray background_a = a.ray, background_b = b.ray;
        background_a.levels = a.echo.background;
        background_b.levels = b.echo.background;
        paintWedge(background_a, background_b, {near_m, far_m}, background_tile_);
    }
}

/// Whether this peak was not found before: candidates that touch paint the same place twice.
bool RegionFinder::isNew(const RegionPixels& pixels, Timestamp time) {
    const int row = static_cast<int>(std::lround(tile_.north_m / tile_.pixel_m)) - pixels.peak.row;
    const int column = static_cast<int>(std::lround(tile_.east_m / tile_.pixel_m)) + pixels.peak.column;
    while (!found_.empty() && secondsBetween(found_.front().time, time) > same_peak_s) found_.pop_front();
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const FoundPeak& peak) {
        return std::abs(peak.row - row) <= 1 && std::abs(peak.column - column) <= 1 &&
               std::abs(secondsBetween(peak.time, time)) < same_peak_s;
    });
    if (!known) found_.push_back({time, row, column});
    return !known;
}

const RegionFinder::Row& RegionFinder::rowNearest(Timestamp time, std::uint64_t first, std::uint64_t last) const {
    std::uint64_t nearest = first;
    for (std::uint64_t k = first; k <= last; ++k)
        if (std::abs(secondsBetween(rowAt(k).time, time)) < std::abs(secondsBetween(rowAt(nearest).time, time)))
            nearest = k;
    return rowAt(nearest);
}

/// Pings that met the region: whose own line stands out at the region's ranges, next to each other about its time.
int RegionFinder::beamHits(const Region& region, std::uint64_t first, std::uint64_t last) const {
    const int grow = levelsFromDb(params_.grower.grow_excess_db);
    const double half = region.features.along_range_m / 2.0;
    const auto meets = [&](const Row& row) {
        const int cells = static_cast<int>(row.echo.level.size());
        const int begin = std::clamp(static_cast<int>((region.range_m - half) / row.echo.cell_m), 0, cells);
        const int end = std::clamp(static_cast<int>((region.range_m + half) / row.echo.cell_m) + 1, 0, cells);
        for (int i = begin; i < end; ++i)
            if (row.echo.smooth[i] - row.echo.background[i] >= grow) return true;
        return false;
    };
    std::uint64_t middle = first;
    for (std::uint64_t k = first; k <= last; ++k)
        if (std::abs(secondsBetween(rowAt(k).time, region.time)) <
            std::abs(secondsBetween(rowAt(middle).time, region.time)))
            middle = k;
    int hits = meets(rowAt(middle)) ? 1 : 0;
    for (std::uint64_t k = middle; k > first && meets(rowAt(k - 1)); --k) ++hits;
    for (std::uint64_t k = middle; k < last && meets(rowAt(k + 1)); ++k) ++hits;
    return hits;
}

/// An echo at the bearing of a stronger one, a little further off and much weaker, has bounced on its way.
void RegionFinder::flagMultipath(std::vector<Region>& regions) {
    recent_.add(regions);
    for (Region& region : regions) region.multipath = region.multipath || recent_.explain(region, multipath);
}

}  // namespace echotrail
