#include "core/seanet/messages.hpp"

#include "core/base/random.hpp"
#include "core/seanet/commands.hpp"
#include "core/seanet/head_data.hpp"
#include "core/seanet/ping_decoder.hpp"
#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace echotrail::seanet {
namespace {

using nlohmann::json;

/// The printed messages and what they mean, by others' reading of the protocol.
class MessageVectors : public testing::Test {
protected:
    void SetUp() override {
        const std::string path = sharedCapture("vectors/expected.json");
        if (path.empty()) GTEST_SKIP() << "needs the shared recordings";
        std::ifstream(path) >> expected_;
    }
    static ByteVector bytesOf(const std::string& name) {
        const std::string path = sharedCapture("vectors/" + name + ".hex");
        return readHex(path.empty() ? sharedCapture("seaking_dfs_v4log/" + name + ".hex") : path);
    }
    std::vector<std::string> namesStartingWith(const std::string& start) const {
        std::vector<std::string> names;
        for (const auto& [name, meaning] : expected_.items())
            if (name.starts_with(start)) names.push_back(name);
        return names;
    }
    json expected_;
};

/// Where `object` has the member it must be `value`; wasComplete() checks that none was left out.
class Comparison {
public:
    explicit Comparison(const json& object) : object_(object) {}
    template <class T>
    Comparison& operator()(const char* member, T value) {
        if (!object_.contains(member)) return *this;
        ++compared_;
        EXPECT_EQ(object_.at(member), json(value)) << member;
        return *this;
    }
    /// Every member but the named ones was compared.
    void wasComplete(std::size_t others = 0) const { EXPECT_EQ(compared_ + others, object_.size()) << object_; }

private:
    const json& object_;
    std::size_t compared_ = 0;
};

Comparison compare(const json& object) { return Comparison(object); }

TEST_F(MessageVectors, EveryOneIsOneWholeFrameWithTheHeaderItShouldHave) {
    std::size_t messages = 0;
    for (const auto& [name, meaning] : expected_.items()) {
        if (!meaning.contains("length")) continue;
        SCOPED_TRACE(name);
        const ByteVector bytes = bytesOf(name);
        FrameParser parser;
        parser.take(bytes, [&, &meaning = meaning](const Frame& frame) {
            compare(meaning)("length", frame.bytes.size())("bin_len", u16(frame.bytes, 5))("tx", frame.source())(
                "rx", frame.destination())("count", frame.count())("id", frame.id())("seq", frame.sequence())(
                "node", frame.node())("hex_len_field", std::string(bytes.begin() + 1, bytes.begin() + 5));
        });
        EXPECT_EQ(parser.frames(), 1u);
        EXPECT_EQ(parser.skippedBytes() + parser.unfinishedBytes(), 0u);
        ++messages;
    }
    EXPECT_EQ(messages, 23u);
}

TEST_F(MessageVectors, VersionDataMatches) {
    for (const auto& name : namesStartingWith("rep_mtVersionData")) {
        SCOPED_TRACE(name);
        const ByteVector bytes = bytesOf(name);
        const auto message = decodeMessage(Frame{bytes});
        const auto& data = std::get<VersionData>(message);
        const json& meaning = expected_[name];
        compare(meaning.contains("version") ? meaning["version"] : meaning)("byte13", data.byte13)(
            "infobits", data.infobits)("serial", data.serial)("program_length", data.program_length)(
            "checksum", data.checksum)("node", data.node)
            .wasComplete(meaning.contains("version") ? 0 : 2);  // there id and length of the frame stand beside them
    }
}

TEST_F(MessageVectors, AliveMatchesBitByBit) {
    for (const auto& name : namesStartingWith("rep_mtAlive")) {
        SCOPED_TRACE(name);
        const ByteVector bytes = bytesOf(name);
        const auto message = decodeMessage(Frame{bytes});
        const auto& data = std::get<Alive>(message);
        const auto bit = [](bool value) { return value ? 1 : 0; };
        compare(expected_[name]["alive"])("willsend", data.will_send)("head_time_ms", data.head_time_ms)(
            "motor_pos", data.transducer)("headinf", data.head_info)("in_centre", bit(data.inCentre()))(
            "centred", bit(data.centred()))("motoring", bit(data.motoring()))("motor_on", bit(data.motorOn()))(
            "dir", bit(data.offCentre()))("in_scan", bit(data.inScan()))("no_params", bit(data.needsParameters()))(
            "sent_cfg", bit(data.sentConfiguration()))
            .wasComplete();
    }
}

TEST_F(MessageVectors, BBUserDataMatchesForBothKindsOfHeads) {
    const auto flag = [](bool value) { return value ? 1 : 0; };
    {
        const ByteVector bytes = bytesOf("rep_mtBBUserData_micron_dst");
        const auto message = decodeMessage(Frame{bytes});
        const auto& data = std::get<BBUserData>(message);
        EXPECT_TRUE(data.digital());
        const DigitalChannel& channel = data.channel[0];
        compare(expected_["rep_mtBBUserData_micron_dst"]["bbuser"])("surface_node", data.surface_node)(
            "ck", data.magic)("userbb_len", data.length)("board_type", data.board_type)(
            "software_version", data.software_version)("async0_low", data.main_port_low)(
            "async0_high", data.main_port_high)("generic_board_type", data.head_kind)(
            "half_duplex", flag(data.half_duplex))("has_motor", flag(data.has_motor))(
            "motor_pan_constant", data.pan_constant)("max_speed_pan", data.pan_speed)(
            "ch1_rx_start_hz", channel.receive_start_hz)("ch1_rx_end_hz", channel.receive_end_hz)(
            "ch1_filter_len_us", channel.filter_length_us)("ch1_sample_rate_hz", channel.sample_rate_hz)(
            "ch1_tx_start_hz", channel.transmit_start_hz)("ch1_tx_end_hz", channel.transmit_end_hz)(
            "ch1_tx_pulse_us", channel.transmit_pulse_us)("ch1_tx_duty", channel.transmit_duty)
            .wasComplete();
    }
    const ByteVector bytes = bytesOf("rep_mtBBUserData_seaking_dfs");
    const auto message = decodeMessage(Frame{bytes});
    const auto& data = std::get<BBUserData>(message);
    EXPECT_FALSE(data.digital());
    compare(expected_["rep_mtBBUserData_seaking_dfs"])("ck", data.magic)("userbb_len", data.length)(
        "async0_low", data.main_port_low)("async0_high", data.main_port_high)("has_motor", data.has_motor)(
        "rs485_half_duplex", flag(data.half_duplex))("motor_pan_constant", data.pan_constant)(
        "max_speed_pan", data.pan_speed)("tx1_khz", data.transmit_khz[0])("tx2_khz", data.transmit_khz[1])(
        "rx1_khz", data.receive_khz[0])("rx2_khz", data.receive_khz[1])("slope1", data.slope[0])("slope2",
                                                                                                 data.slope[1])
        .wasComplete(3);  // id, count and length of the frame stand beside them
}

void expectFields(const HeadData& line, const json& meaning) {
    compare(meaning)("total", line.total)("dev", line.device_type)("status", line.status)("sweep", line.sweep_code)(
        "hdctrl", line.head_control)("range", line.range_scale)("txn", line.transmit_word)("gain", line.gain)(
        "slope", line.slope)("adspan", line.ad_span)("adlow", line.ad_low)("hdgoff", line.heading_offset)(
        "adint", line.ad_interval)("ll", line.left_limit)("rl", line.right_limit)("step", line.step)(
        "brg", line.bearing)("dbytes", line.data_bytes)
        .wasComplete();
}

TEST_F(MessageVectors, ALineInOnePacketMatches) {
    const ByteVector bytes = bytesOf("rep_mtHeadData_single_45bins");
    HeadDataAssembler assembler;
    const auto line = assembler.take(Frame{bytes});
    ASSERT_TRUE(line);
    const json& meaning = expected_["rep_mtHeadData_single_45bins"];
    expectFields(*line, meaning["headdata"]);
    EXPECT_EQ(json(line->data), meaning["bins"]);
    EXPECT_EQ(levelsOf(*line), line->data);
    EXPECT_TRUE(line->extra.empty());
}

TEST_F(MessageVectors, AFourBitLineInTwoPacketsMatchesNibbleByNibble) {
    HeadDataAssembler assembler;
    const ByteVector first = bytesOf("rep_mtHeadData_4bit_multi_A"), second = bytesOf("rep_mtHeadData_4bit_multi_B");
    ASSERT_FALSE(assembler.take(Frame{first}));
    const auto line = assembler.take(Frame{second});
    ASSERT_TRUE(line);
    expectFields(*line, expected_["rep_mtHeadData_4bit_multi_A"]["headdata"]);
    const json& meaning = expected_["reassembled_4bit_multi"];
    EXPECT_EQ(json(line->data.size()), meaning["data_bytes"]);
    EXPECT_EQ(json(line->bins()), meaning["nbins"]);
    std::vector<int> nibbles;
    for (const std::uint8_t byte : line->data) {
        nibbles.push_back(byte >> 4);
        nibbles.push_back(byte & 0x0F);
    }
    EXPECT_EQ(json(nibbles), meaning["bins"]);
    EXPECT_TRUE(line->extra.empty());
    EXPECT_TRUE(assembler.rejected().empty());
}

TEST(Messages, PayloadsOfAnyLengthAreReadWithinTheirBounds) {
    struct Shortest {
        MessageId id;
        std::size_t bytes;
    };
    for (const auto& [id, shortest] :
         {Shortest{MessageId::VersionData, 11}, Shortest{MessageId::Alive, 8}, Shortest{MessageId::BBUserData, 161},
          Shortest{MessageId::AuxData, 2}, Shortest{MessageId::FpgaVersionData, 14}}) {
        for (std::size_t length = 0; length < 300; ++length) {
            // A block of exactly that size, so that a sanitizer sees any byte read beyond it.
            const auto block = std::make_unique<std::uint8_t[]>(length);
            RandomStream random(1, static_cast<std::uint64_t>(id), length);
            std::generate_n(block.get(), length, [&] { return static_cast<std::uint8_t>(random.bits()); });
            const auto message = decodeMessage(static_cast<std::uint8_t>(id), Bytes(block.get(), length));
            const auto* other = std::get_if<OtherMessage>(&message);
            ASSERT_EQ(other != nullptr, length < shortest) << messageName(static_cast<std::uint8_t>(id)) << length;
            if (other) {
                ASSERT_TRUE(other->malformed);
                ASSERT_EQ(other->id, static_cast<std::uint8_t>(id));
            }
        }
    }
}

TEST(Messages, AnUnknownIdIsNotMalformed) {
    const auto message = decodeMessage(61, ByteVector{});
    EXPECT_FALSE(std::get<OtherMessage>(message).malformed);
    EXPECT_EQ(messageName(61), "message 61");
    EXPECT_EQ(messageName(2), "mtHeadData");
}

TEST(Messages, AuxTextIsCutAtWhatIsThere) {
    const auto textOf = [](const ByteVector& payload) { return std::get<AuxData>(decodeMessage(8, payload)).text; };
    EXPECT_EQ(textOf({3, 0, 'a', 0x0A, '@', 'z'}), "a\n@");
    EXPECT_EQ(textOf({0xFF, 0xFF, 'a', 'b'}), "ab");
    EXPECT_EQ(textOf({0, 0}), "");
}

}  // namespace
}  // namespace echotrail::seanet
