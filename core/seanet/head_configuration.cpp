#include "core/seanet/head_configuration.hpp"

#include "core/seanet/ping_decoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace echotrail::seanet {
namespace {

constexpr std::uint8_t imaging_head = 2, digital_head = 0x11;
constexpr std::uint8_t full_gain = 210;
constexpr double unit_deg = 360.0 / 6400.0, tick_s = 640e-9;
constexpr int turn_units = 6400, ahead_units = 3200;
constexpr std::uint16_t control_base = 0x2300, eight_bit = 0x0001, continuous = 0x0002, scan_right = 0x0004,
                        motor_off = 0x0010, transmitter_off = 0x0020, second_channel = 0x0080, stare = 0x1000;

/// Finer bins than the pulse is long add bytes, not detail; more than 800 are too many for old heads, and on digital
/// ones the link would set the pace.
constexpr double bins_per_metre = 20.0;
constexpr int most_bins = 800, shortest_interval = 10;
/// Settings of the maker's program for a SeaKing; heads look at them in 4-bit mode only.
constexpr std::uint8_t ad_span = 149, ad_low = 14;

std::uint16_t wrappedUnits(double degrees) {
    const long units = std::lround(degrees / unit_deg) % turn_units;
    return static_cast<std::uint16_t>(units < 0 ? units + turn_units : units);
}

std::uint32_t synthesiserWord(double hz) { return static_cast<std::uint32_t>(hz * 0x1p32 / 32e6); }

/// Rise of the receiver's gain with range, by frequency (DigSon notes).
std::uint16_t slopeFor(double hz) {
    constexpr std::array<std::array<double, 2>, 8> table{
        {{200, 70}, {325, 90}, {580, 110}, {675, 125}, {795, 130}, {935, 140}, {1210, 150}, {2000, 180}}};
    const double khz = std::clamp(hz / 1000.0, table.front()[0], table.back()[0]);
    std::size_t i = 1;
    while (i + 1 < table.size() && khz > table[i][0]) ++i;
    const double part = (khz - table[i - 1][0]) / (table[i][0] - table[i - 1][0]);
    return static_cast<std::uint16_t>(std::lround(std::lerp(table[i - 1][1], table[i][1], part)));
}

/// A head of one channel is told the same of both.
double frequencyOrOther(const HeadIdentity& head, std::size_t channel) {
    return channel == 1 && !head.twoChannels() ? head.frequencyHz(0) : head.frequencyHz(channel);
}

std::uint8_t gainUnits(double percent) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(percent, 0.0, 100.0) * full_gain / 100.0));
}

/// Sampling that covers the range in whole ticks, with an even number of bins: heads round odd ones up.
void setSampling(HeadCommand& command, const HeadSettings& settings) {
    const double ticks = 2.0 * settings.range_m / settings.sound_speed / tick_s;
    const double wanted = std::clamp(settings.range_m * bins_per_metre, 2.0, static_cast<double>(most_bins));
    const double interval = std::clamp(std::round(ticks / wanted), static_cast<double>(shortest_interval), 65535.0);
    const int bins = std::min(2 * static_cast<int>(std::lround(ticks / interval / 2.0)), most_bins);
    command.ad_interval = static_cast<std::uint16_t>(interval);
    command.bins = static_cast<std::uint16_t>(std::max(bins, 2));
}

/// The limits count from the head's own zero, and from above its turn is the other way when it hangs upside down. The
/// head's invert bit stays off: the mounting is the host's business, and would be mirrored twice.
void setSector(HeadCommand& command, const HeadSettings& settings) {
    const double from_zero = settings.sector_centre_deg - settings.mount_heading_deg;
    const double centre = ahead_units * unit_deg + (settings.mount_inverted ? -from_zero : from_zero);
    if (settings.sector_width_deg > 360.0 - unit_deg) {
        command.head_control |= continuous | scan_right;
        command.left_limit = 1;
        command.right_limit = turn_units - 1;
    } else {
        command.left_limit = wrappedUnits(centre - settings.sector_width_deg / 2.0);
        command.right_limit = wrappedUnits(centre + settings.sector_width_deg / 2.0);
    }
}

std::string say(const std::string& what, double is, double wanted, const char* unit) {
    std::ostringstream text;
    text << what << " is " << is << unit << ", not " << wanted << unit;
    return text.str();
}

double degreesOfLimit(std::uint16_t limit) { return (limit - ahead_units) * unit_deg; }

}  // namespace

HeadCommand commandFor(const HeadSettings& settings, const HeadIdentity& head) {
    HeadCommand command;
    command.head_control = control_base;
    if (settings.bits == 8) command.head_control |= eight_bit;
    const bool high = settings.channel == Channel::High && head.twoChannels();
    if (high) command.head_control |= second_channel;
    command.head_type = head.digital() ? digital_head : imaging_head;
    const ChannelGains gains = gainsFor(settings, head);
    for (std::size_t channel = 0; channel < 2; ++channel) {
        constexpr double intermediate_hz = 455'000.0;
        const double hz = frequencyOrOther(head, channel);
        command.transmit_word[channel] = synthesiserWord(hz);
        command.receive_word[channel] = synthesiserWord(hz + intermediate_hz);
    }
    command.pulse_us = static_cast<std::uint16_t>(std::clamp((settings.range_m + 10.0) * 2.5, 20.0, 350.0));
    command.range_scale = static_cast<std::uint16_t>(std::lround(settings.range_m * 10.0));
    command.step = static_cast<std::uint8_t>(std::clamp(std::lround(settings.step_deg / unit_deg), 1L, 255L));
    command.ad_span = gains.ad_span[high ? 1 : 0];
    command.ad_low = gains.ad_low[high ? 1 : 0];
    command.gain = gains.gain;
    command.slope = gains.slope;
    setSampling(command, settings);
    setSector(command, settings);
    if (head.twoChannels() || head.digital()) command.channels = gains;
    return command;
}

ChannelGains gainsFor(const HeadSettings& settings, const HeadIdentity& head) {
    ChannelGains gains;
    for (std::size_t channel = 0; channel < 2; ++channel) {
        gains.ad_span[channel] = ad_span;
        gains.ad_low[channel] = ad_low;
        gains.gain[channel] = gainUnits(settings.gain_percent);
        gains.slope[channel] = slopeFor(frequencyOrOther(head, channel));
    }
    return gains;
}

bool differOnlyInGains(const HeadCommand& a, const HeadCommand& b) {
    if (a == b || a.channels.has_value() != b.channels.has_value()) return false;
    HeadCommand same = a;
    same.ad_span = b.ad_span;
    same.ad_low = b.ad_low;
    same.gain = b.gain;
    same.slope = b.slope;
    same.channels = b.channels;
    return same == b;
}

std::string differenceOf(const HeadCommand& commanded, const HeadData& reply) {
    constexpr std::uint16_t modes = eight_bit | continuous | motor_off | transmitter_off | second_channel | stare;
    const std::uint16_t other = (commanded.head_control ^ reply.head_control) & modes;
    if (other & eight_bit) return reply.eightBit() ? "bins have 8 bits, not 4" : "bins have 4 bits, not 8";
    if (other & continuous)
        return reply.head_control & continuous ? "the head turns round and round" : "the head scans a sector";
    if (other & second_channel) return reply.secondChannel() ? "the channel is high" : "the channel is low";
    if (other) return "the motor or the transmitter is not as it was told";
    if (reply.range_scale != commanded.range_scale)
        return say("range", rangeScaleMetres(reply.range_scale), rangeScaleMetres(commanded.range_scale), " m");
    if (!(commanded.head_control & continuous)) {
        if (reply.left_limit != commanded.left_limit)
            return say("left limit", degreesOfLimit(reply.left_limit), degreesOfLimit(commanded.left_limit), " deg");
        if (reply.right_limit != commanded.right_limit)
            return say("right limit", degreesOfLimit(reply.right_limit), degreesOfLimit(commanded.right_limit), " deg");
    }
    if (reply.step != commanded.step) return say("step", reply.step * unit_deg, commanded.step * unit_deg, " deg");
    const auto& gains = commanded.channels ? commanded.channels->gain : commanded.gain;
    const std::uint8_t gain = gains[commanded.head_control & second_channel ? 1 : 0];
    if (reply.gain != gain) return say("gain", reply.gain * 100.0 / full_gain, gain * 100.0 / full_gain, " %");
    const int interval = commanded.ad_interval, rounding = std::max(2, interval / 50);
    if (reply.ad_interval != 0 && std::abs(reply.ad_interval - interval) > rounding)
        return say("bin interval", reply.ad_interval * tick_s * 1e6, interval * tick_s * 1e6, " us");
    const auto bins = static_cast<int>(reply.bins());
    if (std::abs(bins - commanded.bins) > 2) return say("number of bins", bins, commanded.bins, "");
    return {};
}

HeadSettings confirmedSettings(const HeadData& reply, const HeadSettings& ours) {
    HeadSettings settings = ours;
    settings.range_m = rangeScaleMetres(reply.range_scale);
    settings.step_deg = reply.step * unit_deg;
    settings.gain_percent = reply.gain * 100.0 / full_gain;
    settings.bits = reply.eightBit() ? 8 : 4;
    settings.channel = reply.secondChannel() ? Channel::High : Channel::Low;
    settings.sector_width_deg = 360.0;
    settings.sector_centre_deg = 0.0;
    if (reply.head_control & continuous) return settings;
    const int width = (reply.right_limit - reply.left_limit + 2 * turn_units) % turn_units;
    const double from_zero = (reply.left_limit - ahead_units + width / 2.0) * unit_deg;
    settings.sector_width_deg = width * unit_deg;
    settings.sector_centre_deg =
        Bearing::degrees(ours.mount_heading_deg + (ours.mount_inverted ? -from_zero : from_zero)).inDegrees();
    return settings;
}

}  // namespace echotrail::seanet
