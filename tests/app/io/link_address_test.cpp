#include "app/io/link_address.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

TEST(LinkAddress, ReadsTheFormsThatAreDocumented) {
    const auto serial = parseLinkAddress("serial:///dev/ttyUSB0?baud=57600").value();
    EXPECT_EQ(serial.kind, LinkAddress::Kind::Serial);
    EXPECT_EQ(serial.device, "/dev/ttyUSB0");
    EXPECT_EQ(serial.baud, 57'600);
    const auto udp = parseLinkAddress("udp://192.168.0.7:4001?listen=4002").value();
    EXPECT_EQ(udp.kind, LinkAddress::Kind::Udp);
    EXPECT_EQ(udp.host, "192.168.0.7");
    EXPECT_EQ(udp.port, 4001);
    EXPECT_EQ(udp.listen, 4002);
    const auto tcp = parseLinkAddress("tcp://[::1]:4001").value();
    EXPECT_EQ(tcp.host, "::1");
    EXPECT_EQ(parseLinkAddress("pty").value().kind, LinkAddress::Kind::PseudoTerminal);
    EXPECT_EQ(parseLinkAddress("udp://localhost:1?format=nmea").value().format, "nmea");
}

TEST(LinkAddress, ASerialPortRunsAtTheHeadsOwnRateUnlessToldOtherwise) {
    EXPECT_EQ(parseLinkAddress("serial:///dev/ttyS0").value().baud, 115'200);
}

TEST(LinkAddress, WrittenTextReadsBackToTheSame) {
    for (const char* text :
         {"serial:///dev/ttyUSB0?baud=9600", "tcp://head.local:4001", "tcp://[fe80::1]:0",
          "udp://10.0.0.1:65535?listen=1", "udp://10.0.0.1:5?format=nmea", "udp://10.0.0.1:5?listen=6&format=json",
          "tcp://h:1?format=nmea", "udp://h:1?format=nmea&rate=0.3", "tcp://h:1?rate=5", "tls://[::1]:7000", "pty"}) {
        const auto address = parseLinkAddress(text);
        ASSERT_TRUE(address) << text;
        const auto again = parseLinkAddress(toText(*address));
        ASSERT_TRUE(again) << toText(*address);
        EXPECT_EQ(*again, *address) << text;
    }
}

TEST(LinkAddress, RefusesWhatItDoesNotUnderstandAndNamesIt) {
    for (const std::string text : {"",
                                   "ptyx",
                                   "tcp://",
                                   "tcp://host",
                                   "tcp://:4001",
                                   "tcp://host:",
                                   "tcp://host:65536",
                                   "tcp://host:-1",
                                   "tcp://host:40x1",
                                   "tcp://host:4001/",
                                   "tcp://[]:1",
                                   "tcp://ho st:1",
                                   "tcp://a:b:1",
                                   "udp://h:1?listen=70000",
                                   "udp://h:1?listen",
                                   "tcp://h:1?listen=5",
                                   "tcp://h:1?baud=9600",
                                   "tls://h:1?format=nmea",
                                   "udp://h:1?rate=0",
                                   "udp://h:1?rate=51",
                                   "udp://h:1?rate=fast",
                                   "udp://h:1?rate=nan",
                                   "tls://h:1?rate=5",
                                   "tcp://h:1?format=xml",
                                   "serial://",
                                   "serial:///",
                                   "serial://ttyUSB0",
                                   "serial:///dev/ttyS0?baud=0",
                                   "serial:///dev/ttyS0?baud=fast",
                                   "serial:///dev/ttyS0?parity=even",
                                   "http://host:80",
                                   "/tmp/a.bin"}) {
        const auto address = parseLinkAddress(text);
        ASSERT_FALSE(address) << text;
        EXPECT_NE(address.error().find(text.substr(text.find('?') + 1)), std::string::npos) << address.error();
        EXPECT_EQ(address.error().find('\n'), std::string::npos);
    }
}

TEST(LinkAddress, FilesAndScenariosAreNoLinks) {
    EXPECT_TRUE(isLinkAddress("pty"));
    EXPECT_TRUE(isLinkAddress("udp://h:1"));
    EXPECT_FALSE(isLinkAddress("recording.echotrail"));
    EXPECT_FALSE(isLinkAddress("simulation://demo"));
}

}  // namespace
}  // namespace echotrail
