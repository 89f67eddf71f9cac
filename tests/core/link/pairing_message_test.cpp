#include "core/link/pairing_message.hpp"

#include "core/link/framing.hpp"
#include "core/link/link_client.hpp"
#include "tests/core/link/link_pair.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

std::string withoutFrame(const std::string& frame) { return frame.substr(link_frame_head); }

TEST(PairingMessage, ComesThrough) {
    const std::string proof(pairing_proof_bytes, '\x80');
    const auto request = readPairRequest(withoutFrame(pairFrame(PairRequest{proof, "shore"})));
    ASSERT_TRUE(request);
    EXPECT_EQ(request->proof, proof);
    EXPECT_EQ(request->name, "shore");
    const auto reply = readPairReply(withoutFrame(pairFrame(PairReply{true, "", proof, "vehicle"})));
    ASSERT_TRUE(reply);
    EXPECT_TRUE(reply->done);
    EXPECT_EQ(reply->proof, proof);
    EXPECT_EQ(reply->name, "vehicle");
    const auto no = readPairReply(withoutFrame(pairFrame(PairReply{false, "wrong\ncode", "", "vehicle"})));
    ASSERT_TRUE(no);
    EXPECT_EQ(no->reason, "wrong code") << "on one line";
}

TEST(PairingMessage, WhatCannotBeIsRefused) {
    const std::string proof(pairing_proof_bytes, 'p');
    EXPECT_FALSE(readPairRequest(""));
    EXPECT_FALSE(readPairRequest(withoutFrame(pairFrame(PairRequest{proof.substr(1), "shore"}))));
    EXPECT_FALSE(readPairReply(withoutFrame(pairFrame(PairReply{true, "", "", "vehicle"}))));
    const std::string request = withoutFrame(pairFrame(PairRequest{proof, "shore"}));
    for (std::size_t length = 0; length < request.size(); ++length) {
        const auto read = readPairRequest(request.substr(0, length));
        EXPECT_TRUE(!read || read->proof == proof) << length;
    }
    const auto named = readPairRequest(withoutFrame(pairFrame(PairRequest{proof, std::string(1000, 'n')})));
    ASSERT_TRUE(named);
    EXPECT_EQ(named->name.size(), link_limits::longest_name);
}

TEST(PairingMessage, ARefusalIsUnderstoodByEveryConsole) {
    LinkClient client(LinkClient::Options{.identity = {"shore", "test"}});
    client.linkUp(Microseconds{0});
    client.received(Microseconds{1}, test::bytesOf(refusalFrame("not paired here")));
    EXPECT_EQ(client.status().refusal, "not paired here");
    EXPECT_TRUE(client.wantsToClose());
}

}  // namespace
}  // namespace echotrail
