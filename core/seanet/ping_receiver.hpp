#pragma once

#include "core/data/ping.hpp"
#include "core/data/source.hpp"
#include "core/seanet/frame_parser.hpp"
#include "core/seanet/head_data.hpp"

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace echotrail::seanet {

/// Bytes from a live head with the time each read brought them; out come pings. The same reads give the same pings,
/// live or from a recording.
/// A ping's time is when the read that held its line's first byte came, less the sound's way to the range's end and
/// back, less 3 ms that heads take to begin sending; where that is not later than the ping before, 1 µs after it.
/// Order: reads in the order they came; link() wherever the link was made or broke.
class PingReceiver {
public:
    using Sink = std::function<void(Ping&&)>;
    static constexpr Microseconds longest_silence{1'000'000};  ///< within a frame; longer, and its rest is not coming
    static constexpr Microseconds head_latency{3'000};

    explicit PingReceiver(double sound_speed_mps) : sound_speed_mps_(sound_speed_mps) {}
    void setSoundSpeed(double mps) { sound_speed_mps_ = mps; }

    void take(Timestamp arrival, Bytes bytes, const Sink& sink);
    /// The link broke: a frame that had begun is lost.
    void reset(const Sink& sink);
    /// The run is over: a frame that had begun is counted, but is no loss.
    void finish(const Sink& sink);

    SourceCounts counts() const;

private:
    struct Read {
        std::uint64_t offset = 0;  ///< in the stream, of its first byte
        Timestamp arrival{};
    };
    void takeFrame(const Frame& frame, const Sink& sink);
    bool giveUp(const Sink& sink);
    Timestamp arrivalOf(std::uint64_t offset) const;

    double sound_speed_mps_;
    FrameParser parser_;
    HeadDataAssembler assembler_;
    std::deque<Read> reads_;  ///< that an unfinished frame may begin in
    std::uint64_t received_ = 0;
    Timestamp line_began_{};
    std::optional<Timestamp> last_arrival_, last_ping_;
    std::uint64_t sequence_ = 0;
    SourceCounts own_counts_;
    std::optional<SourceCounts> final_counts_;  ///< after finish()
};

}  // namespace echotrail::seanet
