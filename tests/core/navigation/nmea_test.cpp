#include "core/navigation/nmea.hpp"

#include "core/base/random.hpp"
#include "tests/core/navigation/nmea_lines.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

constexpr std::string_view documented = R"(\c:1274601600079*66\$HEHDT,0.2,T*2D)";

std::string causeOf(std::string_view line) {
    const auto sentence = parseNmeaLine(line);
    return sentence ? "none" : sentence.error();
}

TEST(NmeaLine, DocumentedExampleIsRead) {
    const auto sentence = parseNmeaLine(documented);
    ASSERT_TRUE(sentence) << sentence.error();
    EXPECT_EQ(sentence->id, "HDT");
    EXPECT_EQ(sentence->fields, (std::vector<std::string>{"0.2", "T"}));
    EXPECT_EQ(sentence->time, Timestamp(std::chrono::milliseconds(1274601600079)));
    EXPECT_EQ(sentence->field(2), "");
}

TEST(NmeaLine, TenDigitsOfTimeAreSeconds) {
    const auto sentence = parseNmeaLine("\\" + withChecksum("s:gps1,c:1274601600") + "\\$HEHDT,0.2,T*2D\r\n");
    ASSERT_TRUE(sentence) << sentence.error();
    EXPECT_EQ(sentence->time, Timestamp(std::chrono::seconds(1274601600)));
}

TEST(NmeaLine, SentenceWithoutTagBlockHasNoTime) {
    const auto sentence = parseNmeaLine("$GPHDT,274.07,T*03");
    ASSERT_TRUE(sentence) << sentence.error();
    EXPECT_FALSE(sentence->time);
}

TEST(NmeaLine, ChecksumDigitsMayBeSmallLetters) { EXPECT_EQ(causeOf("$HEHDT,0.2,T*2d"), "none"); }

TEST(NmeaLine, ProprietarySentenceIsNotTakenForAStandardOne) {
    const auto sentence = parseNmeaLine("$" + withChecksum("PAHDT,0.2,T"));
    ASSERT_TRUE(sentence);
    EXPECT_EQ(sentence->id, "PAHDT");
}

TEST(NmeaLine, EachFaultHasItsCause) {
    EXPECT_EQ(causeOf(R"(\c:1274601600079*66\$HEHDT,0.3,T*2D)"), "bad_checksum");
    EXPECT_EQ(causeOf(R"(\c:1274601600078*66\$HEHDT,0.2,T*2D)"), "bad_checksum");
    EXPECT_EQ(causeOf("$HEHDT,0.2,T"), "no_checksum");
    EXPECT_EQ(causeOf(R"(\c:1274601600079\$HEHDT,0.2,T*2D)"), "no_checksum");
    EXPECT_EQ(causeOf("$HEHDT,0.2,T*2"), "malformed");
    EXPECT_EQ(causeOf("$HEHDT,0.2,T*2D0"), "malformed");
    EXPECT_EQ(causeOf("$HEHDT,0.2,T*-D"), "malformed");
    EXPECT_EQ(causeOf(R"(\c:1274601600079*66)"), "malformed");
    EXPECT_EQ(causeOf("time,heading"), "malformed");
    EXPECT_EQ(causeOf(""), "malformed");
    EXPECT_EQ(causeOf("$" + withChecksum("HDT,0.2,T")), "malformed");
    EXPECT_EQ(causeOf("$" + withChecksum("HEHDT,\x01,T")), "malformed");
    for (const char* time : {"c:", "c:-127460160007", "c:127460160007", "c:12746016000x9", "c:99999999999999999999"})
        EXPECT_EQ(causeOf("\\" + withChecksum(time) + "\\$HEHDT,0.2,T*2D"), "bad_field") << time;
}

TEST(NmeaLine, EveryTruncationOfALineIsRejected) {
    for (std::size_t length = 0; length < documented.size(); ++length)
        EXPECT_NE(causeOf(documented.substr(0, length)), "none") << length;
}

TEST(NmeaLine, EverySingleDamagedCharacterIsNoticed) {
    for (std::size_t at = 0; at < documented.size(); ++at) {
        std::string line(documented);
        line[at] = static_cast<char>(line[at] ^ 0x04);
        EXPECT_NE(causeOf(line), "none") << line;
    }
}

TEST(NmeaLine, AnyBytesGiveASentenceOrANamedCause) {
    RandomStream random(1, 0, 0);
    constexpr std::string_view alphabet = "\\$*!,c:0129AFHDTP\x00\xff\r\n";
    for (int trial = 0; trial < 20000; ++trial) {
        std::string line;
        for (std::uint32_t length = random.bits() % 24U; length > 0; --length)
            line +=
                random.bits() % 8U == 0U ? static_cast<char>(random.bits()) : alphabet[random.bits() % alphabet.size()];
        const auto sentence = parseNmeaLine(line);
        if (sentence)
            EXPECT_FALSE(sentence->id.empty());
        else
            EXPECT_TRUE(sentence.error() == nmea_cause::malformed || sentence.error() == nmea_cause::bad_checksum ||
                        sentence.error() == nmea_cause::no_checksum || sentence.error() == nmea_cause::bad_field);
    }
}

TEST(NmeaSentenceText, IsReadBack) {
    EXPECT_EQ(nmeaSentence("HEHDT,0.2,T"), "$HEHDT,0.2,T*2D\r\n");
    EXPECT_TRUE(parseNmeaLine(nmeaSentence("GPXYZ,1,,3")));
}

}  // namespace
}  // namespace echotrail
