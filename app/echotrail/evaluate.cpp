#include "commands.hpp"
#include "core/evaluation/report.hpp"
#include "core/evaluation/svg.hpp"
#include "core/pipelines/presets.hpp"
#include "core/runtime/denormals.hpp"
#include "core/simulation/demonstration.hpp"
#include "core/simulation/scenario_file.hpp"
#include "evaluation_columns.hpp"
#include "evaluation_run.hpp"
#include "event_loop.hpp"

#include <CLI/CLI.hpp>
#include <opencv2/core/utility.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

namespace echotrail {

namespace {

constexpr int default_trials = 20;
constexpr int most_trials = 10'000;

struct EvaluateArguments {
    std::vector<std::string> scenes, parameter_files, assignments, requirements;
    std::string truth, json, html;
    bool ablations = false;
    int trials = default_trials;
    std::uint64_t seed = default_scenario_seed;
    unsigned threads = 0;
};

bool isAmong(std::string_view name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Result<std::string> contentOf(const std::string& path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (file) text << file.rdbuf();
    if (!file || text.fail()) return Error{"cannot read " + path + ": " + std::strerror(errno)};
    return text.str();
}

/// A built-in scenario by its name, or one in a TOML file.
Result<EvaluationPlan::Scene> sceneNamed(const std::string& name) {
    std::string built_in = name;
    if (constexpr std::string_view scheme = "simulation://"; built_in.starts_with(scheme))
        built_in.erase(0, scheme.size());
    if (const auto found = openSimulation(built_in, default_scenario_seed))
        return EvaluationPlan::Scene{(*found)->scenario().name, (*found)->scenario().description, (*found)->scenario()};
    else if (!std::filesystem::exists(name))
        return Error{found.error()};
    if (!name.ends_with(".toml"))
        return Error{name + ": a recording needs --truth FILE, which says where its targets truly were"};
    const auto text = contentOf(name);
    if (!text) return Error{text.error()};
    auto scenario = readScenario(*text, name);
    if (!scenario) return Error{scenario.error()};
    return EvaluationPlan::Scene{scenario->name, scenario->description, *std::move(scenario)};
}

/// The recording of --truth FILE.
Result<EvaluationPlan::Scene> recordedScene(const EvaluateArguments& arguments) {
    if (arguments.scenes.size() != 1) return Error{"--truth goes with one recording, and no scenario"};
    auto truth = contentOf(arguments.truth);
    if (!truth) return Error{truth.error()};
    const std::string& path = arguments.scenes.front();
    return EvaluationPlan::Scene{.name = std::filesystem::path(path).filename().string(),
                                 .description = "A recording, held against " + arguments.truth,
                                 .recording = path,
                                 .truth_csv = *std::move(truth)};
}

Result<std::vector<EvaluationPlan::Scene>> scenesOf(const EvaluateArguments& arguments) {
    std::vector<EvaluationPlan::Scene> scenes;
    if (!arguments.truth.empty()) {
        auto scene = recordedScene(arguments);
        if (!scene) return Error{scene.error()};
        scenes.push_back(*std::move(scene));
        return scenes;
    }
    std::vector<std::string> names = arguments.scenes;
    if (names.empty())
        for (const PublishedTrial& trial : publishedTrials()) names.emplace_back(trial.scenario);
    for (const std::string& name : names) {
        auto scene = sceneNamed(name);
        if (!scene) return Error{scene.error()};
        scenes.push_back(*std::move(scene));
    }
    return scenes;
}

Result<std::vector<Requirement>> requirementsOf(const EvaluateArguments& arguments, const EvaluationPlan& plan) {
    const auto known = [](const auto& all, const std::string& name, auto part) {
        return name.empty() || std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.*part == name; });
    };
    std::vector<Requirement> requirements;
    for (const std::string& text : arguments.requirements) {
        auto requirement = parseRequirement(text);
        if (!requirement) return Error{"--require " + requirement.error()};
        if (!known(plan.scenes, requirement->scene, &EvaluationPlan::Scene::name))
            return Error{"--require " + text + ": no scene is called " + requirement->scene};
        if (!known(plan.columns, requirement->column, &EvaluationPlan::Column::title))
            return Error{"--require " + text + ": no column is called " + requirement->column};
        requirements.push_back(*std::move(requirement));
    }
    return requirements;
}

/// Without a column's name those that were asked for by --parameters and --set are judged; where there are none, the
/// default.
void judge(const std::vector<Requirement>& requirements, const EvaluateArguments& arguments, EvaluationReport& report) {
    const bool default_counts = (arguments.parameter_files.empty() && arguments.assignments.empty()) ||
                                isAmong(default_column, arguments.parameter_files);
    for (const Requirement& requirement : requirements)
        for (std::size_t s = 0; s < report.scenes.size(); ++s)
            for (std::size_t c = 0; c < report.columns.size(); ++c) {
                const std::string& title = report.columns[c].title;
                const bool asked = requirement.column.empty() ? c > 0 || default_counts : title == requirement.column;
                if (!asked || (!requirement.scene.empty() && requirement.scene != report.scenes[s].name)) continue;
                const ScenarioSummary& summary = report.summaries[s][c];
                const auto value = requirement.metric->of(summary);
                report.verdicts.push_back({requirement.text, report.scenes[s].name, title,
                                           value ? std::optional(value->value) : std::nullopt,
                                           meets(requirement, summary)});
            }
}

/// On standard error: in place on a terminal, else a line now and then.
class ProgressLine {
public:
    void tell(const EvaluationProgress& progress) {
        const auto now = std::chrono::steady_clock::now();
        if (progress.done == told_ && terminal_) return;
        if (!terminal_ && now - last_ < std::chrono::seconds(10)) return;
        last_ = now;
        told_ = progress.done;
        std::string text = std::to_string(progress.done) + " of " + std::to_string(progress.wanted) + " trials";
        if (progress.done > 0) {
            const double passed_s = std::chrono::duration<double>(now - begun_).count();
            const double left = static_cast<double>(progress.wanted - progress.done);
            text.append(", about ").append(fixedText(passed_s * left / static_cast<double>(progress.done), 0));
            text.append(" s more; ").append(progress.latest);
        }
        std::fprintf(stderr, terminal_ ? "\r\033[K%s" : "%s\n", text.c_str());
    }
    ~ProgressLine() {
        if (terminal_) std::fputs("\r\033[K", stderr);
    }

private:
    bool terminal_ = isatty(STDERR_FILENO) == 1;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now(), last_ = begun_;
    std::size_t told_ = 0;
};

/// A file that is opened before the long run, so that a wrong path costs no time.
class ReportFile {
public:
    Result<void> open(const std::string& path) {
        path_ = path;
        if (path.empty() || path == "-") return {};
        errno = 0;
        file_.open(path, std::ios::binary);
        if (!file_) return cannotWrite();
        return {};
    }
    Result<void> write(const std::string& text) {
        if (path_.empty()) return {};
        errno = 0;
        std::ostream& out = path_ == "-" ? std::cout : file_;
        out << text << std::flush;
        if (!out) return cannotWrite();
        return {};
    }
    bool isStandardOutput() const { return path_ == "-"; }

private:
    Error cannotWrite() const {
        return Error{"cannot write " + path_ + ": " + (errno ? std::strerror(errno) : "it takes no more")};
    }
    std::string path_;
    std::ofstream file_;
};

ExitCode conclude(const EvaluationReport& report, ReportFile& json, ReportFile& html) {
    if (!json.isStandardOutput() && !html.isStandardOutput()) {
        std::cout << textReport(report) << std::flush;
        if (!std::cout) return fail(ExitCode::Failed, "cannot write standard output: it takes no more");
    }
    if (const auto written = json.write(jsonReport(report)); !written) return fail(ExitCode::Failed, written.error());
    if (const auto written = html.write(htmlReport(report)); !written) return fail(ExitCode::Failed, written.error());
    if (report.interrupted)
        return fail(ExitCode::Lossy, "interrupted: " + std::to_string(report.trialsDone()) + " of " +
                                         std::to_string(report.trialsWanted()) + " trials are done");
    if (report.lost_records > 0)
        return fail(ExitCode::Lossy, "records of the recording were lost: " + std::to_string(report.lost_records));
    const auto missed = std::count_if(report.verdicts.begin(), report.verdicts.end(),
                                      [](const EvaluationReport::Verdict& verdict) { return !verdict.met; });
    if (missed == 0) return ExitCode::Done;
    return fail(ExitCode::Lossy,
                std::to_string(missed) + " of " + std::to_string(report.verdicts.size()) + " requirements are not met");
}

std::vector<std::string> columnNames(const EvaluateArguments& arguments) {
    std::vector<std::string> names = arguments.parameter_files;
    if (!arguments.ablations) return names;
    for (std::string& name : ablationColumns())
        if (!isAmong(name, names)) names.push_back(std::move(name));
    return names;
}

ExitCode evaluate(const EvaluateArguments& arguments) {
    EvaluationPlan plan{.first_seed = arguments.seed, .trials = arguments.trials};
    plan.threads = arguments.threads ? arguments.threads : std::max(1U, std::thread::hardware_concurrency());
    auto scenes = scenesOf(arguments);
    if (!scenes) return fail(ExitCode::Usage, scenes.error());
    plan.scenes = *std::move(scenes);
    auto columns = columnsOf(columnNames(arguments), arguments.assignments, plan.scenes);
    if (!columns) return fail(ExitCode::Usage, columns.error());
    plan.columns = *std::move(columns);
    const auto requirements = requirementsOf(arguments, plan);
    if (!requirements) return fail(ExitCode::Usage, requirements.error());
    ReportFile json, html;
    if (const auto opened = json.open(arguments.json); !opened) return fail(ExitCode::Failed, opened.error());
    if (const auto opened = html.open(arguments.html); !opened) return fail(ExitCode::Failed, opened.error());

    cv::setNumThreads(1);
    flushDenormals();
    catchInterrupts();
    auto report = [&] {
        ProgressLine line;
        return runEvaluation(
            plan, [&](const EvaluationProgress& progress) { line.tell(progress); }, isInterrupted);
    }();
    if (!report) return fail(ExitCode::Failed, report.error());
    report->program = "echotrail " ECHOTRAIL_VERSION;
    judge(*requirements, arguments, *report);
    return conclude(*report, json, html);
}

std::string figureHelp() {
    std::string text = "Figures, for --require NAME=VALUE (and in --json)\n";
    for (const Metric& metric : metricTable()) {
        text.append("  ")
            .append(metric.name)
            .append(metric.better == Metric::Better::Lower ? "  at most, " : "  at least, ");
        text.append(metric.unit).append("\n      ").append(metric.meaning).append("\n");
    }
    return text;
}

std::string presetNames() {
    std::string names;
    for (const Preset& preset : presets()) names.append(names.empty() ? "" : ", ").append(preset.name);
    return names.empty() ? "none" : names;
}

}  // namespace

Command addEvaluateCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "evaluate", "How well targets are tracked: scenarios with many seeds, or a recording with known truth");
    auto a = std::make_shared<EvaluateArguments>();
    command->add_option(
        "SCENARIO", a->scenes,
        "Built-in scenarios, or TOML files of others (default S1 to S5, after the published sea trials); "
        "with --truth one recording");
    command->add_option("--truth", a->truth, "CSV of where the recording's targets truly were");
    command->add_option("--trials", a->trials, "Trials of each scene with each set of parameters (default 20)")
        ->check(CLI::Range(1, most_trials));
    command->add_option("--seed", a->seed, "Seed of the first trial; each next one counts on (default 1)");
    command->add_option(
        "--parameters", a->parameter_files,
        "TOML file of parameters, or a preset's name (" + presetNames() +
            "): a column beside the default's; may be given more than once, 'default' puts that one in place. Names "
            "joined by + lie over one another, {scene} in one stands for each scene's: "
            "paper+ablations/enhanced+enhancement/{scene}-guarded");
    command->add_option("--set", a->assignments,
                        "NAME=VALUE of a parameter, as in follow_target=true: a last column, the default with it");
    command->add_flag("--ablations", a->ablations,
                      "A column for each part of the published method and of ours left out, or put back");
    command->add_option("--json", a->json, "Write every figure and trial as JSON; - is standard output");
    command->add_option("--html", a->html, "Write one page with tables and pictures; - is standard output");
    command->add_option(
        "--require", a->requirements,
        "NAME=VALUE that every scene has to keep, or exit code 3; asked of the columns of --parameters and --set, or "
        "of the default where there are none; COLUMN:NAME=VALUE, SCENE/NAME=VALUE and "
        "COLUMN:SCENE/NAME=VALUE ask it of those alone");
    command
        ->add_option("--threads", a->threads,
                     "Trials run at a time (default: as many as processors); no figure depends on it")
        ->check(CLI::Range(1U, 1024U));
    command->footer([] { return "\n" + figureHelp(); });
    return [a] { return evaluate(*a); };
}

}  // namespace echotrail
