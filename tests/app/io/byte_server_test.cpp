#include "app/io/byte_server.hpp"

#include "tests/app/io/event_loop.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

Result<std::unique_ptr<ByteServer>> listenOn(const std::string& text) {
    return ByteServer::listen(parseLinkAddress(text).value());
}

TEST(ByteServer, AnyFreePortIsNamedInTheAddress) {
    for (const std::string form : {"tcp://127.0.0.1:", "udp://127.0.0.1:"}) {
        const auto server = listenOn(form + "0");
        ASSERT_TRUE(server) << server.error();
        EXPECT_TRUE((*server)->address().starts_with(form));
        EXPECT_NE((*server)->address(), form + "0");
    }
}

TEST(ByteServer, APortThatIsTakenIsRefusedInOneLine) {
    for (const std::string form : {"tcp://127.0.0.1:0", "udp://127.0.0.1:0"}) {
        const Listener first(form);
        const auto second = listenOn(first.address());
        ASSERT_FALSE(second);
        EXPECT_TRUE(second.error().starts_with("cannot listen on " + first.address() + ": ")) << second.error();
    }
}

TEST(ByteServer, WhereNobodyCanListenIsRefused) {
    EXPECT_FALSE(listenOn("serial:///dev/ttyS0"));
    EXPECT_FALSE(listenOn("tcp://no-such-host.invalid:0"));
    EXPECT_FALSE(listenOn("udp://no-such-host.invalid:0"));
    EXPECT_FALSE(listenOn("tcp://192.0.2.1:0"));
}

TEST(ByteServer, BytesWithoutAPeerAreDroppedAndCounted) {
    for (const char* form : {"tcp://127.0.0.1:0", "udp://127.0.0.1:0"}) {
        Listener head(form);
        head.server->send("alone");
        EXPECT_EQ(head.server->droppedBytes(), 5U) << form;
    }
}

TEST(ByteServer, APseudoTerminalThatNobodyReadsTakesSoMuchAndCountsTheRest) {
    Listener head("pty");
    for (int i = 0; i < 1000; ++i) head.server->send(everyByte());
    EXPECT_GT(head.server->droppedBytes(), 0U);
    Caller host(head.address());
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    host.channel->send("?");
    ASSERT_TRUE(becomes([&] { return head.heard == "?"; }));
    host.heard.clear();
    head.server->send("fresh");
    EXPECT_TRUE(becomes([&] { return host.heard.endsWith("fresh"); }));
}

TEST(ByteServer, ADroppedUdpPeerComesBackWithItsNextDatagram) {
    Listener head("udp://127.0.0.1:0");
    Caller host(head.address());
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    host.channel->send("a");
    ASSERT_TRUE(becomes([&] { return head.ups == 1; }));
    head.server->drop();
    EXPECT_EQ(head.downs, 1);
    host.channel->send("b");
    ASSERT_TRUE(becomes([&] { return head.ups == 2; }));
    EXPECT_EQ(head.heard, "ab");
}

}  // namespace
}  // namespace echotrail
