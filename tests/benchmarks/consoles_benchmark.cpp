// From a ping's last byte to its tracks while consoles watch: one against ten, one of which reads nothing, in turns.
#include "app/io/tracker_service.hpp"
#include "core/link/link_client.hpp"
#include "core/recording/log_reader.hpp"
#include "core/recording/ping_log.hpp"
#include "core/runtime/prompt_thread.hpp"
#include "core/simulation/simulated_source.hpp"

#include <arpa/inet.h>
#include <benchmark/benchmark.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

namespace echotrail {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int rounds = 8, pings_a_round = 250;
constexpr std::chrono::milliseconds between_pings{20}, to_settle{1'500}, to_look_again{250};

double residentMebibytes() {
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// A console as others see it: it reads what comes, and asks for the rows of the run; or it reads nothing at all.
class Console {
public:
    Console(std::uint16_t port, bool deaf)
        : thread_([=, this](const std::stop_token& stop) { run(stop, port, deaf); }) {}

private:
    void run(const std::stop_token& stop, std::uint16_t port, bool deaf) {
        while (!stop.stop_requested()) {
            const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
            sockaddr_in to{.sin_family = AF_INET, .sin_port = htons(port), .sin_addr = {htonl(INADDR_LOOPBACK)}};
            if (::connect(socket, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0) talk(stop, socket, deaf);
            ::close(socket);
        }
    }
    void talk(const std::stop_token& stop, int socket, bool deaf) {
        LinkClient client({{"console", "benchmark"}, true, 0});
        const auto now = [] { return std::chrono::duration_cast<Microseconds>(Clock::now().time_since_epoch()); };
        std::int64_t next_row = std::int64_t{1} << 40;  // the first answer says how far the run is
        Microseconds asked{0};
        client.linkUp(now());
        std::vector<std::uint8_t> bytes(1 << 16);
        while (!stop.stop_requested()) {
            const std::string out = client.takeOutput();
            if (!out.empty() && ::send(socket, out.data(), out.size(), MSG_NOSIGNAL) < 0) return;
            pollfd ready{socket, POLLIN, 0};
            if (!deaf && ::poll(&ready, 1, 50) > 0) {
                const auto read = ::recv(socket, bytes.data(), bytes.size(), 0);
                if (read <= 0) return;
                client.received(now(), {bytes.data(), static_cast<std::size_t>(read)});
            } else if (deaf) {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
            }
            client.tick(now());
            while (const auto event = client.next())
                if (const auto* rows = std::get_if<LinkRows>(&*event)) next_row = rows->rows.there + 1;
            if (deaf || now() - asked < to_look_again || !client.status().mayReadRecordings()) continue;
            asked = now();
            client.readRows({"run.echotrail", {0, LogTable::Events, next_row, next_row + 1'000, 16'384}});
        }
    }
    std::jthread thread_;
};

/// The demonstration as the bytes of a head, ping by ping.
std::vector<std::vector<std::uint8_t>> pingBytes(const std::string& folder) {
    const std::string path = folder + "/pings.echotrail";
    auto source = *openSimulation("demonstration", 1);
    static_cast<void>(writePingLog(path, {}, *source));
    std::vector<std::vector<std::uint8_t>> all;
    auto log = *LogReader::open(path);
    while (auto event = log->next())
        if (event->kind == EventKind::SonarBytes) all.push_back(std::move(event->payload));
    return all;
}

struct Latencies {
    std::vector<double> us;
    double at(double share) {
        if (us.empty()) return 0.0;
        const auto nth = us.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(us.size() - 1));
        std::nth_element(us.begin(), nth, us.end());
        return *nth;
    }
};

/// A recorded run, served.
class Run {
public:
    explicit Run(const std::string& folder)
        : runner_({}, 1, *LogWriter::create(folder + "/run.echotrail", {.started = Timestamp(Microseconds(1))}),
                  [this](const Update& update, Timestamp, const ScanningSonarPipeline& pipeline) {
                      arrived_us_ = std::chrono::duration<double, std::micro>(Clock::now() - posted_.load()).count();
                      service_.take(runner_.lastPing(), update, pipeline);
                      ++taken_;
                  }),
          head_(*parseLiveAddresses("simulation://demo", ""), {}, runner_),
          service_({}, runner_, head_, "benchmark", RecordingShelf(folder, folder + "/run.echotrail")) {
        port_ = service_.start(*parseLinkAddress("tcp://127.0.0.1:0"))->port;
    }
    /// Some bytes; where they ended a ping, how long it took from there to its tracks.
    std::optional<double> ping(const std::vector<std::uint8_t>& bytes) {
        const std::uint64_t before = taken_;
        const auto now = Clock::now();
        posted_ = now;
        runner_.post(EventKind::SonarBytes, bytes);
        std::this_thread::sleep_until(now + between_pings);
        if (taken_ == before) return std::nullopt;
        return arrived_us_.load();
    }
    void end() {
        service_.stop();
        runner_.finish();  // its last word is not for consoles that are gone
    }
    const TrackerService::Counts& counts() const { return service_.counts(); }
    std::uint16_t port() const { return port_; }

private:
    std::atomic<Clock::time_point> posted_{};
    std::atomic<double> arrived_us_ = 0.0;
    std::atomic<std::uint64_t> taken_ = 0;
    std::uint16_t port_ = 0;
    LiveRunner runner_;
    HeadLink head_;
    TrackerService service_;
};

void oneConsoleAgainstTen(benchmark::State& state) {
    int argc = 1;
    char name[] = "benchmark";
    char* argv[] = {name, nullptr};
    const QCoreApplication application(argc, argv);
    becomePrompt();  // as the thread of the head's link is, whose place this one takes
    const std::string folder = std::filesystem::temp_directory_path() / ("consoles-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const auto pings = pingBytes(folder);
    Latencies one, ten;
    double first_mebibytes = 0.0, last_mebibytes = 0.0;
    for (auto _ : state) {
        Run run(folder);
        std::size_t next = 0;
        for (int round = 0; round < 2 * rounds; ++round) {
            std::vector<std::unique_ptr<Console>> consoles;
            const bool many = round % 2 == 1;
            for (int i = 0; i < (many ? 10 : 1); ++i) consoles.push_back(std::make_unique<Console>(run.port(), i == 9));
            std::this_thread::sleep_for(to_settle);
            for (int i = 0; i < pings_a_round; ++i) {
                const auto took_us = run.ping(pings[next++ % pings.size()]);
                if (took_us && round >= 2) (many ? ten : one).us.push_back(*took_us);
            }
            if (round == 3) first_mebibytes = residentMebibytes();
            last_mebibytes = residentMebibytes();
        }
        run.end();
        state.counters["missed"] = static_cast<double>(run.counts().missed);
        state.counters["row_MB"] = 1e-6 * static_cast<double>(run.counts().link.record_bytes);
    }
    std::filesystem::remove_all(folder);
    state.counters["one_p50_us"] = one.at(0.5);
    state.counters["ten_p50_us"] = ten.at(0.5);
    state.counters["one_p99_us"] = one.at(0.99);
    state.counters["ten_p99_us"] = ten.at(0.99);
    state.counters["pings"] = static_cast<double>(one.us.size() + ten.us.size());
    state.counters["more_percent"] = 100.0 * (ten.at(0.5) / one.at(0.5) - 1.0);
    state.counters["memory_MiB"] = last_mebibytes;
    state.counters["growth_MiB"] = last_mebibytes - first_mebibytes;
}
BENCHMARK(oneConsoleAgainstTen)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace echotrail
