#include "core/recording/log_writer.hpp"
#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echotrail {

namespace {

const std::string folder_of_shared = std::string(ECHOTRAIL_SHARED_DATA) + "/seanet/seaking_dfs_v4log/";

/// The summary of a run that wrote its tracks to standard output.
nlohmann::json summaryOf(const Outcome& outcome) {
    const auto lines = linesOf(outcome.output);
    return lines.empty() ? nlohmann::json() : nlohmann::json::parse(lines.back())["summary"];
}

class RealLog : public testing::Test {
protected:
    void SetUp() override {
        log_ = contentOf(folder_of_shared + "seaking_dfs_first312.V4LOG");
        stream_ = contentOf(folder_of_shared + "seaking_dfs_first312_reframed.bin");
        if (log_.empty() || stream_.empty()) GTEST_SKIP() << "needs the shared recordings";
    }
    std::string log_, stream_;
    ScratchFolder folder_;
};

TEST(BadInput, ResultsOfOtherTypesThanTheyShouldBeAreLookedAtWithoutHarm) {
    const ScratchFolder folder;
    const std::string path = folder.path("odd.echotrail");
    {
        const auto log = LogWriter::create(path, {.started = Timestamp(Microseconds(1))});
        ASSERT_TRUE(log) << log.error();
        for (const char* text : {R"({"state": 7, "seen": false})", R"({"state": "confirmed", "seen": "no"})",
                                 R"({"state": "confirmed", "seen": false, "cause": [1]})", "[]", "{", ""})
            ASSERT_TRUE((*log)->addUpdate(UpdateKind::Track, Timestamp(Microseconds(2)), text));
        ASSERT_TRUE((*log)->close());
    }
    const Outcome info = run({"info", path, "--json"});
    EXPECT_EQ(info.exit_code, 0) << info.errors;
    const auto tracks = nlohmann::json::parse(info.output)["tracks"];
    EXPECT_EQ(tracks["looks"], 2);
    EXPECT_EQ(tracks["without_echo"], (nlohmann::json{{"not told", 1}}));
}

TEST(BadInput, ADamagedResultIsCountedAsLost) {
    const ScratchFolder folder;
    const std::string path = folder.path("damaged.echotrail");
    const auto look = [](const std::string& id) {
        return R"({"state": "confirmed", "seen": true, "id": ")" + id + "\"}";
    };
    {
        const auto log = LogWriter::create(path, {.started = Timestamp(Microseconds(1))});
        ASSERT_TRUE(log) << log.error();
        for (const char* id : {"first", "second", "third"})
            ASSERT_TRUE((*log)->addUpdate(UpdateKind::Track, Timestamp(Microseconds(2)), look(id)));
        ASSERT_TRUE((*log)->close());
    }
    EXPECT_EQ(run({"info", path}).exit_code, 0);
    std::string bytes = contentOf(path);
    const auto at = bytes.find("second");
    ASSERT_NE(at, std::string::npos);
    bytes[at] = 'S';
    const std::string damaged = folder.write("damaged.echotrail", bytes);
    const Outcome info = run({"info", damaged, "--json"});
    EXPECT_EQ(info.exit_code, 3);
    EXPECT_TRUE(isOneLine(info.errors)) << info.errors;
    const auto all = nlohmann::json::parse(info.output);
    EXPECT_EQ(all["tracks"]["looks"], 2);
    EXPECT_EQ(all["lost_records"], 1);
    EXPECT_EQ(all["rejected"], (nlohmann::json{{"damaged_result_row", 1}}));
    EXPECT_NE(run({"info", damaged}).output.find("1 damaged_result_row"), std::string::npos);
}

TEST(BadInput, WhatIsNoRecordingIsExitCodeOneWithOneLine) {
    const ScratchFolder folder;
    const std::vector<std::string> paths{folder.path("not there"), folder.path("."), folder.write("empty.V4LOG", ""),
                                         folder.write("text.txt", "Dear sonar,\nplease ping.\n"),
                                         folder.write("magic.V4LOG", "SeaNetV4 Log File V1")};
    for (const std::string& path : paths)
        for (const char* command : {"replay", "info"}) {
            const Outcome outcome = run({command, path});
            EXPECT_EQ(outcome.exit_code, 1) << command << " " << path;
            EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
            EXPECT_EQ(outcome.output, "");
        }
}

TEST(BadInput, UnwritableOutputIsExitCodeOneWithOneLine) {
    const ScratchFolder folder;
    for (const std::string& path : {folder.path("no folder/tracks"), folder.path("."), std::string("/dev/full")}) {
        const Outcome outcome = run({"replay", "simulation://deep", "--tracks", path});
        EXPECT_EQ(outcome.exit_code, 1) << path;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
}

TEST_F(RealLog, WholeFilesAreExitCodeZero) {
    const Outcome outcome = run({"replay", folder_.write("whole.V4LOG", log_), "--tracks", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_EQ(summaryOf(outcome)["pings"], 312);
    EXPECT_EQ(run({"info", folder_.write("whole.bin", stream_)}).exit_code, 0);
}

TEST_F(RealLog, AStreamCutInsideItsLastFrameLosesThatFrameAlone) {
    constexpr std::size_t frame_bytes = 687;
    for (std::size_t cut = 1; cut < frame_bytes; cut += 53) {
        const std::string path = folder_.write("cut.bin", stream_.substr(0, stream_.size() - cut));
        const Outcome outcome = run({"replay", path, "--no-fan", "--tracks", "-"});
        EXPECT_EQ(outcome.exit_code, 3) << "cut by " << cut;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_EQ(summaryOf(outcome)["pings"], 311) << "cut by " << cut;
        EXPECT_GE(summaryOf(outcome)["lost_records"], 1) << "cut by " << cut;
    }
}

TEST_F(RealLog, ALogCutInsideItsLastRecordsLosesThoseAlone) {
    // The index behind the records begins where the header says.
    const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(log_[at])); };
    const std::size_t records_end = byte(56) | byte(57) << 8 | byte(58) << 16 | byte(59) << 24;
    constexpr std::size_t settings_bytes = 279, line_bytes = 688;  // the last record holds the head's settings
    for (std::size_t cut = 1; cut < settings_bytes + line_bytes; cut += 53) {
        const std::string path = folder_.write("cut.V4LOG", log_.substr(0, records_end - cut));
        const Outcome outcome = run({"info", path, "--json"});
        EXPECT_EQ(outcome.exit_code, 3) << "cut by " << cut;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        const auto info = nlohmann::json::parse(outcome.output);
        EXPECT_EQ(info["pings"], cut <= settings_bytes ? 312 : 311) << "cut by " << cut;
        EXPECT_EQ(info["lost_records"], 1) << "cut by " << cut;
    }
}

TEST_F(RealLog, OneFlippedBitInEveryFrameIsCountedAndEndsByItself) {
    constexpr std::size_t frame_bytes = 687;
    for (const std::size_t at : {0U, 3U, 8U, 12U, 40U, 300U, 686U}) {
        std::string damaged = stream_;
        for (std::size_t frame = 0; frame * frame_bytes + at < damaged.size(); ++frame) {
            char& byte = damaged[frame * frame_bytes + at];
            byte = static_cast<char>(byte ^ 0x10);
        }
        const Outcome outcome = run({"replay", folder_.write("damaged.bin", damaged), "--no-fan", "--tracks", "-"});
        EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1 || outcome.exit_code == 3)
            << "byte " << at << ": " << outcome.exit_code;
        EXPECT_TRUE(outcome.exit_code == 0 || isOneLine(outcome.errors)) << outcome.errors;
        const bool told = outcome.exit_code != 3 || summaryOf(outcome)["lost_records"] > 0;
        EXPECT_TRUE(told) << "byte " << at;
    }
}

}  // namespace

}  // namespace echotrail
