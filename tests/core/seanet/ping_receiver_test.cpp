#include "core/seanet/ping_receiver.hpp"

#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace echotrail::seanet {
namespace {

constexpr Timestamp start{Microseconds(1'700'000'000'000'000)};

HeadData lineAt(std::uint16_t bearing) {
    HeadData line;
    line.device_type = 2;
    line.head_control = 0x2305;
    line.range_scale = 500;
    line.ad_interval = 104;
    line.left_limit = 2400;
    line.right_limit = 4000;
    line.step = 32;
    line.bearing = bearing;
    line.data.assign(500, 40);
    return line;
}

struct Receiving {
    PingReceiver receiver{1500.0};
    std::vector<Ping> pings;
    void take(double after_s, Bytes bytes) {
        receiver.take(start + microsecondsFromSeconds(after_s), bytes,
                      [this](Ping&& ping) { pings.push_back(std::move(ping)); });
    }
    void reset() {
        receiver.reset([this](Ping&& ping) { pings.push_back(std::move(ping)); });
    }
};

TEST(PingReceiver, APingIsOfTheReadThatHeldItsFirstByteLessTheSoundsWay) {
    const auto bytes = encodeHeadData(lineAt(3200));
    Receiving r;
    r.take(1.00, Bytes(bytes).first(10));
    r.take(1.05, Bytes(bytes).subspan(10));
    ASSERT_EQ(r.pings.size(), 1u);
    const double flight_s = 500 * 104 * 640e-9;
    EXPECT_NEAR(secondsBetween(start, r.pings[0].time), 1.00 - flight_s - 0.003, 1e-6);
}

TEST(PingReceiver, PingsOfOneReadStayInOrder) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 3; ++i) {
        const auto line = encodeHeadData(lineAt(static_cast<std::uint16_t>(3200 + 32 * i)));
        bytes.insert(bytes.end(), line.begin(), line.end());
    }
    Receiving r;
    r.take(1.0, bytes);
    ASSERT_EQ(r.pings.size(), 3u);
    EXPECT_EQ(r.pings[1].time - r.pings[0].time, Microseconds(1));
    EXPECT_EQ(r.pings[2].sequence, 2u);
}

TEST(PingReceiver, AFrameThatFallsSilentIsGivenUpAndTheNextOneIsWhole) {
    const auto bytes = encodeHeadData(lineAt(3200));
    Receiving r;
    r.take(1.0, Bytes(bytes).first(300));
    r.take(3.0, bytes);
    EXPECT_EQ(r.pings.size(), 1u);
    EXPECT_EQ(r.receiver.counts().rejected.at("cut_frame"), 1u);
    EXPECT_GE(r.receiver.counts().lost_records, 1u);
}

TEST(PingReceiver, ABrokenLinkEndsTheFrameThatHadBegun) {
    const auto bytes = encodeHeadData(lineAt(3200));
    Receiving r;
    r.take(1.0, Bytes(bytes).first(300));
    r.reset();
    r.take(1.1, bytes);
    EXPECT_EQ(r.pings.size(), 1u);
    EXPECT_EQ(r.receiver.counts().rejected.at("cut_frame"), 1u);
    r.reset();
    EXPECT_EQ(r.receiver.counts().rejected.at("cut_frame"), 1u);  // nothing had begun
}

TEST(PingReceiver, AFrameUnfinishedAtTheEndIsCountedButNoLoss) {
    const auto bytes = encodeHeadData(lineAt(3200));
    Receiving r;
    r.take(1.0, bytes);
    auto cut = Bytes(bytes).first(300);
    std::vector<std::uint8_t> with_noise(cut.begin(), cut.end());
    with_noise[200] = '@';  // what looks like a beginning inside it
    r.take(1.2, with_noise);
    r.receiver.finish([](Ping&&) { FAIL(); });
    EXPECT_EQ(r.receiver.counts().lost_records, 0u);
    EXPECT_TRUE(r.receiver.counts().rejected.empty());
    EXPECT_EQ(r.receiver.counts().ignored.at("unfinished frame"), 1u);
}

TEST(PingReceiver, ARealStreamInDatagramsLosesNothing) {
    const std::string path = sharedCapture("seaking_dst_udp/sonar_stream_part1.bin");
    if (path.empty()) GTEST_SKIP() << "needs the shared recordings";
    const ByteVector bytes = readBytes(path);
    Receiving r;
    for (std::size_t at = 0, i = 0; at < bytes.size(); at += 104, ++i)
        r.take(0.0097 * static_cast<double>(i),
               Bytes(bytes).subspan(at, std::min<std::size_t>(104, bytes.size() - at)));
    ASSERT_EQ(r.pings.size(), 509u);
    EXPECT_EQ(r.receiver.counts().lost_records, 0u);
    for (std::size_t i = 1; i < r.pings.size(); ++i)
        EXPECT_NEAR(secondsBetween(r.pings[i - 1].time, r.pings[i].time), 0.0784, 0.012);
}

TEST(PingReceiver, ByteByByteGivesTheSameLevelsAsAtOnce) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 5; ++i) {
        const auto line = encodeHeadData(lineAt(static_cast<std::uint16_t>(3200 + 32 * i)));
        bytes.insert(bytes.end(), line.begin(), line.end());
        bytes.push_back('@');  // noise between the lines
    }
    Receiving once, single;
    once.take(1.0, bytes);
    for (std::size_t i = 0; i < bytes.size(); ++i) single.take(1.0, Bytes(bytes).subspan(i, 1));
    ASSERT_EQ(once.pings.size(), 5u);
    EXPECT_EQ(once.pings, single.pings);
}

}  // namespace
}  // namespace echotrail::seanet
