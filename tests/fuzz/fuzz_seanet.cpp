#include "core/seanet/commands.hpp"
#include "core/seanet/head_data.hpp"
#include "core/seanet/messages.hpp"
#include "core/seanet/ping_decoder.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

// Any bytes through the parser, the assembler and the decoders: nothing outside is read, every byte is accounted for,
// and the split of the stream changes nothing.
namespace echotrail::seanet {
namespace {

void require(bool law, const char* what) {
    if (law) return;
    std::fprintf(stderr, "broken law: %s\n", what);
    std::abort();
}

using Found = std::vector<std::pair<std::uint64_t, std::vector<std::uint8_t>>>;

void decodeAll(const Frame& frame, HeadDataAssembler& assembler) {
    decodeMessage(frame);
    if (const auto command = decodeHeadCommand(frame.payload()))
        require(Frame{encodeHeadCommand(*command)}.payload().size() == frame.payload().size(), "commands come back");
    decodeGains(frame.payload());
    const auto line = assembler.take(frame);
    if (!line) return;
    const Ping ping = pingFrom(*line, 0, Timestamp{}, 1500.0);
    require(ping.levels.size() == line->bins(), "a level for every bin");
    require(pingDurationSeconds(*line, 1500.0) > 0, "pings last");
    const auto again = decodeHeadData(encodeHeadPayload(*line));
    require(again && *again == *line, "lines come back");
}

Found framesOf(Bytes stream, std::size_t chunk, HeadDataAssembler& assembler) {
    FrameParser parser;
    Found found;
    std::uint64_t in_frames = 0;
    const auto sink = [&](const Frame& frame) {
        found.emplace_back(frame.stream_offset, std::vector<std::uint8_t>(frame.bytes.begin(), frame.bytes.end()));
        in_frames += frame.bytes.size();
        decodeAll(frame, assembler);
    };
    for (std::size_t at = 0; at < stream.size(); at += chunk) {
        parser.take(stream.subspan(at, std::min(chunk, stream.size() - at)), sink);
        require(parser.unfinishedBytes() < FrameParser::longest_frame, "no more is held than a frame");
    }
    parser.giveUpUnfinished(sink);
    require(in_frames + parser.skippedBytes() == stream.size(), "every byte is accounted for");
    require(parser.frames() == found.size(), "frames are counted");
    return found;
}

}  // namespace
}  // namespace echotrail::seanet

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace echotrail::seanet;
    if (size == 0) return 0;
    const Bytes stream(data + 1, size - 1);
    HeadDataAssembler whole_assembler, split_assembler;
    const Found whole = framesOf(stream, std::max<std::size_t>(stream.size(), 1), whole_assembler);
    const Found split = framesOf(stream, data[0] % 64 + 1u, split_assembler);
    require(whole == split, "the split changes nothing");
    require(whole_assembler.rejected() == split_assembler.rejected(), "the split changes no counts");
    return 0;
}
