#include "core/seanet/frame_parser.hpp"
#include "core/seanet/head_data.hpp"
#include "core/seanet/ping_decoder.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <vector>

// How many times faster than the wire (115 200 baud, 11 520 bytes a second) the stream of a head is understood, in
// pieces as they come from a serial port, a serial server and a file.
namespace echotrail::seanet {
namespace {

/// A minute of lines of 800 bins.
std::vector<std::uint8_t> someStream() {
    HeadData line;
    line.head_control = 0x2301;
    line.range_scale = 500;
    line.ad_interval = 133;
    line.step = 32;
    std::vector<std::uint8_t> stream;
    for (unsigned ping = 0; ping < 800; ++ping) {
        line.bearing = static_cast<std::uint16_t>(ping * line.step % 6400);
        line.data.resize(800);
        for (unsigned bin = 0; bin < 800; ++bin)
            line.data[bin] = static_cast<std::uint8_t>((bin * bin + 37 * ping) % 151);  // with its share of '@' and LF
        const auto frame = encodeHeadData(line);
        stream.insert(stream.end(), frame.begin(), frame.end());
    }
    return stream;
}

template <class Sink>
void inChunks(benchmark::State& state, Sink&& sink) {
    const auto stream = someStream();
    const auto chunk = static_cast<std::size_t>(state.range(0));
    for (auto _ : state) {
        FrameParser parser;
        for (std::size_t at = 0; at < stream.size(); at += chunk)
            parser.take(Bytes(stream).subspan(at, std::min(chunk, stream.size() - at)), sink);
        if (parser.frames() != 800) state.SkipWithError("frames are missing");
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(stream.size()));
}

void findFrames(benchmark::State& state) {
    inChunks(state, [](const Frame& frame) { benchmark::DoNotOptimize(frame.bytes.data()); });
}
BENCHMARK(findFrames)->Arg(1)->Arg(104)->Arg(4096)->Arg(65'536)->Unit(benchmark::kMicrosecond);

void findAndDecodePings(benchmark::State& state) {
    HeadDataAssembler assembler;
    inChunks(state, [&](const Frame& frame) {
        if (const auto line = assembler.take(frame)) benchmark::DoNotOptimize(pingFrom(*line, 0, Timestamp{}, 1490.0));
    });
}
BENCHMARK(findAndDecodePings)->Arg(104)->Arg(65'536)->Unit(benchmark::kMicrosecond);

void searchNoise(benchmark::State& state) {
    std::vector<std::uint8_t> noise(1 << 20);
    std::uint32_t word = 1;
    for (auto& byte : noise) byte = static_cast<std::uint8_t>((word = word * 1'664'525 + 1'013'904'223) >> 24);
    for (auto _ : state) {
        FrameParser parser;
        for (std::size_t at = 0; at < noise.size(); at += 4096)
            parser.take(Bytes(noise).subspan(at, 4096), [](const Frame&) {});
        benchmark::DoNotOptimize(parser.skippedBytes());
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(noise.size()));
}
BENCHMARK(searchNoise)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace echotrail::seanet
