#include "core/seanet/head_session.hpp"

#include "tests/core/seanet/fake_head.hpp"

#include <gtest/gtest.h>

namespace echotrail::seanet {
namespace {

using namespace std::chrono_literals;

void expectPolling(Conversation& talk) {
    EXPECT_EQ(talk.status().state, HeadState::Polling);
    EXPECT_EQ(talk.status().difference, "");
    EXPECT_EQ(talk.status().advice, "");
    EXPECT_GT(talk.status().pings, 20u);
    EXPECT_EQ(talk.head.offences, std::vector<std::string>());
}

TEST(HeadSession, ShakesHandsWithEveryKindOfHead) {
    for (const bool digital : {false, true})
        for (const bool half_duplex : {false, true}) {
            Conversation talk({.digital = digital, .half_duplex = half_duplex});
            talk.run(8);
            expectPolling(talk);
            EXPECT_EQ(talk.status().digital, digital);
            EXPECT_EQ(talk.status().half_duplex, half_duplex);
            EXPECT_EQ(talk.status().reboots_sent, 0u);
            EXPECT_EQ(talk.heard(MessageId::HeadCommand), 1);
        }
}

TEST(HeadSession, NamesTheHead) {
    Conversation analogue, digital({.digital = true});
    analogue.run(8);
    digital.run(8);
    EXPECT_EQ(analogue.status().head, "SeaKing DFS, serial 77, node 2, 325/675 kHz");
    EXPECT_EQ(digital.status().head, "SeaKing DST, serial 77, node 2, 700/350 kHz");
}

TEST(HeadSession, SlowAndRepeatedAnswersAreAnswers) {
    for (const bool digital : {false, true})
        for (const int repeats : {1, 3}) {
            Conversation talk({.digital = digital, .answer_delay = 1'500ms, .repeats = repeats});
            talk.run(15);
            expectPolling(talk);
        }
}

TEST(HeadSession, AHeadThatDoesNotTellItsSetupTakesTurns) {
    Conversation talk({.half_duplex = true, .deaf_to = {24}});
    talk.run(12);
    expectPolling(talk);
    EXPECT_TRUE(talk.status().half_duplex);
}

TEST(HeadSession, WaitsUntilTheHeadIsCentred) {
    Conversation talk;
    talk.head.powerUp(0s);
    talk.head.boot_until = 20s;
    talk.run(18);
    EXPECT_EQ(talk.status().state, HeadState::Centring);
    EXPECT_NE(talk.status().advice, "");
    EXPECT_EQ(talk.heard(MessageId::HeadCommand), 0);
    talk.run(10);
    expectPolling(talk);
}

TEST(HeadSession, SomebodyElsesParametersAreRebootedAway) {
    Conversation talk;
    talk.head.has_parameters = true;
    talk.run(12);
    expectPolling(talk);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
}

TEST(HeadSession, AHeadFoundScanningIsRebooted) {
    Conversation talk({.half_duplex = false});
    talk.head.command = commandFor({.range_m = 20}, {});
    talk.head.has_parameters = true;
    talk.head.trigger(0s);
    talk.run(12);
    expectPolling(talk);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
}

TEST(HeadSession, AHeadThatKeepsItsParametersIsNotRebootedForEver) {
    Conversation talk({.keeps_parameters = true});
    talk.head.has_parameters = true;
    talk.run(20);
    expectPolling(talk);
    EXPECT_LE(talk.heard(MessageId::ReBoot), 2);
}

TEST(HeadSession, StoppedAlivesComeBackWithAReboot) {
    Conversation talk({.alives_stopped = true});
    talk.run(4.5);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
    talk.head.alives_stopped = false;
    talk.run(12);
    expectPolling(talk);
}

TEST(HeadSession, InFullDuplexTheHeadAlwaysHasOneMoreToGoOnWith) {
    Conversation talk;
    talk.run(8);
    const auto before = talk.status().pings;
    talk.run(6);
    EXPECT_GE(talk.status().pings - before, 95u);  // 6 s of 60 ms lines, without a pause
}

TEST(HeadSession, LostLinesAreAskedForAgain) {
    for (const bool half_duplex : {false, true}) {
        Conversation talk({.half_duplex = half_duplex});
        talk.run(8);
        talk.head.lose_lines = 2;
        talk.run(8);
        expectPolling(talk);
        EXPECT_GE(talk.status().timeouts, 1u);
        EXPECT_EQ(talk.status().head_resets, 0u);
    }
}

TEST(HeadSession, AResetInMidScanIsNoticedAndTheParametersAreToldAgain) {
    for (const bool half_duplex : {false, true}) {
        Conversation talk({.half_duplex = half_duplex});
        talk.run(8);
        talk.head.powerUp(talk.now);
        talk.head.offences.clear();
        talk.run(3);
        talk.head.offences.clear();  // it asked on before it could know
        talk.run(12);
        expectPolling(talk);
        EXPECT_EQ(talk.status().head_resets, 1u);
        EXPECT_EQ(talk.status().reboots_sent, 0u);
    }
}

TEST(HeadSession, ASilentHeadIsToldOfAndFoundWhenItComes) {
    Conversation talk({.powered = false});
    talk.run(6);
    EXPECT_EQ(talk.status().state, HeadState::Silent);
    EXPECT_NE(talk.status().advice.find("power"), std::string::npos);
    talk.head.powerUp(talk.now);
    talk.run(12);
    expectPolling(talk);
}

TEST(HeadSession, AHeadThatFallsSilentInMidScanIsToldOf) {
    Conversation talk;
    talk.run(8);
    talk.head.powered = false;
    talk.run(12);
    EXPECT_EQ(talk.status().state, HeadState::Silent);
    EXPECT_NE(talk.status().advice, "");
    talk.head.powerUp(talk.now);
    talk.run(15);
    expectPolling(talk);
    EXPECT_GE(talk.status().head_resets, 1u);
}

TEST(HeadSession, AHeadThatIsHeardButDeafHasAWireOff) {
    Conversation talk({.deaf_to = {16, 19, 23, 24, 25}});
    talk.run(10);
    EXPECT_EQ(talk.status().state, HeadState::Silent);
    EXPECT_NE(talk.status().advice.find("wire"), std::string::npos);
    talk.head.deaf_to.clear();  // the wire is mended
    talk.run(8);
    expectPolling(talk);
}

TEST(HeadSession, SaysWhatElseMayBeOnTheLine) {
    const auto adviceAfter = [](const FrameBytes& bytes) {
        HeadSession session(HeadSettings{});
        session.linkUp(0s);
        for (Microseconds now = 0s; now < 6s; now += 100ms) {
            session.received(now, bytes);
            session.tick(now);
        }
        return std::pair(session.status().state, session.status().advice);
    };
    const std::string text = "$HEHDT,123.4,T*2A\r\n";
    const auto nmea = adviceAfter({text.begin(), text.end()});
    EXPECT_EQ(nmea.first, HeadState::WrongDevice);
    EXPECT_NE(nmea.second.find("compass"), std::string::npos);
    const auto noise = adviceAfter({0x00, 0xFE, 0x80, 0x40, 0x98, 0xE6});
    EXPECT_EQ(noise.first, HeadState::WrongDevice);
    EXPECT_NE(noise.second.find("baud"), std::string::npos);
    const auto profiler = adviceAfter(makeFrame(20, 255, 4, 0x80, 20, std::vector<std::uint8_t>(8, 0)));
    EXPECT_EQ(profiler.first, HeadState::WrongDevice);
    EXPECT_NE(profiler.second.find("node 20"), std::string::npos);
    const auto echo = adviceAfter(encodeSendVersion());
    EXPECT_EQ(echo.first, HeadState::Silent);
    EXPECT_NE(echo.second.find("our own"), std::string::npos);
}

TEST(HeadSession, ItsOwnCommandsComingBackDisturbNothing) {
    Conversation talk({.half_duplex = true});
    for (int i = 0; i < 400; ++i) {
        talk.run(0.02);
        talk.session.received(talk.now, encodeSendData(0));
    }
    expectPolling(talk);
    EXPECT_GT(talk.status().foreign, 300u);
}

}  // namespace
}  // namespace echotrail::seanet
