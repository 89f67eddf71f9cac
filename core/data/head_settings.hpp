#pragma once

#include "core/base/parameters.hpp"
#include "core/data/scan_sector.hpp"

namespace echotrail {

enum class Channel { Low, High };

/// How the sonar head is set and mounted, and the water. Of a recording only sound_speed and the mounting matter:
/// the rest was settled when it was made.
struct HeadSettings {
    double range_m = 50.0;
    double sector_centre_deg = 0.0;
    double sector_width_deg = 90.0;
    double step_deg = 1.8;
    Channel channel = Channel::High;
    double gain_percent = 40.0;
    int bits = 8;
    double sound_speed = 1490.0;
    bool mount_inverted = false;
    double mount_heading_deg = 0.0;
    double mount_forward_m = 0.0;
    double mount_starboard_m = 0.0;
};

template <>
struct Described<HeadSettings> {
    static constexpr std::string_view group = "Sonar head and water";
    static constexpr auto fields = std::tuple{
        Field{&HeadSettings::range_m, "range_m", "m", 2, 450, "Range scale of the head"},
        Field{&HeadSettings::sector_centre_deg, "sector_centre_deg", "deg", -180, 180,
              "Middle of the scanned sector, clockwise from the bow"},
        Field{&HeadSettings::sector_width_deg, "sector_width_deg", "deg", 0.225, 360,
              "Width of the scanned sector; 360 scans round and round"},
        Field{&HeadSettings::step_deg, "step_deg", "deg", 0.05625, 14.34375, "Turn of the beam between pings"},
        ChoiceField<HeadSettings, Channel, 2>{
            &HeadSettings::channel, "channel", {"low", "high"}, "Frequency of a two-channel head"},
        Field{&HeadSettings::gain_percent, "gain_percent", "%", 0, 100, "Initial gain of the receiver"},
        Field{&HeadSettings::bits, "bits", "bit", 4, 8, "Bits per range bin: 4 or 8"},
        Field{&HeadSettings::sound_speed, "sound_speed", "m/s", 1350, 1600,
              "Speed of sound; the value stored in a V4LOG wins unless this is set"},
        flag(&HeadSettings::mount_inverted, "mount_inverted",
             "The head hangs upside down, so that it turns the other way seen from above", Effect::NextSweep),
        Field{&HeadSettings::mount_heading_deg, "mount_heading_deg", "deg", -180, 180,
              "Where the head's zero points, clockwise from the bow", Effect::NextSweep},
        Field{&HeadSettings::mount_forward_m, "mount_forward_m", "m", -50, 50,
              "The head lies this far ahead of the point that navigation reports", Effect::NextSweep},
        Field{&HeadSettings::mount_starboard_m, "mount_starboard_m", "m", -50, 50,
              "The head lies this far to starboard of the point that navigation reports", Effect::NextSweep}};
};

inline ScanSector scanSector(const HeadSettings& settings) {
    return {settings.sector_centre_deg, settings.sector_width_deg};
}
/// The same settings with another sector.
inline HeadSettings withSector(HeadSettings settings, const ScanSector& sector) {
    settings.sector_centre_deg = sector.centre_deg;
    settings.sector_width_deg = sector.width_deg;
    return settings;
}

}  // namespace echotrail
