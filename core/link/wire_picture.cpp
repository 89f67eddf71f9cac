#include "core/link/link_limits.hpp"
#include "core/link/wire_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr double longest_range_m = 5'000.0, longest_bin_m = 50.0, fastest_mps = 100.0;

/// The strongest of each `detail` levels in a row: a small target stays visible.
std::string thinned(const std::vector<std::uint8_t>& levels, std::size_t detail) {
    std::string few;
    few.reserve(levels.size() / detail + 1);
    for (std::size_t i = 0; i < levels.size(); i += detail) {
        const auto from = levels.begin() + static_cast<std::ptrdiff_t>(i);
        const auto to = levels.begin() + static_cast<std::ptrdiff_t>(std::min(levels.size(), i + detail));
        few += static_cast<char>(*std::max_element(from, to));
    }
    return few;
}

bool readPing(const wire::Beam& in, Ping& ping) {
    const auto time = timeFrom(in.time_us());
    const bool sane = time && isSane(in.bearing_rad()) && in.step_rad() > 0.0 && in.step_rad() < std::numbers::pi &&
                      in.range_scale_m() > 0.0 && in.range_scale_m() <= longest_range_m && in.bin_interval_s() > 0.0 &&
                      in.sound_speed_mps() > 0.0 && isSane(in.bin_interval_s()) && isSane(in.sound_speed_mps()) &&
                      isSane(in.frequency_hz()) && isSane(in.gain_percent()) &&
                      in.levels().size() <= link_limits::most_levels;
    if (!sane) return false;
    ping.sequence = in.ping();
    ping.time = *time;
    ping.bearing = Bearing::radians(in.bearing_rad());
    ping.step_rad = in.step_rad();
    ping.range_scale_m = in.range_scale_m();
    ping.bin_interval_s = in.bin_interval_s();
    ping.sound_speed_mps = in.sound_speed_mps();
    ping.frequency_hz = in.frequency_hz();
    ping.gain_percent = in.gain_percent();
    ping.clockwise = in.clockwise();
    ping.levels.assign(in.levels().begin(), in.levels().end());
    const double far_m = ping.binSize() * static_cast<double>(ping.levels.size());
    return ping.binSize() <= longest_bin_m && far_m <= longest_range_m;
}

bool readMount(const wire::Mount& in, HeadSettings& mount) {
    constexpr double farthest_mount_m = 1'000.0;
    if (!isSane(in.heading_rad()) || !(std::abs(in.forward_m()) <= farthest_mount_m) ||
        !(std::abs(in.starboard_m()) <= farthest_mount_m))
        return false;
    mount.mount_heading_deg = degreesFromRadians(in.heading_rad());
    mount.mount_forward_m = in.forward_m();
    mount.mount_starboard_m = in.starboard_m();
    mount.mount_inverted = in.inverted();
    return true;
}

/// Nobody moves so far during one flight of sound; a picture painted from it could be of any size.
bool areNear(const Pose& a, const Pose& b, double flight_s) {
    return std::hypot(a.north_m - b.north_m, a.east_m - b.east_m) <= 1.0 + fastest_mps * flight_s;
}

}  // namespace

void write(const Pose& pose, wire::Pose& out) {
    out.set_north_m(pose.north_m);
    out.set_east_m(pose.east_m);
    out.set_heading_rad(pose.heading.inRadians());
}

std::optional<Pose> read(const wire::Pose& in) {
    if (!isSane(in.north_m()) || !isSane(in.east_m()) || !isSane(in.heading_rad())) return std::nullopt;
    return Pose{in.north_m(), in.east_m(), Bearing::radians(in.heading_rad())};
}

void write(const LinkBeam& beam, std::size_t detail, wire::Beam& out) {
    const Ping& ping = beam.ping;
    const Update& update = beam.update;
    out.set_ping(ping.sequence);
    out.set_time_us(microsecondsOf(ping.time));
    out.set_bearing_rad(ping.bearing.inRadians());
    out.set_step_rad(ping.step_rad);
    out.set_range_scale_m(ping.range_scale_m);
    out.set_bin_interval_s(ping.bin_interval_s * static_cast<double>(std::max<std::size_t>(detail, 1)));
    out.set_sound_speed_mps(ping.sound_speed_mps);
    out.set_frequency_hz(ping.frequency_hz);
    out.set_gain_percent(ping.gain_percent);
    out.set_clockwise(ping.clockwise);
    if (detail > 0) out.set_levels(thinned(ping.levels, detail));
    out.set_detail(static_cast<std::uint32_t>(detail));
    write(update.pose, *out.mutable_vehicle());
    write(update.later_pose, *out.mutable_vehicle_later());
    out.mutable_mount()->set_heading_rad(radiansFromDegrees(beam.mount.mount_heading_deg));
    out.mutable_mount()->set_forward_m(beam.mount.mount_forward_m);
    out.mutable_mount()->set_starboard_m(beam.mount.mount_starboard_m);
    out.mutable_mount()->set_inverted(beam.mount.mount_inverted);
    out.set_beam_rad(update.beam.inRadians());
    out.set_navigation_gap(update.navigation_gap);
    out.set_broke_off(update.broke_off);
    out.set_sweep(update.sweep);
    out.set_sweep_ended(update.sweep_ended);
    out.set_first_ping_us(microsecondsOf(beam.first_ping));
    out.set_navigation_known(beam.navigation_known);
}

std::optional<LinkBeam> read(const wire::Beam& in) {
    LinkBeam beam;
    const auto pose = read(in.vehicle());
    const auto later = read(in.vehicle_later());
    const auto first = timeFrom(in.first_ping_us());
    if (!readPing(in, beam.ping) || !readMount(in.mount(), beam.mount) || !pose || !later || !first ||
        !isSane(in.beam_rad()))
        return std::nullopt;
    const double flight_s = beam.ping.bin_interval_s * static_cast<double>(beam.ping.levels.size());
    if (!areNear(*pose, *later, flight_s)) return std::nullopt;
    beam.first_ping = *first;
    beam.navigation_known = in.navigation_known();
    beam.update = {.ping = beam.ping.sequence,
                   .time = beam.ping.time,
                   .pose = *pose,
                   .later_pose = *later,
                   .navigation_gap = in.navigation_gap(),
                   .beam = Bearing::radians(in.beam_rad()),
                   .broke_off = in.broke_off(),
                   .sweep = in.sweep(),
                   .sweep_ended = in.sweep_ended()};
    return beam;
}

void write(const RegionFeatures& features, wire::Features& out) {
    out.set_area_m2(features.area_m2);
    out.set_moment(features.moment);
    out.set_along_range_m(features.along_range_m);
    out.set_across_range_m(features.across_range_m);
    out.set_strength_db(features.strength_db);
    out.set_level_db(features.level_db);
}

std::optional<RegionFeatures> read(const wire::Features& in) {
    const RegionFeatures features{in.area_m2(),        in.moment(),      in.along_range_m(),
                                  in.across_range_m(), in.strength_db(), in.level_db()};
    for (const double value : {features.area_m2, features.moment, features.along_range_m, features.across_range_m,
                               features.strength_db, features.level_db})
        if (!isSane(value)) return std::nullopt;
    return features;
}

void write(const Region& region, wire::Region& out) {
    out.set_id(region.id);
    out.set_time_us(microsecondsOf(region.time));
    out.set_north_m(region.position_m.x());
    out.set_east_m(region.position_m.y());
    write(region.head, *out.mutable_head());
    out.set_range_m(region.range_m);
    out.set_bearing_rad(region.bearing.inRadians());
    write(region.features, *out.mutable_features());
    out.set_peak_db(region.peak_db);
    out.set_mean_db(region.mean_db);
    out.set_contrast_db(region.contrast_db);
    out.set_pixels(region.pixels);
    out.set_beam_hits(region.beam_hits);
    out.set_clipped_fraction(region.clipped_fraction);
    out.set_only_expected(region.only_expected);
    out.set_clutter_mass(region.clutter_mass);
    out.set_multipath(region.multipath);
    for (std::size_t i = 0; i < std::min(region.outline_m.size(), link_limits::most_outline_points); ++i) {
        out.add_outline_m(region.outline_m[i].x());
        out.add_outline_m(region.outline_m[i].y());
    }
}

std::optional<Region> read(const wire::Region& in) {
    const auto time = timeFrom(in.time_us());
    const auto head = read(in.head());
    const auto features = read(in.features());
    if (!time || !head || !features) return std::nullopt;
    for (const double value : {in.north_m(), in.east_m(), in.range_m(), in.bearing_rad(), in.peak_db(), in.mean_db(),
                               in.contrast_db(), in.clipped_fraction()})
        if (!isSane(value)) return std::nullopt;
    const auto coordinates = static_cast<std::size_t>(in.outline_m_size());
    if (coordinates % 2 != 0 || coordinates / 2 > link_limits::most_outline_points) return std::nullopt;
    Region region;
    region.id = in.id();
    region.time = *time;
    region.position_m = {in.north_m(), in.east_m()};
    region.head = *head;
    region.range_m = in.range_m();
    region.bearing = Bearing::radians(in.bearing_rad());
    region.features = *features;
    region.peak_db = in.peak_db();
    region.mean_db = in.mean_db();
    region.contrast_db = in.contrast_db();
    region.pixels = in.pixels();
    region.beam_hits = in.beam_hits();
    region.clipped_fraction = in.clipped_fraction();
    region.only_expected = in.only_expected();
    region.clutter_mass = in.clutter_mass();
    region.multipath = in.multipath();
    for (int i = 0; i < in.outline_m_size(); i += 2) {
        if (!isSane(in.outline_m(i)) || !isSane(in.outline_m(i + 1))) return std::nullopt;
        region.outline_m.emplace_back(in.outline_m(i), in.outline_m(i + 1));
    }
    return region;
}

std::optional<LinkRegions> read(const wire::Regions& in) {
    if (static_cast<std::size_t>(in.regions_size()) > link_limits::most_regions) return std::nullopt;
    LinkRegions regions;
    for (const wire::Region& each : in.regions()) {
        auto region = read(each);
        if (!region) return std::nullopt;
        regions.regions.push_back(*std::move(region));
    }
    return regions;
}

}  // namespace echotrail
