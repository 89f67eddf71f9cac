#include "core/recording/log_reader.hpp"
#include "core/runtime/recorder.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace echotrail {
namespace {

constexpr int no_small_disk = 77;

/// A disk of 2 MB for this process alone; needs no rights where the system lets anyone have name spaces.
bool mountSmallDisk(const std::string& folder) {
    const auto write = [](const char* path, const std::string& text) { std::ofstream(path) << text; };
    const std::string user = std::to_string(getuid()), group = std::to_string(getgid());
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    write("/proc/self/setgroups", "deny");
    write("/proc/self/uid_map", "0 " + user + " 1");
    write("/proc/self/gid_map", "0 " + group + " 1");
    return mount("none", folder.c_str(), "tmpfs", 0, "size=2m") == 0;
}

void fillTheDisk(const std::string& folder) {
    const std::string path = folder + "/a.echotrail";
    auto log = LogWriter::create(path, {"test", "head", "", 1, Timestamp{}});
    ASSERT_TRUE(log) << log.error();
    std::uint64_t added = 0;
    {
        Recorder recorder(*std::move(log));
        EXPECT_EQ(recorder.status().disk, DiskState::Full) << "the alarm is there before anything is lost";
        EXPECT_TRUE(recorder.status().recording);
        const auto add = [&] {
            recorder.add(Event{added, EventKind::SonarBytes, Timestamp{},
                               Microseconds(static_cast<int>(added) * 50'000), std::vector<std::uint8_t>(20'000, 1)});
            ++added;
        };
        for (int i = 0; i < 1000 && recorder.status().error.empty(); ++i) {
            add();
            std::this_thread::sleep_for(std::chrono::milliseconds(20));  // some commits succeed
        }
        const RecorderStatus full = recorder.status();
        EXPECT_FALSE(full.error.empty());
        EXPECT_EQ(full.error.find('\n'), std::string::npos) << full.error;
        EXPECT_FALSE(full.recording);
        add();
        recorder.close();
        EXPECT_GT(recorder.status().unsaved, full.unsaved) << "what follows is counted";
        added -= recorder.status().unsaved;
    }
    const auto reader = LogReader::open(path);
    ASSERT_TRUE(reader) << reader.error();
    std::uint64_t kept = 0;
    while ((*reader)->next()) ++kept;
    EXPECT_EQ(kept, added) << "what was committed is there, and nothing is counted twice";
    EXPECT_GT(kept, 0u);
}

TEST(FullDisk, IsAnAlarmThenTheEndOfRecordingAndWhatWasCommittedStays) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "the thread sanitizer lets no child of a process with threads start any";
#endif
    const std::string folder = testing::TempDir() + "echotrail-small-disk";
    std::filesystem::create_directories(folder);
    const pid_t child = fork();
    if (child == 0) {
        if (!mountSmallDisk(folder)) _exit(no_small_disk);
        fillTheDisk(folder);
        _exit(testing::Test::HasFailure() ? 1 : 0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    std::filesystem::remove(folder);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == no_small_disk) GTEST_SKIP() << "this system lets no one mount a small disk";
    EXPECT_EQ(WEXITSTATUS(status), 0) << "see above";
}

}  // namespace
}  // namespace echotrail
