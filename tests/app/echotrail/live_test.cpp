#include "program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>

namespace echotrail {
namespace {

/// echotrail in the background; it is told to end when this goes.
class Background {
public:
    explicit Background(std::vector<std::string> arguments) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) return;
        process_ = fork();
        if (process_ == 0) {
            dup2(ends[1], STDOUT_FILENO);
            const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
            dup2(nowhere, STDERR_FILENO);
            arguments.insert(arguments.begin(), ECHOTRAIL_PROGRAM);
            std::vector<char*> argv;
            for (std::string& argument : arguments) argv.push_back(argument.data());
            argv.push_back(nullptr);
            execv(ECHOTRAIL_PROGRAM, argv.data());
            _exit(127);
        }
        close(ends[1]);
        output_ = ends[0];
    }
    ~Background() {
        end(SIGTERM);
        close(output_);
    }
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// The next line of its standard output; empty where none comes within a minute.
    std::string line() const {
        std::string text;
        for (char c = 0; text.size() < 10'000;) {
            pollfd wait{output_, POLLIN, 0};
            if (poll(&wait, 1, 60'000) != 1 || read(output_, &c, 1) != 1 || c == '\n') break;
            text += c;
        }
        return text;
    }
    /// Its exit code; −1 where the signal ended it.
    int end(int signal) {
        if (process_ <= 0) return -1;
        kill(process_, signal);
        int status = 0;
        waitpid(process_, &status, 0);
        process_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t process_ = -1;
    int output_ = -1;
};

/// A simulated head that is ready at once, at the address it tells.
class LiveProgram : public testing::TestWithParam<const char*> {
protected:
    static std::vector<std::string> simulate(const std::string& where) {
        return {"simulate",      "demo",   "--serve-sonar",     where,        "--head",
                "head_boot_s=0", "--head", "head_centring_s=0", "--duration", "100"};
    }
    static std::string sonarOf(const Background& head) {
        return nlohmann::json::parse(head.line(), nullptr, false).value("sonar", "");
    }
    /// Without the summary, which tells how long things took.
    static std::vector<std::string> looksIn(const std::string& path) {
        std::vector<std::string> lines = linesOf(contentOf(path));
        if (!lines.empty()) lines.pop_back();
        return lines;
    }
    ScratchFolder folder_;
};

TEST_P(LiveProgram, ItsRecordingGivesTheSameTracks) {
    std::optional<Background> head;
    std::string sonar = GetParam();
    if (!sonar.starts_with("simulation://")) {
        head.emplace(simulate(sonar));
        sonar = sonarOf(*head);
    }
    ASSERT_NE(sonar, "");
    const std::string log = folder_.path("a.echotrail"), live = folder_.path("live.jsonl");
    const Outcome tracked = run({"track", "--sonar", sonar, "--record", log, "--tracks", live, "--duration", "16",
                                 "--quiet", "--set", "channel=low"});
    EXPECT_EQ(tracked.exit_code, 0) << tracked.errors;
    const auto summary = nlohmann::json::parse(linesOf(contentOf(live)).back())["summary"];
    EXPECT_GT(summary["pings"].get<int>(), 50);
    EXPECT_EQ(summary["exit_reason"], "duration reached");

    const std::string again = folder_.path("again.jsonl");
    EXPECT_EQ(run({"replay", log, "--tracks", again}).exit_code, 0);
    EXPECT_EQ(looksIn(again), looksIn(live));
    EXPECT_FALSE(looksIn(live).empty());
    const Outcome verified = run({"verify", log});
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    EXPECT_NE(verified.output.find("identical"), std::string::npos);
    EXPECT_EQ(run({"info", log}).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(Channels, LiveProgram,
                         testing::Values("tcp://127.0.0.1:0", "udp://127.0.0.1:0", "pty", "simulation://demo?seed=3"));

/// A motion controller that listens on UDP.
class Controller {
public:
    Controller() {
        socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
        sockaddr_in here{};
        here.sin_family = AF_INET;
        here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof here;
        auto* address = reinterpret_cast<sockaddr*>(&here);
        if (bind(socket_, address, size) == 0 && getsockname(socket_, address, &size) == 0) port = ntohs(here.sin_port);
    }
    ~Controller() { close(socket_); }
    Controller(const Controller&) = delete;
    Controller& operator=(const Controller&) = delete;

    /// The next report; empty where none comes within a minute.
    std::string report() const {
        std::array<char, 2048> bytes{};
        pollfd wait{socket_, POLLIN, 0};
        if (poll(&wait, 1, 60'000) != 1) return {};
        const ssize_t size = recv(socket_, bytes.data(), bytes.size(), 0);
        return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
    }
    std::uint16_t port = 0;

private:
    int socket_ = -1;
};

/// A simulated head that is ready at once, and a tracker that follows a piece of debris which it sees early.
struct ReportingTracker {
    explicit ReportingTracker(const Controller& controller, const std::string& options)
        : head({"simulate", "demo", "--serve-sonar", "tcp://127.0.0.1:0", "--head", "head_boot_s=0", "--head",
                "head_centring_s=0"}),
          track({"track", "--sonar", nlohmann::json::parse(head.line(), nullptr, false).value("sonar", ""),
                 "--no-record", "--quiet", "--set", "channel=low", "--target", "46,20", "--report",
                 "udp://127.0.0.1:" + std::to_string(controller.port) + options}) {}
    Background head, track;
};

TEST(TargetFeed, SaysSteadilyWhereTheTargetIsByNow) {
    const Controller controller;
    const ReportingTracker tracker(controller, "?rate=5");
    double last_t = -1.0, last_covariance = 0.0;
    for (int predictions = 0; predictions < 6;) {
        const auto report = nlohmann::json::parse(controller.report(), nullptr, false);
        ASSERT_TRUE(report.is_object());
        EXPECT_TRUE(report["target"].get<bool>());
        for (const char* number :
             {"velocity_north_mps", "velocity_east_mps", "age_s", "closest_approach_m", "time_to_closest_s", "risk"})
            EXPECT_TRUE(report[number].is_number()) << number;
        EXPECT_TRUE(report["valid"].is_boolean());
        const double t = report["t"], covariance = report["covariance_m2"][0];
        const bool is_look = report["seen"].get<bool>() || t <= last_t;  // or the beam has passed and seen nothing
        if (is_look) predictions = 0;
        if (predictions > 0) {
            EXPECT_GE(covariance, last_covariance) << "between looks it is known less and less";
        }
        last_t = is_look ? -1.0 : t;
        last_covariance = covariance;
        if (is_look) continue;
        ++predictions;
    }
}

TEST(TargetFeed, AHeadThatFallsSilentMakesItInvalid) {
    const Controller controller;
    ReportingTracker tracker(controller, "?rate=20");
    const auto valid_is = [&](bool wanted) {
        for (int i = 0; i < 2000; ++i) {
            const auto report = nlohmann::json::parse(controller.report(), nullptr, false);
            if (!report.is_object()) return false;
            if (report["valid"].get<bool>() == wanted) return true;
        }
        return false;
    };
    ASSERT_TRUE(valid_is(true));
    tracker.head.end(SIGKILL);
    EXPECT_TRUE(valid_is(false));
}

TEST(TargetFeed, SpeaksNmeaToo) {
    const Controller controller;
    const ReportingTracker tracker(controller, "?rate=10&format=nmea");
    const std::string report = controller.report();
    EXPECT_NE(report.find("TTM,"), std::string::npos) << report;
    EXPECT_TRUE(report.ends_with("\r\n"));
}

using LiveRecording = LiveProgram;

TEST_F(LiveRecording, AKilledTrackerLeavesALogThatOpensAndVerifies) {
    const Background head(simulate("tcp://127.0.0.1:0"));
    const std::string log = folder_.path("killed.echotrail");
    {
        Background track({"track", "--sonar", sonarOf(head), "--record", log, "--tracks", "-"});
        while (!std::filesystem::exists(log)) usleep(20'000);
        sleep(6);  // pings are coming, and some commits have been made
        track.end(SIGKILL);
    }
    const Outcome verified = run({"verify", log});
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    EXPECT_EQ(run({"info", log}).exit_code, 0);
}

TEST_F(LiveRecording, TheSignalToEndClosesTheLogAndWritesTheSummary) {
    const Background head(simulate("tcp://127.0.0.1:0"));
    const std::string log = folder_.path("ended.echotrail"), tracks = folder_.path("t.jsonl");
    Background track({"track", "--sonar", sonarOf(head), "--record", log, "--tracks", tracks});
    while (!std::filesystem::exists(log)) usleep(20'000);
    sleep(4);
    EXPECT_EQ(track.end(SIGTERM), 0);
    const auto summary = nlohmann::json::parse(linesOf(contentOf(tracks)).back())["summary"];
    EXPECT_EQ(summary["exit_reason"], "interrupted");
    EXPECT_FALSE(std::filesystem::exists(log + "-wal"));
}

TEST(LiveUsage, ALogWithoutAPingOpensToBeLookedAt) {
    const ScratchFolder folder;
    const std::string log = folder.path("nobody.echotrail");
    run({"track", "--sonar", "tcp://127.0.0.1:1", "--record", log, "--duration", "1", "--quiet"});
    const Outcome info = run({"info", log, "--json"});
    EXPECT_EQ(info.exit_code, 0) << info.errors;
    EXPECT_EQ(nlohmann::json::parse(info.output)["pings"], 0);
    EXPECT_EQ(run({"verify", log}).exit_code, 0);
    const Outcome replay = run({"replay", log});
    EXPECT_EQ(replay.exit_code, 1);  // there is nothing to replay
    EXPECT_TRUE(isOneLine(replay.errors)) << replay.errors;
}

TEST(LiveUsage, WrongAddressesAreSaidInOneLine) {
    for (const char* sonar :
         {"tcp://nowhere", "serial://ttyUSB0", "a.V4LOG", "udp://h:99999", "simulation://atlantis"}) {
        const Outcome outcome = run({"track", "--sonar", sonar, "--no-record"});
        EXPECT_EQ(outcome.exit_code, 2) << sonar;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
    const ScratchFolder folder;
    const Outcome exists = run({"track", "--sonar", "tcp://127.0.0.1:1", "--record", folder.write("x.echotrail", "x")});
    EXPECT_EQ(exists.exit_code, 1);
    EXPECT_TRUE(isOneLine(exists.errors)) << exists.errors;
}

TEST(LiveUsage, ConsolesAreServedByPlainTcpOnThisMachineOnly) {
    for (const char* serve :
         {"tcp://0.0.0.0:7000", "tcp://192.168.1.5:7000", "tcp://[::]:0", "udp://127.0.0.1:0", "tls://vehicle:7000"}) {
        const Outcome outcome = run({"track", "--sonar", "tcp://127.0.0.1:1", "--no-record", "--serve", serve});
        EXPECT_EQ(outcome.exit_code, 2) << serve;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
}

TEST(LiveUsage, NavigationIsNotServedToNobody) {
    const Outcome outcome =
        run({"simulate", "demo", "--serve-sonar", "pty", "--serve-navigation", "udp://127.0.0.1:0"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
}

TEST(Convert, AnImportedScenarioGivesItsTracksAndItsPings) {
    const ScratchFolder folder;
    const std::string log = folder.path("s.echotrail"), truth = folder.path("truth.csv");
    ASSERT_EQ(run({"simulate", "demo", "--log", log, "--truth", truth, "--duration", "40"}).exit_code, 0);
    EXPECT_EQ(linesOf(contentOf(truth)).front(),
              "t,target,north_m,east_m,velocity_north_mps,velocity_east_mps,visible");
    ASSERT_EQ(run({"replay", log, "--tracks", folder.path("a.jsonl")}).exit_code, 0);
    // No tracker ran when it was made: nothing can be called identical.
    EXPECT_EQ(run({"verify", log}).exit_code, 3);
    ASSERT_EQ(run({"convert", log, folder.path("tracks.csv")}).exit_code, 0);
    EXPECT_EQ(linesOf(contentOf(folder.path("tracks.csv"))).size(), linesOf(contentOf(folder.path("a.jsonl"))).size());
    ASSERT_EQ(run({"convert", log, folder.path("pings.csv"), "--what", "pings"}).exit_code, 0);
    const auto summary = nlohmann::json::parse(linesOf(contentOf(folder.path("a.jsonl"))).back())["summary"];
    EXPECT_EQ(linesOf(contentOf(folder.path("pings.csv"))).size(), summary["pings"].get<std::size_t>() + 1);
    EXPECT_EQ(run({"convert", log, folder.path("picture.gif")}).exit_code, 2);

    std::string bytes = contentOf(log);
    bytes.resize(bytes.size() / 2);
    const std::string cut = folder.write("cut.echotrail", bytes), saved = folder.path("saved.echotrail");
    EXPECT_EQ(run({"recover", cut, saved}).exit_code, 3);
    EXPECT_NE(run({"info", saved}).output.find("Echotrail log"), std::string::npos);
}

}  // namespace
}  // namespace echotrail
