#include "core/seanet/ping_decoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace echotrail::seanet {
namespace {

constexpr double tick_s = 640e-9;                       // unit of ADInterval
constexpr double unit_rad = std::numbers::pi / 3200.0;  // 6400 head units to a turn
constexpr double head_clock_hz = 32e6;
constexpr double bits_per_byte_on_the_wire = 10.0, baud = 115'200.0;
constexpr double motor_tick_s = 25 * 10e-6, processing_s = 3e-3;  // a step unit of the motor; the head's own overhead

}  // namespace

double rangeScaleMetres(std::uint16_t range_scale) {
    constexpr std::array<double, 4> metres_per_unit{1.0, 0.3048, 1.8288, 0.9144};  // m, ft, fathom, yd
    return (range_scale & 0x3FFF) / 10.0 * metres_per_unit[range_scale >> 14];
}

double frequencyOf(std::uint32_t transmit_word) { return transmit_word * head_clock_hz / 0x1p32; }

std::vector<std::uint8_t> levelsOf(const HeadData& line) {
    if (line.eightBit()) return line.data;
    std::array<std::uint8_t, 16> level{};
    for (int v = 0; v < 16; ++v)
        level[v] = static_cast<std::uint8_t>(std::min(line.ad_low + (line.ad_span * v * 2 + 15) / 30, 255));
    std::vector<std::uint8_t> levels;
    levels.reserve(2 * line.data.size());
    for (const std::uint8_t byte : line.data) {
        levels.push_back(level[byte >> 4]);
        levels.push_back(level[byte & 0x0F]);
    }
    return levels;
}

Ping pingFrom(const HeadData& line, std::uint64_t sequence, Timestamp transmit, double sound_speed_mps) {
    Ping ping;
    ping.sequence = sequence;
    ping.time = transmit;
    ping.bearing = Bearing::radians((line.bearing - 3200) * unit_rad);
    ping.step_rad = line.step * unit_rad;
    ping.range_scale_m = rangeScaleMetres(line.range_scale);
    ping.sound_speed_mps = sound_speed_mps;
    ping.levels = levelsOf(line);
    const auto bins = static_cast<double>(std::max<std::size_t>(ping.levels.size(), 1));
    ping.bin_interval_s =
        line.ad_interval != 0 ? line.ad_interval * tick_s : 2.0 * ping.range_scale_m / sound_speed_mps / bins;
    ping.frequency_hz = frequencyOf(line.transmit_word);
    ping.gain_percent = line.gain * 100.0 / 210.0;
    ping.clockwise = line.clockwise();
    ping.motor_lost_sync = line.motorLostSync();
    return ping;
}

HeadData lineFrom(const Ping& ping) {
    constexpr double digital_from_hz = 1.0;  // a head that tells its frequency is taken for a digital one
    constexpr std::uint16_t clockwise_eight_bit = 0x2305, anticlockwise_eight_bit = 0x2301, motor_off_sync = 2;
    const auto rounded = [](double value, double most) { return std::lround(std::clamp(value, 0.0, most)); };
    HeadData line;
    line.device_type = ping.frequency_hz >= digital_from_hz ? 0x11 : 2;
    line.status = ping.motor_lost_sync ? motor_off_sync : 0;
    line.head_control = ping.clockwise ? clockwise_eight_bit : anticlockwise_eight_bit;
    line.range_scale = static_cast<std::uint16_t>(rounded(10.0 * ping.range_scale_m, 0x3FFF));
    line.transmit_word = static_cast<std::uint32_t>(
        std::llround(std::clamp(ping.frequency_hz * 0x1p32 / head_clock_hz, 0.0, 4294967295.0)));
    line.gain = static_cast<std::uint8_t>(rounded(2.1 * ping.gain_percent, 255));
    line.ad_span = 255;
    line.ad_interval = static_cast<std::uint16_t>(rounded(ping.bin_interval_s / tick_s, 65'535));
    line.left_limit = 1;
    line.right_limit = 6399;
    line.step = static_cast<std::uint8_t>(rounded(ping.step_rad / unit_rad, 255));
    line.bearing = static_cast<std::uint16_t>((std::lround(ping.bearing.inRadians() / unit_rad) + 9600) % 6400);
    line.data = ping.levels;
    line.total = static_cast<std::uint16_t>(head_parameter_bytes + line.data.size());
    line.data_bytes = static_cast<std::uint16_t>(line.data.size());
    return line;
}

double pingDurationSeconds(const HeadData& line, double sound_speed_mps) {
    const double water =
        2.0 * rangeScaleMetres(line.range_scale) / sound_speed_mps + line.step * motor_tick_s + processing_s;
    const double wire =
        (static_cast<double>(line.data.size() + line.extra.size()) + 45.0) * bits_per_byte_on_the_wire / baud;
    return std::max(water, wire);
}

}  // namespace echotrail::seanet
