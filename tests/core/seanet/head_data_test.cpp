#include "core/seanet/head_data.hpp"

#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace echotrail::seanet {
namespace {

using Causes = std::map<std::string, std::uint64_t>;

HeadData someLine(std::size_t data_bytes) {
    HeadData line;
    line.device_type = 0x11;
    line.head_control = 0x2301;
    line.range_scale = 500;
    line.transmit_word = 87'241'523;
    line.ad_interval = 133;
    line.left_limit = 1778;
    line.right_limit = 4622;
    line.step = 32;
    line.bearing = 3118;
    for (std::size_t i = 0; i < data_bytes; ++i) line.data.push_back(static_cast<std::uint8_t>(7 * i));
    line.data_bytes = static_cast<std::uint16_t>(data_bytes);
    line.total = static_cast<std::uint16_t>(data_bytes + head_parameter_bytes);
    return line;
}

/// A line in packets of at most `most` bytes of payload.
std::vector<ByteVector> packetsOf(const HeadData& line, std::size_t most) {
    const ByteVector payload = encodeHeadPayload(line);
    std::vector<ByteVector> packets;
    for (std::size_t at = 0; at < payload.size(); at += most) {
        const auto part = Bytes(payload).subspan(at, std::min(most, payload.size() - at));
        const std::size_t last = at + most >= payload.size() ? 0x80 : 0;
        packets.push_back(makeFrame(2, 255, 2, static_cast<std::uint8_t>(packets.size() | last), 2, part));
    }
    return packets;
}

std::vector<HeadData> linesOf(HeadDataAssembler& assembler, const std::vector<ByteVector>& packets) {
    std::vector<HeadData> lines;
    for (const ByteVector& packet : packets)
        if (auto line = assembler.take(Frame{packet})) lines.push_back(std::move(*line));
    return lines;
}

TEST(HeadData, ALineComesBackFromItsOwnPayload) {
    HeadData line = someLine(45);
    line.status = 0x90;
    line.sweep_code = 2;
    line.gain = 88;
    line.slope = 0x0173;
    line.ad_span = 135;
    line.ad_low = 34;
    line.heading_offset = 0x1234;
    line.extra = {1, 2, 3};
    const auto again = decodeHeadData(encodeHeadPayload(line));
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, line);
}

TEST(HeadData, ALineOfAnySizeComesBackFromAnyPackets) {
    for (const std::size_t data_bytes : {0u, 1u, 44u, 148u, 801u, 1500u})
        for (const std::size_t most : {1u, 31u, 90u, 130u, 4000u}) {
            if ((data_bytes + head_parameter_bytes - 1) / most > 127) continue;  // seven bits count the packets
            HeadDataAssembler assembler;
            const auto lines = linesOf(assembler, packetsOf(someLine(data_bytes), most));
            ASSERT_EQ(lines.size(), 1u) << data_bytes << " bytes in packets of " << most;
            ASSERT_EQ(lines[0], someLine(data_bytes));
            EXPECT_FALSE(assembler.giveUpUnfinished());
            EXPECT_TRUE(assembler.rejected().empty());
        }
}

TEST(HeadData, ALostPacketCostsItsLineOnly) {
    const auto packets = packetsOf(someLine(400), 90);
    ASSERT_EQ(packets.size(), 5u);
    for (std::size_t lost = 0; lost < packets.size(); ++lost) {
        std::vector<ByteVector> sent = packets;
        sent.erase(sent.begin() + static_cast<std::ptrdiff_t>(lost));
        sent.insert(sent.begin(), packets.begin(), packets.end());
        sent.insert(sent.end(), packets.begin(), packets.end());
        HeadDataAssembler assembler;
        const auto lines = linesOf(assembler, sent);
        ASSERT_EQ(lines.size(), 2u) << "without packet " << lost;
        ASSERT_EQ(lines[1], someLine(400));
        std::uint64_t rejections = 0;
        for (const auto& [cause, number] : assembler.rejected()) rejections += number;
        EXPECT_EQ(rejections, 1u) << "without packet " << lost;
    }
}

TEST(HeadData, ANewLineBeforeTheOldWasWholeReplacesIt) {
    auto packets = packetsOf(someLine(148), 90);
    ASSERT_EQ(packets.size(), 2u);
    packets.insert(packets.begin(), packets[0]);
    HeadDataAssembler assembler;
    const auto lines = linesOf(assembler, packets);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0], someLine(148));
    EXPECT_EQ(assembler.rejected(), (Causes{{"unfinished_line", 1}}));
}

TEST(HeadData, GivingUpForgetsAnUnfinishedLine) {
    const auto packets = packetsOf(someLine(148), 90);
    HeadDataAssembler assembler;
    EXPECT_FALSE(assembler.giveUpUnfinished());
    EXPECT_FALSE(assembler.take(Frame{packets[0]}));
    EXPECT_TRUE(assembler.giveUpUnfinished());
    EXPECT_FALSE(assembler.take(Frame{packets[1]}));
    EXPECT_TRUE(assembler.rejected().empty());  // the rest of what was given up is no second loss
}

TEST(HeadData, AStreamThatBeginsInsideALineLostNothing) {
    auto packets = packetsOf(someLine(400), 90);
    const auto whole = packets;
    packets.erase(packets.begin(), packets.begin() + 2);
    packets.insert(packets.end(), whole.begin(), whole.end());
    HeadDataAssembler assembler;
    EXPECT_EQ(linesOf(assembler, packets).size(), 1u);
    EXPECT_TRUE(assembler.rejected().empty());
}

TEST(HeadData, CountsThatDisagreeAreRefused) {
    const ByteVector good = encodeHeadPayload(someLine(20));
    const auto causeOf = [&](std::size_t at, unsigned value) {
        ByteVector bad = good;
        bad[at] = static_cast<std::uint8_t>(value);
        const auto line = decodeHeadData(bad);
        return line ? "none" : line.error();
    };
    EXPECT_EQ(causeOf(0, 50), "counts_differ");
    EXPECT_EQ(causeOf(29, 21), "counts_differ");
    EXPECT_EQ(causeOf(28, 0x19), "bad_bearing");  // beyond 6399
    EXPECT_EQ(causeOf(13, 99), "none");
}

TEST(HeadData, PayloadsOfAnyLengthAreReadWithinTheirBounds) {
    const ByteVector good = encodeHeadPayload(someLine(20));
    for (std::size_t length = 0; length < good.size(); ++length) {
        const auto block = std::make_unique<std::uint8_t[]>(length);
        std::copy_n(good.begin(), length, block.get());
        const auto line = decodeHeadData(Bytes(block.get(), length));
        ASSERT_FALSE(line);
        EXPECT_EQ(line.error(), "short_line");
    }
    EXPECT_TRUE(decodeHeadData(good));
}

TEST(HeadData, FourBitLinesHoldTwoBinsAByte) {
    HeadData line = someLine(7);
    EXPECT_EQ(line.bins(), 7u);
    line.head_control = 0x2302;
    EXPECT_EQ(line.bins(), 14u);
    EXPECT_FALSE(line.eightBit());
}

}  // namespace
}  // namespace echotrail::seanet
