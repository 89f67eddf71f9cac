#include "core/recording/recording.hpp"

#include "tests/core/recording/recording_files.hpp"

#include <sys/stat.h>

namespace echotrail {
namespace {

std::string errorOf(const std::string& path) {
    const auto source = openRecording(path);
    return source ? "none" : source.error();
}

TEST(OpenRecording, SaysInOneLineWhatIsWrong) {
    const TemporaryFile empty(ByteVector{});
    const TemporaryFile text({'n', 'o', 't', ' ', '@', ' ', 's', 'o', 'n', 'a', 'r', '\n'});
    const std::map<std::string, std::string> reasons{
        {testing::TempDir(), "folder"}, {testing::TempDir() + "no/such/file", "no such file"},
        {"", "no such file"},           {"/dev/null", "not a file"},
        {empty.path(), "empty"},        {text.path(), "no sonar ping"}};
    for (const auto& [path, reason] : reasons) {
        const std::string error = errorOf(path);
        EXPECT_NE(error.find(reason), std::string::npos) << error;
        EXPECT_NE(error.find("cannot open " + path), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

TEST(OpenRecording, DoesNotWaitForAPipe) {
    const std::string path = testing::TempDir() + "echotrail-pipe";
    std::filesystem::remove(path);
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    EXPECT_NE(errorOf(path).find("not a file"), std::string::npos);
    std::filesystem::remove(path);
}

TEST(OpenRecording, SaysThatAFileMayNotBeRead) {
    const TemporaryFile file(ByteVector(100, 'x'));
    std::filesystem::permissions(file.path(), std::filesystem::perms::none);
    if (std::ifstream(file.path())) GTEST_SKIP() << "this user may read everything";
    EXPECT_NE(errorOf(file.path()).find("permissions"), std::string::npos);
}

TEST(OpenRecording, LooksAtTheContentNotAtTheName) {
    const std::string path = sharedCapture("seaking_dfs_v4log/seaking_dfs_first312.V4LOG");
    if (path.empty()) GTEST_SKIP() << "needs the shared recordings";
    const TemporaryFile nameless(readBytes(path));
    const auto source = openRecording(nameless.path());
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->info().format, "Seanet Pro V4LOG");
}

}  // namespace
}  // namespace echotrail
