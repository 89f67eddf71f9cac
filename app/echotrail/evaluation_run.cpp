#include "evaluation_run.hpp"

#include "core/recording/recording.hpp"
#include "core/runtime/denormals.hpp"
#include "core/runtime/processor_time.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

namespace echotrail {

namespace {

constexpr auto tell_interval = std::chrono::milliseconds(200);
constexpr std::size_t timed_pings = 600;  // one minute of a simulated head

/// A scene with a seed, for every set of parameters in turn: they share the simulated pings.
struct Job {
    std::size_t scene = 0;
    std::uint64_t seed = 0;
};

using Finished = std::vector<std::vector<std::vector<TrialMetrics>>>;  // [scene][column]

Result<std::unique_ptr<PingSource>> openScene(const EvaluationPlan& plan, std::size_t scene, std::size_t column,
                                              std::uint64_t seed) {
    const EvaluationPlan::Scene& what = plan.scenes[scene];
    if (what.scenario) return std::unique_ptr<PingSource>(std::make_unique<SimulatedSource>(*what.scenario, seed));
    const EvaluationPlan::Column& how = plan.columns[column];
    return openRecording(what.recording, {.sound_speed_mps = how.sound_speed,
                                          .default_sound_speed_mps = how.params[scene].head.sound_speed});
}

Result<Truth> truthOf(const EvaluationPlan::Scene& scene, const PingSource& source) {
    if (scene.scenario) return Truth(static_cast<const SimulatedSource&>(source).truth());
    return Truth::read(scene.truth_csv, source.info().start);
}

/// All that the threads of a run share.
class Trials {
public:
    Trials(const EvaluationPlan& plan, const std::function<bool()>& cancelled) : plan_(plan), cancelled_(cancelled) {
        for (int i = 0; i < plan.trials; ++i)
            for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
                jobs_.push_back({scene, plan.first_seed + static_cast<std::uint64_t>(i)});
        finished_.assign(plan.scenes.size(), std::vector<std::vector<TrialMetrics>>(plan.columns.size()));
        examples_.assign(plan.scenes.size(), std::vector<TrialResult>(plan.columns.size()));
        progress_.wanted = jobs_.size() * plan.columns.size();
    }

    /// One thread's share.
    void work() {
        flushDenormals();
        for (std::size_t i = next_++; i < jobs_.size() && !stop(); i = next_++) {
            try {
                if (const auto done = run(jobs_[i]); !done) fail(done.error());
            } catch (const std::exception& failure) {
                fail(failure.what());
            }
        }
    }

    EvaluationProgress progress() const {
        const std::lock_guard lock(mutex_);
        return progress_;
    }
    std::string failure() const { return failure_; }
    std::uint64_t lostRecords() const { return lost_records_; }
    Finished& finished() { return finished_; }
    std::vector<std::vector<TrialResult>>& examples() { return examples_; }

private:
    bool stop() const { return failed_ || cancelled_(); }

    Result<void> run(const Job& job) {
        const EvaluationPlan::Scene& scene = plan_.scenes[job.scene];
        const auto cancel = [this] { return stop(); };
        std::optional<SimulatedSource> simulated;
        if (scene.scenario) simulated.emplace(*scene.scenario, job.seed);
        if (simulated && plan_.columns.size() > 1) simulated->keepPings();
        for (std::size_t column = 0; column < plan_.columns.size(); ++column) {
            const ScanningSonarPipeline::Params& params = plan_.columns[column].params[job.scene];
            TrialResult result;
            if (simulated) {
                result = runTrial(*simulated, params, job.seed, cancel);
            } else {
                const auto source = openScene(plan_, job.scene, column, job.seed);
                if (!source) return Error{source.error()};
                const auto truth = truthOf(scene, **source);
                if (!truth) return Error{truth.error()};
                result = runTrial(**source, *truth, params, job.seed, cancel);
                lost_records_ = (*source)->counts().lost_records;
            }
            if (stop()) return {};  // it may be cut short
            keep(job, column, std::move(result));
        }
        return {};
    }

    void keep(const Job& job, std::size_t column, TrialResult result) {
        TrialMetrics metrics = measure(result);
        const std::lock_guard lock(mutex_);
        finished_[job.scene][column].push_back(std::move(metrics));
        if (job.seed == plan_.first_seed) examples_[job.scene][column] = std::move(result);
        ++progress_.done;
        progress_.latest =
            plan_.scenes[job.scene].name + ", " + plan_.columns[column].title + ", seed " + std::to_string(job.seed);
    }

    void fail(const std::string& reason) {
        const std::lock_guard lock(mutex_);
        if (failure_.empty()) failure_ = reason;
        failed_ = true;
    }

    const EvaluationPlan& plan_;
    const std::function<bool()>& cancelled_;
    std::vector<Job> jobs_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> failed_ = false;
    std::atomic<std::uint64_t> lost_records_ = 0;
    mutable std::mutex mutex_;
    EvaluationProgress progress_;
    std::string failure_;
    Finished finished_;
    std::vector<std::vector<TrialResult>> examples_;
};

/// Processor time of the pipeline for one ping: what makes the pings does not count.
double timePipeline(const EvaluationPlan& plan, std::size_t scene, std::size_t column) {
    const auto source = openScene(plan, scene, column, plan.first_seed);
    if (!source) return 0;
    std::vector<Ping> pings;
    while (pings.size() < timed_pings) {
        auto ping = (*source)->next();
        if (!ping) break;
        pings.push_back(*std::move(ping));
    }
    if (pings.empty()) return 0;
    ScanningSonarPipeline pipeline(plan.columns[column].params[scene], plan.first_seed);
    pipeline.setFanPainting(false);
    const auto truth = truthOf(plan.scenes[scene], **source);
    if (truth && truth->targets() > 0)
        if (const auto target = truth->at(0, pings.front().time); target && target->has_sight)
            pipeline.designate(target->range_m, target->from_bow);
    const double begun = processorSeconds();
    for (const Ping& ping : pings) pipeline.process(ping, (*source)->navigation());
    pipeline.finish();
    return 1e3 * (processorSeconds() - begun) / static_cast<double>(pings.size());
}

double memoryUsed_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// "name = value unit" of every parameter that is not the default somewhere; where scenes differ, the value of each.
std::vector<std::string> settingsOf(const EvaluationPlan& plan, const EvaluationPlan::Column& column) {
    const auto infos = describeParameters<ScanningSonarPipeline::Params>();
    std::vector<std::vector<ParameterValue>> values;  // [scene][parameter]
    for (const auto& params : column.params) values.push_back(parameterValues(params));
    std::vector<std::string> settings;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const auto isUsual = [&](const auto& scene) { return scene[i] == infos[i].default_value; };
        const auto isLikeFirst = [&](const auto& scene) { return scene[i] == values.front()[i]; };
        if (std::all_of(values.begin(), values.end(), isUsual)) continue;
        const bool same = std::all_of(values.begin(), values.end(), isLikeFirst);
        std::string text;
        for (std::size_t s = 0; s < (same ? 1 : values.size()); ++s) {
            text.append(text.empty() ? "" : ", ").append(ParameterInfo::toText(values[s][i]));
            if (!infos[i].unit.empty()) text.append(" ").append(infos[i].unit);
            if (!same) text.append(" in ").append(plan.scenes[s].name);
        }
        settings.push_back(infos[i].name + " = " + text);
    }
    return settings;
}

}  // namespace

Result<EvaluationReport> runEvaluation(const EvaluationPlan& plan,
                                       const std::function<void(const EvaluationProgress&)>& tell,
                                       const std::function<bool()>& cancelled) {
    Trials trials(plan, cancelled);
    const auto count = std::min<std::size_t>(std::max(1U, plan.threads), trials.progress().wanted);
    std::atomic<std::size_t> working = count;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < count; ++i)
            threads.emplace_back([&] {
                trials.work();
                --working;
            });
        while (working > 0) {
            std::this_thread::sleep_for(tell_interval);
            tell(trials.progress());
        }
    }
    if (!trials.failure().empty()) return Error{trials.failure()};
    EvaluationReport report{.first_seed = plan.first_seed, .trials = plan.trials, .memory_mb = memoryUsed_mb()};
    for (const auto& column : plan.columns) report.columns.push_back({column.title, settingsOf(plan, column)});
    for (std::size_t s = 0; s < plan.scenes.size(); ++s) {
        report.scenes.push_back({plan.scenes[s].name, plan.scenes[s].description});
        auto& row = report.summaries.emplace_back();
        for (std::size_t c = 0; c < plan.columns.size(); ++c) {
            row.push_back(summarise(plan.scenes[s].name, plan.columns[c].title, std::move(trials.finished()[s][c])));
            if (!cancelled()) row.back().processing_ms_per_ping = timePipeline(plan, s, c);
        }
    }
    report.examples = std::move(trials.examples());
    report.lost_records = trials.lostRecords();
    report.interrupted = report.trialsDone() < report.trialsWanted();
    return report;
}

}  // namespace echotrail
