#pragma once

#include "core/base/parameters.hpp"
#include "core/base/time.hpp"
#include "core/seanet/commands.hpp"
#include "core/seanet/head_data.hpp"
#include "core/simulation/head_setup.hpp"
#include "core/simulation/scan_motion.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

enum class HeadModel { Dfs, Dst };

/// Which head is simulated, and how it is connected.
struct SimulatedHeadOptions {
    HeadModel model = HeadModel::Dst;
    bool half_duplex = false;
    int baud = 115'200;
    int serial_number = 2347;
    int node = seanet::default_head_node;
    double boot_s = 1.5;
    double centring_s = 3.0;
    int interval_multiple = 1;
    double water_sound_speed = 1490.0;
};

template <>
struct Described<SimulatedHeadOptions> {
    using Options = SimulatedHeadOptions;
    static constexpr std::string_view group = "Simulated head";
    static constexpr auto fields = std::tuple{
        ChoiceField<Options, HeadModel, 2>{
            &Options::model, "head_model", {"dfs", "dst"}, "SeaKing DFS (analogue) or SeaKing DST (digital)"},
        flag(&Options::half_duplex, "half_duplex", "The head and the host share two wires (RS-485)"),
        Field{&Options::baud, "head_baud", "bit/s", 1200, 1'000'000, "Rate of the head's serial line"},
        Field{&Options::serial_number, "head_serial_number", "", 0, 65535, "Serial number; a DST does not tell it"},
        Field{&Options::node, "head_node", "", 1, 254, "Node number that the head answers to"},
        Field{&Options::boot_s, "head_boot_s", "s", 0, 60, "Silence after power-up"},
        Field{&Options::centring_s, "head_centring_s", "s", 0, 60, "Time to find the centre after that"},
        Field{&Options::interval_multiple, "head_interval_multiple", "640 ns", 1, 16,
              "The head rounds the bin interval it is told to a multiple of this"},
        Field{&Options::water_sound_speed, "water_sound_speed", "m/s", 1350, 1600,
              "True speed of sound where the head hangs"}};
};

/// The levels that the head hears of one transmission: 0…255 for 0…80 dB, `bins` of them, before any packing. `now` is
/// when it was made, `number` counts the transmissions since the head was made.
using EchoFunction = std::function<std::vector<std::uint8_t>(const HeadSetup&, Microseconds now, std::uint64_t number)>;

/// Bytes on the head's line, and when the last of them is through.
struct TimedBytes {
    Microseconds at{};
    std::vector<std::uint8_t> bytes;
};

/// A scanning head as its host sees it, at the level of bytes (Tritech DigSon notes, rev 4, and what captures of both
/// models show): it boots, centres, tells every second that it is alive, answers for its version and its block, takes
/// parameters and gives one line for each trigger; at first two where it has both wires to itself. Timing: the sound's
/// way there and back, the motor, and every byte at the rate of the serial line. The motor and transmitter switches in
/// the parameters are not looked at.
/// A value machine: all time comes in. Calls in order of `now`; call tick() at deadline(). State: what the real one
/// has; the triggers and frames it holds are bounded by its two triggers and the requests it was sent.
class SimulatedHead {
public:
    SimulatedHead(const SimulatedHeadOptions& options, EchoFunction echo);

    /// Off until then. Of one that is on it takes power away and gives it back: parameters are lost, as by mtReBoot.
    void powerUp(Microseconds now);
    /// What the host sends; any bytes.
    void received(Microseconds now, seanet::Bytes bytes);
    void tick(Microseconds now);
    /// What has gone through the line by `now`: pieces of frames, as a serial adapter hands them over.
    std::vector<TimedBytes> takeOutput(Microseconds now);
    /// When it has something to do or to hand over by itself.
    std::optional<Microseconds> deadline() const;

    std::uint64_t transmissions() const { return transmissions_; }
    /// Cause → messages (or bytes, of "collision_bytes") that were of no effect.
    const std::map<std::string, std::uint64_t>& ignored() const { return ignored_; }

private:
    struct Transmission {
        Microseconds end{};
        seanet::HeadData line;
    };
    bool dst() const { return options_.model == HeadModel::Dst; }
    std::uint8_t node() const { return static_cast<std::uint8_t>(options_.node); }
    bool idle() const { return lines_due_.empty() && triggers_ == 0 && !ping_; }
    bool asleep(Microseconds now) const;
    std::optional<Microseconds> pingStart() const;
    std::optional<Microseconds> nextEvent() const;
    void advance(Microseconds now);
    void take(Microseconds now, const seanet::Frame& frame);
    void takeHeadCommand(Microseconds now, seanet::Bytes payload);
    void setCommand(const seanet::HeadCommand& command);
    void takeTrigger(Microseconds now, seanet::Bytes payload);
    void startPing(Microseconds now);
    void finishPing(Microseconds now);
    std::size_t channel() const;
    seanet::ChannelGains gains() const;
    seanet::HeadData lineOf(const std::vector<std::uint8_t>& levels) const;
    HeadSetup setup() const;
    void turned(Microseconds now, int units);
    void sendAlive(Microseconds now);
    void sendBlock(Microseconds now);
    void send(Microseconds now, const std::vector<std::uint8_t>& frame);
    Microseconds lineTime(std::size_t bytes) const;
    void ignore(const char* cause) { ++ignored_[cause]; }

    SimulatedHeadOptions options_;
    EchoFunction echo_;
    seanet::FrameParser parser_;
    std::map<std::string, std::uint64_t> ignored_;
    std::uint64_t transmissions_ = 0;
    bool on_ = false;
    Microseconds booted_{}, centred_{}, last_received_{}, last_active_{}, validated_{}, next_alive_{};
    bool alives_stopped_ = false;
    std::uint32_t clock_ms_ = 0;  ///< time of day that the host told, at clock_set_
    Microseconds clock_set_{};
    std::optional<seanet::HeadCommand> command_;
    std::optional<seanet::HeadCommand> next_command_;  ///< for after the ping under way
    int triggers_ = 0;                                 ///< not begun
    std::optional<Transmission> ping_;                 ///< under way
    std::deque<Microseconds> lines_due_;               ///< when each line that is being sent will be through
    Microseconds ready_{};                             ///< the motor stands still from then on
    ScanMotion motion_;
    std::deque<TimedBytes> output_;
    Microseconds line_free_{};
};

}  // namespace echotrail
