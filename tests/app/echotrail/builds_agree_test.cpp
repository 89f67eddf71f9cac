#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace echotrail {

namespace {

using Json = nlohmann::json;

constexpr double one_millimetre = 1e-3;

/// Two builds round differently in the last digits. What a user acts on may not differ: which objects there are, in
/// what state, when they were looked at, and where they are to a millimetre.
class BuildsAgree : public testing::TestWithParam<const char*> {
protected:
    static std::vector<Json> tracksOf(const Outcome& outcome) {
        std::vector<Json> tracks;
        for (const std::string& line : linesOf(outcome.output)) {
            Json parsed = Json::parse(line);
            if (!parsed.contains("summary")) tracks.push_back(std::move(parsed));
        }
        return tracks;
    }

    static void compare(const std::string& source) {
        const char* release = std::getenv("ECHOTRAIL_RELEASE");
        if (release == nullptr || !std::filesystem::exists(release))
            GTEST_SKIP() << "needs ECHOTRAIL_RELEASE, the program of the release preset";
        const std::vector<std::string> arguments{"replay", source, "--tracks", "-"};
        const Outcome of_release = runProgram(release, arguments);
        const Outcome of_this = run(arguments);
        ASSERT_TRUE(of_release.exit_code == 0 || of_release.exit_code == 3) << of_release.errors;
        EXPECT_EQ(of_this.exit_code, of_release.exit_code) << of_this.errors;
        const std::vector<Json> expected = tracksOf(of_release);
        const std::vector<Json> got = tracksOf(of_this);
        ASSERT_EQ(expected.empty(), source.starts_with("simulation://empty")) << "which has nothing to follow";
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            for (const char* field : {"track", "state", "time", "seen"})
                EXPECT_EQ(got[i].at(field), expected[i].at(field)) << got[i] << "\n" << expected[i];
            for (const char* field : {"north_m", "east_m", "range_m"})
                EXPECT_NEAR(got[i].at(field).get<double>(), expected[i].at(field).get<double>(), one_millimetre)
                    << field << " of " << got[i];
            if (HasFailure()) return;
        }
    }
};

TEST_P(BuildsAgree, OnAShippedScenario) { compare("simulation://" + std::string(GetParam()) + "?seed=3"); }
INSTANTIATE_TEST_SUITE_P(Scenarios, BuildsAgree, testing::Values("demonstration", "deep", "empty"));

class BuildsAgreeOnRecordings : public BuildsAgree {};

TEST_P(BuildsAgreeOnRecordings, OnARealRecording) {
    const std::string recording = std::string(ECHOTRAIL_SHARED_DATA) + "/seanet/" + GetParam();
    if (!std::filesystem::exists(recording)) GTEST_SKIP() << "needs the shared recordings";
    compare(recording);
}
INSTANTIATE_TEST_SUITE_P(Recordings, BuildsAgreeOnRecordings,
                         testing::Values("seaking_dfs_v4log/seaking_dfs_first312.V4LOG",
                                         "seaking_dst_udp/sonar_stream_part1.bin"));

}  // namespace

}  // namespace echotrail
