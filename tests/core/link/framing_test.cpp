#include "core/link/framing.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace echotrail {
namespace {

std::vector<std::uint8_t> bytes(const std::string& text) { return {text.begin(), text.end()}; }

std::vector<std::string> messagesOf(const std::string& stream, std::size_t chunk, std::size_t longest = 1000) {
    FrameReader reader(longest);
    std::vector<std::string> found;
    const auto all = bytes(stream);
    for (std::size_t from = 0; from < all.size(); from += chunk) {
        reader.take(std::span(all).subspan(from, std::min(chunk, all.size() - from)));
        while (const auto message = reader.next()) found.emplace_back(*message);
    }
    return found;
}

TEST(Framing, TheLengthStandsBeforeTheMessageTheHighestByteFirst) {
    EXPECT_EQ(linkFrame("ab"), std::string("\0\0\0\2ab", 6));
    EXPECT_EQ(linkFrame(std::string(258, 'x')).substr(0, 4), std::string("\0\0\1\2", 4));
}

TEST(Framing, HoweverAStreamIsCutTheSameMessagesComeOut) {
    const std::string stream =
        linkFrame("one") + linkFrame(std::string(300, '2')) + linkFrame(std::string("\0three", 6));
    const auto whole = messagesOf(stream, stream.size());
    ASSERT_EQ(whole.size(), 3U);
    for (std::size_t chunk = 1; chunk < stream.size(); ++chunk) EXPECT_EQ(messagesOf(stream, chunk), whole) << chunk;
}

TEST(Framing, AnImpossibleLengthBreaksTheStreamForGood) {
    for (const std::string& head : {std::string("\0\0\0\0", 4), std::string("\0\0\3\xE9", 4), std::string("GET ")}) {
        FrameReader reader(1000);
        reader.take(bytes(linkFrame("good") + head + "abc"));
        EXPECT_EQ(reader.next().value_or(""), "good");
        EXPECT_FALSE(reader.next());
        EXPECT_TRUE(reader.broken());
        reader.take(bytes(linkFrame("after")));
        EXPECT_FALSE(reader.next());
        EXPECT_EQ(reader.held(), 0U) << "nothing is kept of a broken stream";
    }
}

TEST(Framing, NoMoreIsHeldThanAMessage) {
    FrameReader reader(1000);
    const auto begun = bytes(linkFrame(std::string(1000, 'x')).substr(0, 900));
    reader.take(begun);
    EXPECT_FALSE(reader.next());
    EXPECT_LE(reader.held(), 1004U);
}

}  // namespace
}  // namespace echotrail
