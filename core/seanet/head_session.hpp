#pragma once

#include "core/base/time.hpp"
#include "core/seanet/frame_parser.hpp"
#include "core/seanet/head_configuration.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace echotrail::seanet {

enum class HeadState {
    NoLink,
    Waiting,      ///< for a sign of life
    Identifying,  ///< asked what it is
    Centring,     ///< it looks for its zero after power-up
    Configuring,  ///< told its parameters
    Polling,      ///< it sends line after line
    Silent,       ///< nothing, or no answer, comes; the session goes on asking
    WrongDevice   ///< something else talks on this line; the session goes on asking
};

/// Who may speak when. FromHead: what it says of its port, and taking turns where it says nothing.
enum class Duplex { FromHead, Full, Half };

/// The session at a glance. Counts are since the session's beginning.
struct HeadStatus {
    HeadState state = HeadState::NoLink;
    std::string head;  ///< "SeaKing DFS, serial 123, node 2, 325/675 kHz"; empty until it has said so
    bool digital = false, half_duplex = true;
    HeadSettings commanded;
    std::optional<HeadSettings> confirmed;  ///< by the copy of the parameters in the last line
    std::string difference;                 ///< between the two; empty where there is none
    std::uint64_t pings = 0;
    std::uint64_t timeouts = 0;      ///< lines or answers that did not come in time
    std::uint64_t retries = 0;       ///< commands said again
    std::uint64_t head_resets = 0;   ///< the head lost its parameters by itself
    std::uint64_t reboots_sent = 0;  ///< it was told to start afresh
    std::uint64_t rejected = 0;      ///< damaged frames and lines
    std::uint64_t foreign = 0;       ///< whole frames of other devices, or our own come back
    std::string advice;              ///< what the operator should look at; empty where all is well
};

/// The conversation with a sonar head, by the Tritech DigSon notes: wait for life, ask who it is, let it centre, tell
/// the parameters, then ask for line after line. Lines themselves become pings elsewhere (PingReceiver): here they only
/// confirm the parameters. Given its time; it reads no clock, opens nothing.
/// Order: after each call take all output, in order, and call tick() at the deadline. `now` never goes back.
class HeadSession {
public:
    explicit HeadSession(const HeadSettings& settings, Duplex duplex = Duplex::FromHead,
                         std::uint8_t node = default_head_node);

    /// `day_ms`: time of day for heads that stamp their lines.
    void linkUp(Microseconds now, std::uint32_t day_ms = 0);
    void linkDown(Microseconds now);
    void received(Microseconds now, Bytes bytes);
    void tick(Microseconds now);
    /// Takes effect at once while the head scans (between two lines in half duplex), otherwise with the handshake.
    void setSettings(Microseconds now, const HeadSettings& settings);

    std::optional<FrameBytes> takeOutput();
    std::optional<Microseconds> deadline() const { return deadline_; }
    const HeadStatus& status() const { return status_; }

private:
    enum class Step { NoLink, Listen, Version, Block, BlockTail, Centre, Parameters, Poll, PollListen };

    void takeFrame(Microseconds now, const Frame& frame);
    void takeAlive(Microseconds now, const Alive& alive);
    void takeVersion(Microseconds now, const VersionData& version);
    void takeBlock(Microseconds now, const BBUserData& block);
    void takeLine(Microseconds now, const HeadData& line);

    void listen(Microseconds now);
    void judgeSilence(Microseconds now);
    void foundRunning(Microseconds now);
    void reboot(Microseconds now);
    void identify(Microseconds now);
    void askBlock(Microseconds now);
    void centre(Microseconds now);
    void configure(Microseconds now);
    void probe(Microseconds now);
    void handshakeTimedOut(Microseconds now);
    void noAnswer(Microseconds now);
    void askAgain(Microseconds now, FrameBytes question, Microseconds within);
    void nothingHeard(Microseconds now);
    void notReadyYet(Microseconds now);

    void poll(Microseconds now);
    void trigger(Microseconds now);
    void tryToResume(Microseconds now, const HeadData& line);
    void takePolledLine(Microseconds now, const HeadData& line);
    bool headIsInTrouble(Microseconds now, const HeadData& line);
    void compareWithOrders(const HeadData& line);
    void sendChange();
    void lineTimedOut(Microseconds now);
    void headWasReset(Microseconds now);
    Microseconds lineTimeout() const;

    void enter(Step step, HeadState state, Microseconds now);
    void send(FrameBytes frame) { output_.push_back(std::move(frame)); }
    void forgetPartialFrames();
    void giveUpPartialFrames(Microseconds now);
    void refreshIdentity();
    void countRejected();

    HeadSettings settings_;
    Duplex duplex_;
    HeadIdentity head_;
    HeadStatus status_;
    FrameParser parser_;
    HeadDataAssembler assembler_;
    std::deque<FrameBytes> output_;

    Step step_ = Step::NoLink;
    Microseconds since_{0};  ///< the step began
    std::optional<Microseconds> deadline_;
    int tries_ = 0;  ///< within the step
    Microseconds link_since_{0}, last_bytes_{0}, quiet_until_{0};
    std::uint32_t day_ms_ = 0;
    std::optional<Alive> alive_;
    Microseconds alive_at_{0};

    // what tells a silent head from a wrong one, since the session began to listen
    std::uint64_t bytes_heard_ = 0, text_heard_ = 0, echoes_ = 0;
    std::optional<std::uint8_t> other_node_;
    bool answered_ = false;
    std::uint64_t malformed_ = 0;  ///< whole frames whose content cannot be

    HeadCommand command_;                 ///< what the settings ask for
    std::optional<HeadCommand> in_head_;  ///< what it was last told, while it may still hold it
    int reboots_in_a_row_ = 0;
    int misses_ = 0, unlike_ = 0, repeats_ = 0, troubled_ = 0;
    Microseconds asked_at_{0};
    std::optional<Microseconds> rebooted_for_motor_;
    bool told_since_line_ = false, tell_all_ = false;
};

}  // namespace echotrail::seanet
