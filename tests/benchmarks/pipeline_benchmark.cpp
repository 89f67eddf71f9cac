// The whole pipeline: pings per second, times real time, time from ping to track, and memory over many repetitions.
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/recording/recording.hpp"
#include "core/runtime/denormals.hpp"
#include "core/simulation/simulated_source.hpp"

#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace echotrail {
namespace {

struct Recorded {
    std::vector<Ping> pings;
    PoseHistory navigation;
    double seconds = 0;
};

Recorded recorded(PingSource& source) {
    Recorded all{{}, source.navigation()};
    while (auto ping = source.next()) all.pings.push_back(std::move(*ping));
    all.seconds = secondsBetween(all.pings.front().time, all.pings.back().time);
    return all;
}

/// The 50 m recording of a real head where the shared recordings are, the demonstration (50 m, too) elsewhere.
Recorded fiftyMetres() {
    const std::string file = std::string(ECHOTRAIL_SHARED_DATA) + "/seanet/seaking_dst_udp/sonar_stream_part1.bin";
    if (std::filesystem::exists(file)) return recorded(**openRecording(file));
    return recorded(**openSimulation("demonstration", 1));
}

double residentMebibytes() {
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

void wholePipeline(benchmark::State& state, bool paint_fan, const Recorded& recording) {
    cv::setNumThreads(1);
    flushDenormals();
    std::vector<double> latencies;
    double first_mebibytes = 0;
    std::int64_t runs = 0;
    for (auto _ : state) {
        ScanningSonarPipeline pipeline({}, 1);
        pipeline.setFanPainting(paint_fan);
        for (const Ping& ping : recording.pings) {
            const auto start = std::chrono::steady_clock::now();
            benchmark::DoNotOptimize(pipeline.process(ping, recording.navigation).looks.size());
            latencies.push_back(
                std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
        }
        pipeline.finish();
        if (++runs == 2) first_mebibytes = residentMebibytes();
        if (latencies.size() > 1'000'000) latencies.clear();
    }
    const auto pings = static_cast<double>(runs) * static_cast<double>(recording.pings.size());
    state.counters["pings/s"] = benchmark::Counter(pings, benchmark::Counter::kIsRate);
    state.counters["x_real_time"] =
        benchmark::Counter(static_cast<double>(runs) * recording.seconds, benchmark::Counter::kIsRate);
    std::sort(latencies.begin(), latencies.end());
    state.counters["p50_us"] = latencies[latencies.size() / 2];
    state.counters["p99_us"] = latencies[latencies.size() * 99 / 100];
    state.counters["p99.9_us"] = latencies[latencies.size() * 999 / 1000];
    state.counters["growth_MiB"] = residentMebibytes() - first_mebibytes;
    state.counters["memory_MiB"] = residentMebibytes();
}

void withFan(benchmark::State& state) { wholePipeline(state, true, fiftyMetres()); }
void withoutFan(benchmark::State& state) { wholePipeline(state, false, fiftyMetres()); }
void demonstrationWithFan(benchmark::State& state) {
    wholePipeline(state, true, recorded(**openSimulation("demonstration", 1)));
}
BENCHMARK(withFan)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK(withoutFan)->Unit(benchmark::kMillisecond)->Iterations(100);
BENCHMARK(demonstrationWithFan)->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace
}  // namespace echotrail
