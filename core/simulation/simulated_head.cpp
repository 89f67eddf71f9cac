#include "core/simulation/simulated_head.hpp"

#include "core/seanet/messages.hpp"
#include "core/seanet/ping_decoder.hpp"
#include "core/simulation/head_answers.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace echotrail {

using namespace std::chrono_literals;
using seanet::MessageId;

namespace {

constexpr int turn_units = ScanMotion::turn_units, ahead_units = ScanMotion::ahead_units;
constexpr double tick_s = 640e-9, decibels_per_level = 80.0 / 255.0;
constexpr std::uint16_t eight_bit = 0x0001, continuous = 0x0002, scan_right = 0x0004, second_channel = 0x0080,
                        stare = 0x1000;
constexpr std::uint8_t host = 255, single = 0x80;
constexpr Microseconds alive_interval = 1s, motor_rests_after = 60s, validation = 200ms, head_latency = 3ms;
/// A message that stops for so long is not going on.
constexpr Microseconds longest_silence = 200ms;
/// Serial adapters hand over what has come within some milliseconds.
constexpr Microseconds piece_time = 4ms;

std::uint8_t id(MessageId message) { return static_cast<std::uint8_t>(message); }

/// Two bins in a byte, the nearer in its high half; 0…15 over the window from `low` on.
std::vector<std::uint8_t> packed(const std::vector<std::uint8_t>& levels, int low, int span) {
    const auto nibble = [&](std::size_t i) {
        const double part = 15.0 * (levels[i] - low) / std::max(span, 1);
        return static_cast<unsigned>(std::lround(std::clamp(part, 0.0, 15.0)));
    };
    std::vector<std::uint8_t> bytes(levels.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(nibble(2 * i) << 4 | nibble(2 * i + 1));
    return bytes;
}

}  // namespace

SimulatedHead::SimulatedHead(const SimulatedHeadOptions& options, EchoFunction echo)
    : options_(options), echo_(std::move(echo)), motion_(options.model == HeadModel::Dst) {
    assert(options.baud > 0 && options.interval_multiple > 0 && echo_);
}

void SimulatedHead::powerUp(Microseconds now) {
    on_ = true;
    booted_ = now + microsecondsFromSeconds(options_.boot_s);
    centred_ = booted_ + microsecondsFromSeconds(options_.centring_s);
    next_alive_ = booted_;
    alives_stopped_ = false;
    clock_ms_ = 0;
    clock_set_ = now;
    command_.reset();
    next_command_.reset();
    triggers_ = 0;
    ping_.reset();
    lines_due_.clear();
    ready_ = centred_;
    last_active_ = centred_;
    motion_.centre();
    motion_.setClockwise(true);
    output_.clear();
    line_free_ = now;
}

void SimulatedHead::received(Microseconds now, seanet::Bytes bytes) {
    advance(now);
    if (!on_ || now < booted_) {
        ignored_["bytes_while_off"] += bytes.size();
        return;
    }
    if (options_.half_duplex && now < line_free_) {  // both drive the wires: neither is understood
        ignored_["collision_bytes"] += bytes.size();
        return;
    }
    const auto sink = [&](const seanet::Frame& frame) { take(now, frame); };
    if (now - last_received_ > longest_silence) parser_.giveUpUnfinished(sink);
    last_received_ = now;
    parser_.take(bytes, sink);
}

void SimulatedHead::tick(Microseconds now) { advance(now); }

std::vector<TimedBytes> SimulatedHead::takeOutput(Microseconds now) {
    std::vector<TimedBytes> through;
    for (; !output_.empty() && output_.front().at <= now; output_.pop_front())
        through.push_back(std::move(output_.front()));
    return through;
}

std::optional<Microseconds> SimulatedHead::deadline() const {
    const auto event = nextEvent();
    if (output_.empty()) return event;
    return event ? std::min(*event, output_.front().at) : output_.front().at;
}

std::optional<Microseconds> SimulatedHead::pingStart() const {
    if (ping_ || triggers_ == 0) return std::nullopt;
    return std::max({ready_, last_active_, centred_, validated_});
}

std::optional<Microseconds> SimulatedHead::nextEvent() const {
    if (!on_) return std::nullopt;
    Microseconds next = next_alive_;
    if (ping_) next = std::min(next, ping_->end);
    if (const auto start = pingStart()) next = std::min(next, *start);
    if (!lines_due_.empty()) next = std::min(next, lines_due_.front());
    return next;
}

void SimulatedHead::advance(Microseconds now) {
    for (auto next = nextEvent(); next && *next <= now; next = nextEvent()) {
        const Microseconds at = *next;
        while (!lines_due_.empty() && lines_due_.front() <= at) lines_due_.pop_front();
        if (ping_ && ping_->end <= at) finishPing(at);
        if (const auto start = pingStart(); start && *start <= at) startPing(at);
        if (next_alive_ > at) continue;
        if (idle() && !alives_stopped_) sendAlive(at);
        next_alive_ += alive_interval;
    }
}

bool SimulatedHead::asleep(Microseconds now) const { return idle() && now - last_active_ >= motor_rests_after; }

void SimulatedHead::sendAlive(Microseconds now) {
    enum : unsigned {
        InCentre = 0x01,
        Centred = 0x02,
        Motoring = 0x04,
        MotorOn = 0x08,
        OffCentre = 0x10,
        NoParameters = 0x40,
        SentConfiguration = 0x80
    };
    const bool centring = now < centred_, rests = asleep(now);
    // The transducer is back at its centre some time before the head is content with it.
    const bool away = centring ? now < centred_ - (centred_ - booted_) / 2 : motion_.position() != ahead_units && !rests;
    const bool needs_parameters = !command_ || now < validated_;
    unsigned info = centring ? InCentre | Motoring : Centred;
    if (!rests) info |= MotorOn;
    if (!rests && now < ready_) info |= Motoring;
    if (away) info |= OffCentre;
    if (needs_parameters) info |= NoParameters;
    if (command_) info |= SentConfiguration;
    seanet::ByteWriter payload;
    payload.u8(dst() || needs_parameters ? 0x80 : 0x00);
    payload.u32(clock_ms_ + static_cast<std::uint32_t>((now - clock_set_) / 1ms));
    payload.u16(static_cast<unsigned>(rests ? ahead_units : motion_.position())).u8(info);
    send(now, seanet::makeFrame(node(), host, id(MessageId::Alive), single, node(), payload.bytes()));
}

void SimulatedHead::sendBlock(Microseconds now) {
    const auto answer = [&](MessageId message, seanet::Bytes payload) {
        send(now, seanet::makeFrame(node(), host, id(message), single, node(), payload));
    };
    answer(MessageId::BBUserData, blockPayload(dst(), options_.half_duplex));
    if (!dst()) return;
    answer(MessageId::FpgaCalibrationData, std::vector<std::uint8_t>(66));
    answer(MessageId::FpgaVersionData, seanet::ByteWriter().u8(1).u32(1).u16(1).u16(0).u8(1).u32(0).bytes());
}

void SimulatedHead::send(Microseconds now, const std::vector<std::uint8_t>& frame) {
    const auto piece_bytes =
        static_cast<std::size_t>(std::max<std::int64_t>(options_.baud * (piece_time / 1ms) / 10'000, 1));
    const Microseconds begin = std::max(now, line_free_);
    for (std::size_t from = 0; from < frame.size(); from += piece_bytes) {
        const std::size_t until = std::min(from + piece_bytes, frame.size());
        line_free_ = begin + lineTime(until);
        output_.push_back(
            {line_free_,
             {frame.begin() + static_cast<std::ptrdiff_t>(from), frame.begin() + static_cast<std::ptrdiff_t>(until)}});
    }
}

Microseconds SimulatedHead::lineTime(std::size_t bytes) const {
    constexpr double bits_per_byte = 10.0;  // with its start and stop bit
    return microsecondsFromSeconds(static_cast<double>(bytes) * bits_per_byte / options_.baud);
}

void SimulatedHead::take(Microseconds now, const seanet::Frame& frame) {
    if (now < booted_) return ignore("after_reboot");
    if (frame.destination() != node()) return ignore("other_node");
    switch (MessageId{frame.id()}) {
        case MessageId::SendVersion:
            return send(now, seanet::makeFrame(node(), host, id(MessageId::VersionData), single, node(),
                                               versionPayload(dst(), options_.serial_number, node())));
        case MessageId::SendBBUser:
            return sendBlock(now);
        case MessageId::HeadCommand:
            return takeHeadCommand(now, frame.payload());
        case MessageId::SendData:
            return takeTrigger(now, frame.payload());
        case MessageId::StopAlives:
            alives_stopped_ = true;
            return;
        case MessageId::ReBoot:
            return powerUp(now);
        default:
            return ignore("other_message");
    }
}

void SimulatedHead::takeHeadCommand(Microseconds now, seanet::Bytes payload) {
    constexpr std::uint8_t reverse_scan = 15;
    auto& latest = next_command_ ? next_command_ : command_;
    if (payload.size() == 1 && payload[0] == reverse_scan) {
        motion_.setClockwise(!motion_.clockwise());
        return;
    }
    if (const auto gains = seanet::decodeGains(payload)) {
        if (!latest) return ignore("no_parameters");
        latest->channels = gains;
        return;
    }
    auto command = seanet::decodeHeadCommand(payload);
    if (!command || command->bins == 0 || command->ad_interval == 0 || command->step == 0 ||
        std::max(command->left_limit, command->right_limit) >= turn_units)
        return ignore("bad_parameters");
    constexpr int shortest_interval = 5;
    const int multiple = options_.interval_multiple;
    const int rounded = (command->ad_interval + multiple / 2) / multiple * multiple;
    const int most_bins = dst() ? 1500 : 800;
    command->ad_interval = static_cast<std::uint16_t>(std::clamp(rounded, shortest_interval, 65535));
    command->bins = static_cast<std::uint16_t>(std::min((command->bins + 1) / 2 * 2, most_bins));
    if (ping_) {
        next_command_ = command;
        return;
    }
    if (!command_) validated_ = now + validation;
    setCommand(*command);
    if (triggers_ > 0) turned(now, motion_.enter());
}

void SimulatedHead::setCommand(const seanet::HeadCommand& command) {
    command_ = command;
    const bool round = command.head_control & continuous;
    motion_.setLimits({command.left_limit, command.right_limit, command.step, round,
                       static_cast<bool>(command.head_control & stare)});
    if (round) motion_.setClockwise(command.head_control & scan_right);
}

void SimulatedHead::takeTrigger(Microseconds now, seanet::Bytes payload) {
    if (!command_) return ignore("no_parameters");
    if (payload.size() >= 4 && seanet::u32(payload, 0) != 0) {
        clock_ms_ = seanet::u32(payload, 0);
        clock_set_ = now;
    }
    const std::size_t held = lines_due_.size() + static_cast<std::size_t>(triggers_) + (ping_ ? 1 : 0);
    const std::size_t room = options_.half_duplex ? 1 : 2;
    if (held >= room) return ignore("trigger_too_many");
    if (asleep(now)) motion_.centre();
    if (held == 0) turned(now, motion_.enter());
    // From rest a head with wires of its own gives two lines: so there is always one trigger in hand.
    triggers_ += held == 0 && !options_.half_duplex ? 2 : 1;
    last_active_ = now;
    advance(now);
}

void SimulatedHead::startPing(Microseconds now) {
    --triggers_;
    const HeadSetup head = setup();
    const auto levels = echo_(head, now, transmissions_++);
    assert(levels.size() == command_->bins);
    ping_ = Transmission{now + microsecondsFromSeconds(head.bins * head.bin_interval_s) + head_latency, lineOf(levels)};
}

void SimulatedHead::finishPing(Microseconds now) {
    send(now, seanet::encodeHeadData(ping_->line, node()));
    ping_.reset();
    lines_due_.push_back(line_free_);
    last_active_ = now;
    next_alive_ = line_free_ + alive_interval;
    // With two wires for both ways the motor waits for the line, too: the period is the sum of all.
    const Microseconds still = options_.half_duplex ? line_free_ : now;
    if (next_command_) {
        setCommand(*std::exchange(next_command_, std::nullopt));
        turned(still, motion_.enter());
    } else {
        turned(still, motion_.step());
    }
}

std::size_t SimulatedHead::channel() const { return command_->head_control & second_channel ? 1 : 0; }

seanet::ChannelGains SimulatedHead::gains() const {
    const seanet::HeadCommand& c = *command_;
    if (c.channels) return *c.channels;
    return {.ad_span = {c.ad_span, c.ad_span}, .ad_low = {c.ad_low, c.ad_low}, .gain = c.gain, .slope = c.slope};
}

HeadSetup SimulatedHead::setup() const {
    const seanet::ChannelGains window = gains();
    const std::uint32_t word = command_->transmit_word[channel()];
    const bool told = !dst() && word != 0;  // digital heads do not look at the words
    HeadSetup head;
    head.range_m = seanet::rangeScaleMetres(command_->range_scale);
    head.bins = command_->bins;
    head.bin_interval_s = command_->ad_interval * tick_s;
    head.bearing = Bearing::degrees((motion_.position() - ahead_units) * 360.0 / turn_units);
    head.step_rad = radiansFromDegrees(command_->step * 360.0 / turn_units);
    head.frequency_hz = told ? seanet::frequencyOf(word) : head_channel_hz[channel()];
    head.gain_db = window.gain[channel()] * 80.0 / 210.0;
    head.ad_low_db = window.ad_low[channel()] * decibels_per_level;
    head.ad_span_db = window.ad_span[channel()] * decibels_per_level;
    head.bits = command_->head_control & eight_bit ? 8 : 4;
    head.sound_speed = options_.water_sound_speed;
    return head;
}

seanet::HeadData SimulatedHead::lineOf(const std::vector<std::uint8_t>& levels) const {
    const seanet::HeadCommand& c = *command_;
    const seanet::ChannelGains window = gains();
    seanet::HeadData line;
    line.device_type = dst() ? 0x11 : 2;
    line.status = c.head_control & eight_bit ? 0x10 : 0;
    if (dst()) line.sweep_code = motion_.end() < 0 ? 1 : motion_.end() > 0 ? 2 : 0;
    line.head_control = static_cast<std::uint16_t>((c.head_control & ~scan_right) | (motion_.clockwise() ? scan_right : 0));
    line.range_scale = c.range_scale;
    line.transmit_word = c.transmit_word[channel()];
    line.gain = window.gain[channel()];
    line.slope = window.slope[channel()];
    line.ad_span = window.ad_span[channel()];
    line.ad_low = window.ad_low[channel()];
    line.ad_interval = c.ad_interval;
    line.left_limit = c.left_limit;
    line.right_limit = c.right_limit;
    line.step = c.step;
    line.bearing = static_cast<std::uint16_t>(motion_.position());
    line.data = c.head_control & eight_bit ? levels : packed(levels, line.ad_low, line.ad_span);
    return line;
}

/// The motor has turned by so many units.
void SimulatedHead::turned(Microseconds now, int units) {
    ready_ = std::max(ready_, now + units * command_->motor_time * 10us);
}

}  // namespace echotrail
