#include "core/base/random.hpp"
#include "core/seanet/head_session.hpp"
#include "tests/core/seanet/fake_head.hpp"
#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>

namespace echotrail::seanet {
namespace {

using namespace std::chrono_literals;

TEST(HeadSession, AChangeWhileScanningIsConfirmedByTheHeadsOwnReply) {
    for (const bool half_duplex : {false, true}) {
        Conversation talk({.half_duplex = half_duplex});
        talk.run(8);
        talk.session.setSettings(talk.now, {.range_m = 20, .sector_width_deg = 60});
        EXPECT_EQ(talk.status().confirmed->range_m, 50);  // not before the head says so
        talk.run(1);
        EXPECT_EQ(talk.status().confirmed->range_m, 20);
        EXPECT_EQ(talk.status().difference, "");
        EXPECT_EQ(talk.heard(MessageId::HeadCommand), 2);
        EXPECT_EQ(talk.head.offences, std::vector<std::string>());
    }
}

TEST(HeadSession, AGainSliderSendsTheShortFormNoFasterThanLinesCome) {
    for (const bool half_duplex : {false, true}) {
        Conversation talk({.half_duplex = half_duplex});
        talk.run(8);
        const auto before = talk.status().pings;
        for (int i = 0; i <= 50; ++i) {
            talk.session.setSettings(talk.now, {.gain_percent = 20.0 + i});
            talk.run(0.004);
        }
        const auto lines = static_cast<int>(talk.status().pings - before);
        EXPECT_LE(talk.head.gains_heard, lines + 1);
        talk.run(1);
        EXPECT_NEAR(talk.status().confirmed->gain_percent, 70, 0.25);
        EXPECT_EQ(talk.heard(MessageId::HeadCommand), 1 + talk.head.gains_heard);  // one full command, at first
        EXPECT_EQ(talk.head.offences, std::vector<std::string>());
    }
}

TEST(HeadSession, TheSameSettingsAgainSendNothing) {
    Conversation talk;
    talk.run(8);
    talk.session.setSettings(talk.now, HeadSettings{});
    talk.run(1);
    EXPECT_EQ(talk.heard(MessageId::HeadCommand), 1);
}

TEST(HeadSession, AHeadThatDoesNotObeyIsToldAgainAFewTimesAndThenToldOf) {
    Conversation talk;
    talk.run(8);
    talk.head.obeys = false;
    talk.session.setSettings(talk.now, {.range_m = 20});
    talk.run(10);
    EXPECT_EQ(talk.status().state, HeadState::Polling);
    EXPECT_EQ(talk.status().difference, "range is 50 m, not 20 m");
    EXPECT_NE(talk.status().advice.find("range is 50 m"), std::string::npos);
    EXPECT_EQ(talk.heard(MessageId::HeadCommand), 5);
}

TEST(HeadSession, AHeadThatSaysItWasResetIsToldItsParametersAgain) {
    Conversation talk;
    talk.run(8);
    talk.head.line_status = 0x11;
    talk.run(0.1);
    talk.head.line_status = 0x10;
    talk.run(1);
    EXPECT_EQ(talk.heard(MessageId::HeadCommand), 2);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 0);
}

TEST(HeadSession, AMotorThatStaysOutOfStepIsRebootedOnceAMinute) {
    Conversation talk;
    talk.run(8);
    talk.head.line_status = 0x12;
    talk.run(30);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
    EXPECT_EQ(talk.status().state, HeadState::Polling);
    EXPECT_NE(talk.status().advice.find("motor"), std::string::npos);
    talk.head.line_status = 0x10;
    talk.run(1);
    EXPECT_EQ(talk.status().advice, "");
}

TEST(HeadSession, AfterABreakAHeadThatStillHasOurParametersGoesOnWithoutAReboot) {
    for (const bool half_duplex : {false, true}) {
        Conversation talk({.half_duplex = half_duplex});
        talk.run(8);
        talk.session.linkDown(talk.now);
        EXPECT_EQ(talk.status().state, HeadState::NoLink);
        EXPECT_FALSE(talk.session.deadline());
        talk.run(3);
        const auto before = talk.status().pings;
        talk.session.linkUp(talk.now);
        talk.run(4);
        EXPECT_GT(talk.status().pings, before + 20);
        EXPECT_EQ(talk.heard(MessageId::ReBoot), 0);
        EXPECT_EQ(talk.heard(MessageId::HeadCommand), 1);
        EXPECT_EQ(talk.head.offences, std::vector<std::string>());
    }
}

TEST(HeadSession, WhatWasSetDuringABreakIsToldAfterIt) {
    Conversation talk;
    talk.run(8);
    talk.session.linkDown(talk.now);
    talk.session.setSettings(talk.now, {.range_m = 30});
    talk.run(1);
    talk.session.linkUp(talk.now);
    talk.run(4);
    EXPECT_EQ(talk.status().confirmed->range_m, 30);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 0);
}

TEST(HeadSession, AfterABreakOtherParametersMeanAFreshStart) {
    Conversation talk;
    talk.run(8);
    talk.session.linkDown(talk.now);
    talk.run(1);
    talk.head.command.range_scale = 100;  // somebody else was there
    talk.session.linkUp(talk.now);
    talk.run(15);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
    EXPECT_EQ(talk.status().state, HeadState::Polling);
    EXPECT_EQ(talk.status().difference, "");
}

TEST(HeadSession, NothingIsSentWithoutALink) {
    HeadSession session{HeadSettings{}};
    session.received(0s, encodeHeadData(HeadData{}));
    session.setSettings(1s, {.range_m = 30});
    session.tick(2s);
    EXPECT_FALSE(session.takeOutput());
    session.linkUp(3s);
    session.tick(4s);
    session.linkDown(4s);
    EXPECT_FALSE(session.takeOutput());
}

TEST(HeadSession, ALineThatComesSlowlyIsWaitedFor) {
    Conversation talk({.half_duplex = true});
    talk.run(8);
    talk.wire_in = false;
    talk.head.line_time = 10s;  // the head itself is busy; the bytes below are its line over a slow link
    const auto timeouts = talk.status().timeouts;
    talk.run(0.2);
    const auto bytes = encodeHeadData(talk.head.line());
    for (std::size_t at = 0; at < bytes.size(); at += 10) {
        talk.session.received(talk.now, Bytes(bytes).subspan(at, std::min<std::size_t>(10, bytes.size() - at)));
        talk.run(0.03);
    }
    EXPECT_EQ(talk.status().timeouts, timeouts);
}

TEST(HeadSession, ALineInSeveralPacketsIsALine) {
    Conversation talk;
    talk.run(8);
    const auto before = talk.status().pings;
    talk.wire_in = false;
    const auto payload = encodeHeadPayload(talk.head.line());
    const Bytes bytes(payload);
    for (std::size_t at = 0, packet = 0; at < bytes.size(); at += 110, ++packet) {
        const std::size_t length = std::min<std::size_t>(110, bytes.size() - at);
        const bool last = at + length == bytes.size();
        const auto sequence = static_cast<std::uint8_t>(packet | (last ? 0x80 : 0));
        talk.session.received(talk.now, makeFrame(2, 255, 2, sequence, 2, bytes.subspan(at, length)));
    }
    EXPECT_EQ(talk.status().pings, before + 1);
    EXPECT_EQ(talk.status().difference, "");
}

TEST(HeadSession, TheSentencesOfARealHeadLeadThroughTheHandshake) {
    if (sharedCapture("vectors/rep_mtAlive_5D.hex").empty()) GTEST_SKIP() << "needs the shared recordings";
    HeadSession session{HeadSettings{}};
    session.linkUp(0s);
    const auto hear = [&](Microseconds now, const std::string& name) {
        session.received(now, readHex(sharedCapture(name)));
        session.tick(now);
        return session.status().state;
    };
    const FrameBytes alive_5d = readHex(sharedCapture("vectors/rep_mtAlive_5D.hex"));
    FrameBytes alive_4a = alive_5d;
    alive_4a[20] = 0x4A;
    EXPECT_EQ(hear(100ms, "vectors/rep_mtAlive_5D.hex"), HeadState::Identifying);
    EXPECT_EQ(session.takeOutput(), encodeSendVersion());
    hear(150ms, "seaking_dfs_v4log/rep_mtVersionData_seaking_dfs.hex");
    EXPECT_EQ(session.takeOutput(), encodeSendBBUser());
    EXPECT_EQ(hear(200ms, "seaking_dfs_v4log/rep_mtBBUserData_seaking_dfs.hex"), HeadState::Centring);
    EXPECT_FALSE(session.takeOutput());
    session.received(1s, alive_4a);
    EXPECT_EQ(session.status().state, HeadState::Configuring);
    EXPECT_EQ(session.takeOutput()->size(), 82u);
    EXPECT_EQ(hear(2s, "vectors/rep_mtAlive_8A.hex"), HeadState::Polling);
    EXPECT_EQ(session.takeOutput(), encodeSendData(2000));
    EXPECT_FALSE(session.takeOutput());
    EXPECT_TRUE(session.status().head.starts_with("SeaKing DFS"));
}

TEST(HeadSession, AnAliveDamagedToAResetCostsNoReboot) {
    Conversation talk;
    talk.run(8);
    talk.session.received(talk.now,
                          makeFrame(2, 255, 4, 0x80, 2, ByteWriter().u8(0).u32(0).u16(3200).u8(0x58).bytes()));
    EXPECT_EQ(talk.status().head_resets, 1u);
    talk.run(6);
    EXPECT_EQ(talk.status().state, HeadState::Polling);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 0);
}

TEST(HeadSession, ALateSecondNameDoesNotChangeHowTheHeadIsSpokenTo) {
    Conversation talk({.digital = true});
    talk.run(8);
    talk.session.received(talk.now, makeFrame(2, 255, 1, 0x80, 2, std::vector<std::uint8_t>(11, 0xEE)));
    talk.session.received(talk.now, makeFrame(2, 255, 6, 0x80, 2, std::vector<std::uint8_t>(250, 0xEE)));
    talk.run(1);
    EXPECT_TRUE(talk.status().digital);
    EXPECT_FALSE(talk.status().half_duplex);
    EXPECT_EQ(talk.heard(MessageId::HeadCommand), 1);
    EXPECT_GE(talk.status().rejected, 1u);
}

TEST(HeadSession, ALineDoubledOnTheWayIsNoReasonToSpeakOutOfTurn) {
    Conversation talk({.half_duplex = true, .line_repeats = 2});
    talk.run(10);
    EXPECT_GT(talk.status().pings, 20u);
    EXPECT_EQ(talk.head.offences, std::vector<std::string>());
}

TEST(HeadSession, ALostLineIsAskedForAgainAfterASecond) {
    Conversation talk({.half_duplex = true});
    talk.run(8);
    talk.head.lose_lines = 1;
    const auto before = talk.status().pings;
    talk.run(2.2);
    EXPECT_EQ(talk.status().timeouts, 1u);
    EXPECT_GT(talk.status().pings, before + 10);
}

TEST(HeadSession, WhatWasSaidBeforeARebootIsNotItsAnswer) {
    Conversation talk;
    talk.head.has_parameters = true;
    while (talk.heard(MessageId::ReBoot) == 0) talk.run(0.1);
    talk.session.received(talk.now, makeFrame(2, 255, 4, 0x80, 2, std::vector<std::uint8_t>(8, 0)));
    talk.run(12);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
}

TEST(HeadSession, AnotherHeadAfterABreakIsAskedWhatItIs) {
    Conversation talk;
    talk.run(8);
    talk.session.linkDown(talk.now);
    talk.session.linkUp(talk.now);
    talk.session.received(talk.now, makeFrame(2, 255, 1, 0x80, 2, std::vector<std::uint8_t>(11, 0x13)));
    EXPECT_EQ(talk.status().head.find("serial 77"), std::string::npos);
    talk.run(15);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
    EXPECT_EQ(talk.heard(MessageId::SendBBUser), 2);
}

TEST(HeadSession, ParametersThatAreNeverTakenEndInAReboot) {
    Conversation talk({.deaf_to = {19}});
    talk.run(45);
    EXPECT_EQ(talk.heard(MessageId::ReBoot), 1);
    EXPECT_GE(talk.heard(MessageId::HeadCommand), 3);
}

TEST(HeadSession, AfterABreakAHeadThatGivesNoLineIsRebooted) {
    Conversation talk;
    talk.run(8);
    talk.session.linkDown(talk.now);
    talk.run(1);
    talk.head.deaf_to = {25};
    talk.session.linkUp(talk.now);
    talk.run(15);
    EXPECT_GE(talk.heard(MessageId::ReBoot), 1);
}

TEST(HeadSession, SurvivesDamagedBytesOfAllKindsAndGoesOnWhenTheyEnd) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        Conversation talk({.digital = seed % 2 == 1, .half_duplex = seed % 4 > 1});
        RandomStream random(seed, 0, 0);
        const Microseconds end = 60s;
        for (; talk.now < end; talk.now += 2ms) {
            for (FrameBytes frame : talk.head.speak(talk.now)) {
                if (random.uniform() < 0.3)
                    frame.resize(static_cast<std::size_t>(random.uniform() * static_cast<double>(frame.size())));
                if (!frame.empty() && random.uniform() < 0.3)
                    frame[static_cast<std::size_t>(random.uniform() * static_cast<double>(frame.size()))] ^= 0x55;
                for (int times = random.uniform() < 0.1 ? 2 : 1; times > 0; --times)
                    talk.session.received(talk.now, frame);
            }
            talk.session.tick(talk.now);
            ASSERT_TRUE(talk.session.deadline());
            ASSERT_GT(*talk.session.deadline(), talk.now);
            while (const auto frame = talk.session.takeOutput())
                if (random.uniform() < 0.8) talk.head.take(talk.now, *frame);
        }
        talk.run(60);
        EXPECT_EQ(talk.status().state, HeadState::Polling) << seed;
        EXPECT_EQ(talk.status().difference, "") << seed;
        EXPECT_GT(talk.status().rejected, 0u);
        for (const std::string& offence : talk.head.offences)
            EXPECT_FALSE(offence.starts_with("must not") || offence.starts_with("not one")) << offence;
    }
}

}  // namespace
}  // namespace echotrail::seanet
