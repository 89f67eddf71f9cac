#pragma once

#include "core/seanet/head_configuration.hpp"
#include "core/seanet/messages.hpp"
#include "core/simulation/simulated_head.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace echotrail {

using namespace std::chrono_literals;
using seanet::MessageId;

inline std::vector<std::uint8_t> rampEcho(const HeadSetup& head, Microseconds, std::uint64_t) {
    std::vector<std::uint8_t> levels(static_cast<std::size_t>(head.bins));
    for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = static_cast<std::uint8_t>(i);
    return levels;
}

template <class T>
struct Timed {
    Microseconds at{};
    T what;
};

/// The other end of the wire: sends what it is told to, keeps what comes, and may ask for the next line on each line.
class Host {
public:
    explicit Host(const SimulatedHeadOptions& options, EchoFunction echo = rampEcho) : head(options, std::move(echo)) {
        head.powerUp(0us);
    }
    void runUntil(Microseconds end) {
        for (;;) {
            const auto next = head.deadline();
            const bool later = !next || *next > end;
            if (!later) now = std::max(now, *next);
            if (later) now = end;
            head.tick(now);
            for (const TimedBytes& piece : head.takeOutput(now)) take(piece);
            if (later) return;
        }
    }
    void runFor(Microseconds time) { runUntil(now + time); }
    void send(const seanet::FrameBytes& bytes) { head.received(now, bytes); }
    /// Up to where it is centred and has its parameters.
    void prepare(const seanet::HeadCommand& command) {
        runUntil(5s);
        send(seanet::encodeHeadCommand(command));
        runFor(800ms);
    }
    seanet::HeadIdentity identify() {
        send(seanet::encodeSendVersion());
        runFor(100ms);
        send(seanet::encodeSendBBUser());
        runFor(100ms);
        return {.version = version, .block = block, .device_type = 0, .node = seanet::default_head_node};
    }
    void scan(std::size_t count) {
        polling = true;
        send(seanet::encodeSendData(0));
        while (lines.size() < count && now < 1000s) runFor(10ms);
        polling = false;
    }
    std::vector<int> bearings() const {
        std::vector<int> all;
        for (const auto& line : lines) all.push_back(line.what.bearing);
        return all;
    }

    SimulatedHead head;
    Microseconds now{};
    bool polling = false;
    std::vector<Timed<seanet::Alive>> alives;
    std::vector<Timed<seanet::HeadData>> lines;
    std::optional<seanet::VersionData> version;
    std::optional<seanet::BBUserData> block;
    std::vector<int> ids;                            ///< of all that came
    std::map<std::size_t, std::size_t> frame_sizes;  ///< by id

private:
    void take(const TimedBytes& piece) {
        EXPECT_LE(piece.at, now);
        parser_.take(piece.bytes, [&](const seanet::Frame& frame) {
            ids.push_back(frame.id());
            frame_sizes[frame.id()] = frame.bytes.size();
            if (frame.id() == 2) {
                lines.push_back({now, seanet::decodeHeadData(frame.payload()).value()});
                if (polling) send(seanet::encodeSendData(0));
                return;
            }
            const auto message = seanet::decodeMessage(frame);
            if (const auto* alive = std::get_if<seanet::Alive>(&message)) alives.push_back({now, *alive});
            if (const auto* told = std::get_if<seanet::VersionData>(&message)) version = *told;
            if (const auto* told = std::get_if<seanet::BBUserData>(&message)) block = *told;
        });
    }
    seanet::FrameParser parser_;
};

inline SimulatedHeadOptions dfs() { return {.model = HeadModel::Dfs}; }
inline SimulatedHeadOptions dst() { return {.model = HeadModel::Dst}; }
inline SimulatedHeadOptions twoWires() { return {.model = HeadModel::Dst, .half_duplex = true}; }

/// The parameters of the capture of a SeaKing DST at 50 m.
inline seanet::HeadCommand capturedCommand() {
    seanet::HeadCommand command;
    command.head_control = 0x2381;
    command.range_scale = 500;
    command.left_limit = 1778;
    command.right_limit = 4622;
    command.ad_span = 81;
    command.ad_low = 40;
    command.gain = {84, 105};
    command.step = 32;
    command.ad_interval = 133;
    command.bins = 794;
    return command;
}

}  // namespace echotrail
