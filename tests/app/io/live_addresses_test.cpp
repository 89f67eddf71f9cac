#include "app/io/live_addresses.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

TEST(LiveAddresses, ARealHeadHasTheNavigationItIsGiven) {
    const auto alone = parseLiveAddresses("tcp://head:4001", "").value();
    EXPECT_EQ(alone.sonarText(), "tcp://head:4001");
    EXPECT_FALSE(alone.isSimulated());
    EXPECT_FALSE(alone.hasNavigation());
    const auto both = parseLiveAddresses("serial:///dev/ttyUSB0?baud=9600", "udp://gyro:5000?listen=5001").value();
    EXPECT_EQ(both.sonarText(), "serial:///dev/ttyUSB0?baud=9600");
    EXPECT_TRUE(both.hasNavigation());
    EXPECT_EQ(both.navigationText(), "udp://gyro:5000?listen=5001");
}

TEST(LiveAddresses, ASimulatedHeadBringsItsOwnNavigation) {
    const auto demo = parseLiveAddresses("simulation://demo", "").value();
    EXPECT_TRUE(demo.isSimulated());
    EXPECT_TRUE(demo.hasNavigation());
    EXPECT_EQ(demo.sonarText(), "simulation://demo?seed=1");
    EXPECT_EQ(parseLiveAddresses("simulation://S1?seed=12", "").value().sonarText(), "simulation://S1?seed=12");
    EXPECT_TRUE(parseLiveAddresses("simulation://S1?seed=12", "simulation://S1?seed=12")) << "says the same twice";
}

TEST(LiveAddresses, WhatCannotBeIsRefusedInOneLineThatNamesTheOption) {
    const auto refusal = [](const std::string& sonar, const std::string& navigation) {
        const auto parsed = parseLiveAddresses(sonar, navigation);
        return parsed ? std::string() : parsed.error();
    };
    EXPECT_TRUE(refusal("simulation://atlantis", "").starts_with("sonar: "));
    EXPECT_NE(refusal("simulation://atlantis", "").find("demonstration"), std::string::npos) << "names what there is";
    EXPECT_TRUE(refusal("simulation://demo?sead=1", "").starts_with("sonar: "));
    EXPECT_TRUE(refusal("simulation://demo?seed=-1", "").starts_with("sonar: "));
    EXPECT_TRUE(refusal("simulation://demo", "tcp://gyro:1").starts_with("navigation: "));
    EXPECT_TRUE(refusal("tcp://head:1", "simulation://demo").starts_with("navigation: "));
    EXPECT_TRUE(refusal("tcp://head:1", "gyro").starts_with("navigation: "));
    EXPECT_TRUE(refusal("pty", "").starts_with("sonar: "));
    EXPECT_TRUE(refusal("", "").starts_with("sonar: "));
}

}  // namespace
}  // namespace echotrail
