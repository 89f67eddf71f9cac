#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace echotrail {
namespace {

using Json = nlohmann::json;

constexpr double one_millimetre = 1e-3;

/// Two builds round differently in the last digits. What a user acts on may not differ: which objects there are, in
/// what state, when they were looked at, and where they are to a millimetre.
class BuildsAgree : public testing::TestWithParam<const char*> {
protected:
    static std::vector<Json> looksOf(const std::string& program, const std::string& source_arguments) {
        std::vector<Json> looks;
        FILE* output = popen(("'" + program + "' " + source_arguments).c_str(), "r");
        if (output == nullptr) {
            ADD_FAILURE() << "cannot run " << program;
            return looks;
        }
        char line[4096];
        while (std::fgets(line, sizeof line, output) != nullptr) looks.push_back(Json::parse(line));
        EXPECT_EQ(pclose(output), 0) << program << " " << source_arguments;
        return looks;
    }

    static void compare(const std::string& source) {
        const char* release = std::getenv("ECHOTRAIL_RELEASE_LOOKS");
        if (release == nullptr || !std::filesystem::exists(release))
            GTEST_SKIP() << "needs ECHOTRAIL_RELEASE_LOOKS, print_looks of the release preset";
        const std::vector<Json> expected = looksOf(release, source);
        const std::vector<Json> got = looksOf(ECHOTRAIL_LOOKS, source);
        ASSERT_EQ(expected.empty(), source.starts_with("empty ")) << "which has nothing to follow";
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

TEST_P(BuildsAgree, OnAShippedScenario) { compare(std::string(GetParam()) + " 3"); }
INSTANTIATE_TEST_SUITE_P(Scenarios, BuildsAgree, testing::Values("demonstration", "deep", "empty"));

class BuildsAgreeOnRecordings : public BuildsAgree {};

TEST_P(BuildsAgreeOnRecordings, OnARealRecording) {
    const std::string recording = std::string(ECHOTRAIL_SHARED_DATA) + "/seanet/" + GetParam();
    if (!std::filesystem::exists(recording)) GTEST_SKIP() << "needs the shared recordings";
    compare("'" + recording + "'");
}
INSTANTIATE_TEST_SUITE_P(Recordings, BuildsAgreeOnRecordings,
                         testing::Values("seaking_dfs_v4log/seaking_dfs_first312.V4LOG",
                                         "seaking_dst_udp/sonar_stream_part1.bin"));

}  // namespace
}  // namespace echotrail
