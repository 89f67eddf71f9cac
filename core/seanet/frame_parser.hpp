#pragma once

#include "core/seanet/bytes.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace echotrail::seanet {

/// A whole frame: `@`, four hex digits and a binary number that agree on the length, a body, a line feed. Layout from
/// the Tritech DigSon notes; offsets count from the `@`. There is no checksum.
struct Frame {
    Bytes bytes;                      ///< the whole frame; valid during the callback only
    std::uint64_t stream_offset = 0;  ///< of the `@`

    std::uint8_t source() const { return bytes[7]; }
    std::uint8_t destination() const { return bytes[8]; }
    std::uint8_t count() const { return bytes[9]; }  ///< bytes after it, or 0 in a single-packet line
    std::uint8_t id() const { return bytes[10]; }
    std::uint8_t sequence() const { return bytes[11]; }
    std::uint8_t node() const { return bytes[12]; }
    /// What follows the header, without the line feed.
    Bytes payload() const { return bytes.subspan(13, bytes.size() - 14); }
};

/// Bytes in, in any split; whole frames out. On any failure it gives up one byte and searches on, so that a damaged
/// frame never hides a whole one behind it, not even where lost bytes drew that one's beginning into it. No length is
/// trusted before the line feed is in its place. State: the bytes of an unfinished frame, at most `longest_frame`;
/// counts since construction.
class FrameParser {
public:
    static constexpr std::size_t shortest_frame = 14;
    static constexpr std::size_t longest_frame = 4096;
    using Sink = std::function<void(const Frame&)>;

    void take(Bytes bytes, const Sink& sink);
    /// The rest of an unfinished frame is not coming (a time-out, or the end of the data): what was held back is
    /// searched for whole frames, and the remains are counted as skipped. True if a frame had begun.
    bool giveUpUnfinished(const Sink& sink);

    std::uint64_t frames() const { return frames_; }
    /// Bytes that belong to no whole frame; those before the first frame are among them.
    std::uint64_t skippedBytes() const { return skipped_; }
    std::uint64_t skippedBeforeFirstFrame() const { return skipped_before_first_; }
    /// Cause → beginnings of frames (an `@`) that turned out to be none after the first whole frame.
    const std::map<std::string, std::uint64_t>& rejected() const { return rejected_; }
    /// Runs of bytes that belong to no frame, after the first frame: each hides a damaged one.
    std::uint64_t damagedStretches() const { return damaged_stretches_; }
    std::size_t unfinishedBytes() const { return buffer_.size() - begin_; }

private:
    enum class Check { Whole, Incomplete, BadLength, LengthsDiffer, NoLineFeed, BytesLost };
    Check check(Bytes bytes, std::size_t& length) const;
    void extract(const Sink& sink);
    void skip(std::size_t bytes);
    void reject(const char* cause);

    std::vector<std::uint8_t> buffer_;
    std::size_t begin_ = 0;       ///< of what is not consumed in buffer_
    std::uint64_t consumed_ = 0;  ///< stream offset of buffer_[begin_]
    std::uint64_t frames_ = 0, skipped_ = 0, skipped_before_first_ = 0;
    std::uint64_t damaged_stretches_ = 0;
    bool in_damage_ = false;
    std::map<std::string, std::uint64_t> rejected_;
};

/// Puts a body into a frame: lengths, nodes, count, id, sequence and the line feed. `count` 0 is the single-packet
/// form of a line; otherwise it is worked out.
std::vector<std::uint8_t> makeFrame(std::uint8_t source, std::uint8_t destination, std::uint8_t id,
                                    std::uint8_t sequence, std::uint8_t node, Bytes payload, bool zero_count = false);

}  // namespace echotrail::seanet
