#include "core/seanet/frame_parser.hpp"

#include "core/base/random.hpp"
#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace echotrail::seanet {
namespace {

using Found = std::vector<std::pair<std::uint64_t, ByteVector>>;  // offset of each frame, and its bytes

/// Everything found when the stream comes in pieces of `chunk` bytes. The unfinished rest is not given up.
Found framesOf(const ByteVector& stream, std::size_t chunk, FrameParser& parser) {
    Found found;
    for (std::size_t at = 0; at < stream.size(); at += chunk) {
        const auto piece = Bytes(stream).subspan(at, std::min(chunk, stream.size() - at));
        parser.take(piece, [&](const Frame& frame) {
            found.emplace_back(frame.stream_offset, ByteVector(frame.bytes.begin(), frame.bytes.end()));
        });
    }
    return found;
}

Found framesOf(const ByteVector& stream) {
    FrameParser parser;
    return framesOf(stream, stream.size(), parser);
}

/// A frame whose body holds what a parser could stumble over: `@`, line feeds, hex digits.
ByteVector someFrame(std::uint8_t marker) {
    return makeFrame(2, 255, 2, 0x80, 2, ByteVector{marker, '@', '0', '0', 0x0A, '@', '@', 0x0A, marker}, true);
}

ByteVector noise(std::uint64_t seed, std::size_t bytes) {
    RandomStream random(seed, 0, 0);
    ByteVector out(bytes);
    for (auto& byte : out) byte = static_cast<std::uint8_t>(random.bits());
    return out;
}

TEST(FrameParser, ReadsTheHeaderOfAFrame) {
    const ByteVector bytes = makeFrame(2, 255, 4, 0x80, 7, ByteVector{1, 2, 3});
    ASSERT_EQ(bytes.size(), 17u);
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 5), "@000B");
    FrameParser parser;
    parser.take(bytes, [](const Frame& frame) {
        EXPECT_EQ(frame.source(), 2);
        EXPECT_EQ(frame.destination(), 255);
        EXPECT_EQ(frame.count(), 6);
        EXPECT_EQ(frame.id(), 4);
        EXPECT_EQ(frame.sequence(), 0x80);
        EXPECT_EQ(frame.node(), 7);
        EXPECT_EQ(ByteVector(frame.payload().begin(), frame.payload().end()), (ByteVector{1, 2, 3}));
    });
    EXPECT_EQ(parser.frames(), 1u);
    EXPECT_EQ(parser.skippedBytes(), 0u);
}

TEST(FrameParser, EveryCutOfAStreamGivesTheSameFrames) {
    const ByteVector stream =
        joined({{0x0A, 'x', '@', 'z'}, someFrame(1), {'@'}, someFrame(2), {'@', '0', '0'}, someFrame(3)});
    FrameParser whole_parser;
    const Found whole = framesOf(stream, stream.size(), whole_parser);
    ASSERT_EQ(whole.size(), 3u);
    EXPECT_EQ(whole_parser.skippedBytes(), 8u);
    EXPECT_EQ(whole_parser.skippedBeforeFirstFrame(), 4u);
    EXPECT_EQ(whole_parser.damagedStretches(), 2u);
    for (std::size_t first = 0; first <= stream.size(); ++first)
        for (std::size_t second = first; second <= stream.size(); ++second) {
            FrameParser parser;
            Found found;
            const auto sink = [&](const Frame& frame) {
                found.emplace_back(frame.stream_offset, ByteVector(frame.bytes.begin(), frame.bytes.end()));
            };
            parser.take(Bytes(stream).first(first), sink);
            parser.take(Bytes(stream).subspan(first, second - first), sink);
            parser.take(Bytes(stream).subspan(second), sink);
            ASSERT_EQ(found, whole) << "cut at " << first << " and " << second;
            ASSERT_EQ(parser.skippedBytes(), whole_parser.skippedBytes());
            ASSERT_EQ(parser.rejected(), whole_parser.rejected());
        }
}

TEST(FrameParser, ChunkSizesDoNotMatterOnARealStream) {
    const std::string path = sharedCapture("seaking_dst_udp/sonar_stream_part1.bin");
    if (path.empty()) GTEST_SKIP() << "needs the shared recordings";
    const ByteVector stream = readBytes(path);
    const Found whole = framesOf(stream);
    EXPECT_EQ(whole.size(), 509u);
    for (const std::size_t chunk : {1u, 7u, 104u, 4096u}) {
        FrameParser parser;
        EXPECT_EQ(framesOf(stream, chunk, parser), whole) << "chunks of " << chunk;
        EXPECT_EQ(parser.skippedBeforeFirstFrame(), 24u);
        EXPECT_EQ(parser.skippedBytes(), 24u);
        EXPECT_EQ(parser.unfinishedBytes(), 677u);
        EXPECT_EQ(parser.damagedStretches(), 0u);
        EXPECT_TRUE(parser.rejected().empty());
    }
}

TEST(FrameParser, OneFlippedBitCostsOneFrameAtMost) {
    const ByteVector frames[] = {someFrame(1), someFrame(2), someFrame(3)};
    const std::size_t begin = frames[0].size(), end = begin + frames[1].size();
    for (std::size_t bit = 8 * begin; bit < 8 * end; ++bit) {
        ByteVector stream = joined({frames[0], frames[1], frames[2]});
        stream[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
        FrameParser parser;
        const Found found = framesOf(stream, stream.size(), parser);
        ASSERT_GE(found.size(), 2u) << "bit " << bit;
        ASSERT_EQ(found.front(), std::pair(std::uint64_t{0}, frames[0]));
        ASSERT_EQ(found.back(), std::pair(std::uint64_t{end}, frames[2]));
        ASSERT_EQ(parser.damagedStretches(), 3 - found.size()) << "bit " << bit;
    }
}

TEST(FrameParser, RefusesByCauseAndGoesOn) {
    const auto causeOf = [](const ByteVector& damaged) {
        FrameParser parser;
        const ByteVector stream = joined({someFrame(1), damaged, someFrame(2)});
        EXPECT_EQ(framesOf(stream, stream.size(), parser).size(), 2u);
        EXPECT_EQ(parser.damagedStretches(), 1u);
        return parser.rejected();
    };
    const ByteVector good = makeFrame(2, 255, 4, 0x80, 2, ByteVector{1, 2, 3});
    const auto with = [&](std::size_t at, int value) {
        ByteVector changed = good;
        changed[at] = static_cast<std::uint8_t>(value);
        return changed;
    };
    using Causes = std::map<std::string, std::uint64_t>;
    EXPECT_EQ(causeOf(with(5, 0x0C)), (Causes{{"lengths_differ", 1}}));
    EXPECT_EQ(causeOf(with(4, 'G')), (Causes{{"bad_length", 1}}));
    EXPECT_EQ(causeOf(with(16, 0x0D)), (Causes{{"no_line_feed", 1}}));
    EXPECT_EQ(causeOf(joined({{'@', '0', '0', '0', '7', 7, 0}, ByteVector(6, 0x0A)})), (Causes{{"bad_length", 1}}));
    EXPECT_EQ(causeOf(joined({{'@', 'F', 'F', 'F', 'F', 0xFF, 0xFF}, ByteVector(9, 0)})), (Causes{{"bad_length", 1}}));
}

TEST(FrameParser, AcceptsSmallHexDigits) {
    ByteVector frame = makeFrame(2, 255, 4, 0x80, 2, ByteVector{1, 2, 3});
    ASSERT_EQ(frame[4], 'B');
    frame[4] = 'b';
    EXPECT_EQ(framesOf(frame).size(), 1u);
}

TEST(FrameParser, FindsEveryFrameBetweenGarbage) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        ByteVector stream;
        for (std::uint8_t i = 0; i < 20; ++i) stream = joined({stream, noise(100 * seed + i, 37 * i), someFrame(i)});
        const Found found = framesOf(stream);
        for (std::uint8_t i = 0; i < 20; ++i)
            ASSERT_TRUE(
                std::any_of(found.begin(), found.end(), [&](const auto& f) { return f.second == someFrame(i); }))
                << "seed " << seed << ", frame " << int{i};
    }
}

TEST(FrameParser, AccountsForEveryByte) {
    const ByteVector stream = joined({noise(1, 500), someFrame(1), noise(2, 700), someFrame(2), {'@', '0', '0', '5'}});
    FrameParser parser;
    std::size_t in_frames = 0;
    for (const auto& [offset, bytes] : framesOf(stream, 11, parser)) {
        EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), stream.begin() + static_cast<std::ptrdiff_t>(offset)));
        in_frames += bytes.size();
    }
    EXPECT_EQ(in_frames + parser.skippedBytes() + parser.unfinishedBytes(), stream.size());
    EXPECT_EQ(parser.unfinishedBytes(), 4u);
}

TEST(FrameParser, HoldsNoMoreThanTheLongestFrame) {
    FrameParser parser;
    const ByteVector beginning = {'@', '0', 'F', 'F', 'A', 0xFA, 0x0F};  // of the longest frame: 4096 bytes
    parser.take(beginning, [](const Frame&) {});
    for (int i = 0; i < 1000; ++i) {
        parser.take(noise(static_cast<std::uint64_t>(i), 100), [](const Frame&) {});
        ASSERT_LT(parser.unfinishedBytes(), FrameParser::longest_frame);
    }
}

TEST(FrameParser, GivingUpFindsTheWholeFrameInsideAnUnfinishedOne) {
    const ByteVector beginning = {'@', '0', '3', '0', '0', 0x00, 0x03, 2, 255};
    const ByteVector stream = joined({someFrame(1), beginning, someFrame(2)});
    FrameParser parser;
    EXPECT_EQ(framesOf(stream, 5, parser).size(), 1u);
    Found found;
    const auto sink = [&](const Frame& frame) {
        found.emplace_back(frame.stream_offset, ByteVector(frame.bytes.begin(), frame.bytes.end()));
    };
    EXPECT_TRUE(parser.giveUpUnfinished(sink));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], std::pair(std::uint64_t{someFrame(1).size() + beginning.size()}, someFrame(2)));
    EXPECT_EQ(parser.unfinishedBytes(), 0u);
    EXPECT_EQ(parser.skippedBytes(), beginning.size());
    EXPECT_FALSE(parser.giveUpUnfinished(sink));
}

TEST(FrameParser, ATruncatedTailWaitsForItsRest) {
    const ByteVector frame = someFrame(1);
    for (std::size_t cut = 1; cut < frame.size(); ++cut) {
        FrameParser parser;
        const auto ignore = [](const Frame&) {};
        parser.take(Bytes(frame).first(cut), ignore);
        ASSERT_EQ(parser.frames(), 0u);
        ASSERT_EQ(parser.unfinishedBytes(), cut);
        parser.take(Bytes(frame).subspan(cut), ignore);
        ASSERT_EQ(parser.frames(), 1u);
    }
}

TEST(FrameParser, BytesLostInsideAFrameCostThatFrameOnly) {
    // The damaged frame's length reaches into the next one, to a byte that happens to be a line feed.
    ByteVector damaged = makeFrame(2, 255, 2, 0x80, 2, ByteVector(60, 0x0A), true);
    const ByteVector next = makeFrame(2, 255, 2, 0x80, 2, ByteVector(50, 0x0A), true);
    damaged.erase(damaged.end() - 30, damaged.end());
    const Found found = framesOf(joined({someFrame(1), damaged, next, someFrame(2)}));
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[1].second, next);
}

}  // namespace
}  // namespace echotrail::seanet
