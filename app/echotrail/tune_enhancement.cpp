#include "commands.hpp"
#include "core/base/parameters.hpp"
#include "core/simulation/simulated_source.hpp"
#include "core/tuning/enhancement_tuning.hpp"
#include "event_loop.hpp"

#include <CLI/CLI.hpp>
#include <opencv2/core/utility.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

namespace echotrail {

namespace {

constexpr std::uint64_t default_tuning_seed = 1000;  // none of those that are usually evaluated

struct TuneEnhancementArguments {
    std::string scenario, out = "-";
    EnhancementObjective objective = EnhancementObjective::Published;
    std::uint64_t seed = default_tuning_seed;
    int pictures = 3;
};

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

/// A TOML file of parameters that says where they come from.
std::string fileText(const TuneEnhancementArguments& arguments, const std::string& scene,
                     const TunedEnhancement& tuned) {
    std::ostringstream text;
    text << "# Tuned to " << scene << " by particle swarm: the " << toText(arguments.objective) << " objective, seed "
         << arguments.seed << ", " << arguments.pictures << " pictures,\n# " << tuned.evaluations
         << " evaluations. The objective is " << rounded(tuned.value) << "; of the pictures as they are "
         << rounded(tuned.plain_value) << ".\n\n[\"" << Described<LocalEnhancementParams>::group << "\"]\n"
         << "enhance_a = " << rounded(tuned.params.enhance_a) << "\nenhance_b = " << rounded(tuned.params.enhance_b)
         << "\nenhance_c = " << rounded(tuned.params.enhance_c) << "\nenhance_k = " << rounded(tuned.params.enhance_k)
         << "\n";
    return text.str();
}

ExitCode tuneEnhancementTo(const TuneEnhancementArguments& arguments) {
    const auto source = openSimulation(arguments.scenario, arguments.seed);
    if (!source) return fail(ExitCode::Usage, source.error());
    cv::setNumThreads(1);
    catchInterrupts();
    const std::vector<FanImage> pictures = sweepPictures(**source, arguments.pictures);
    if (pictures.empty()) return fail(ExitCode::Failed, arguments.scenario + ": no sweep is finished in it");
    const bool terminal = isatty(STDERR_FILENO) == 1;
    const auto tell = [&](double done) {
        if (terminal) std::fprintf(stderr, "\r\033[K%.0f %% done", 100.0 * done);
    };
    const TunedEnhancement tuned = tuneEnhancement(pictures, arguments.objective, arguments.seed, tell, isInterrupted);
    if (terminal) std::fputs("\r\033[K", stderr);
    if (isInterrupted()) return fail(ExitCode::Failed, "interrupted: nothing is written");
    const std::string text = fileText(arguments, (*source)->scenario().name, tuned);
    errno = 0;
    std::ofstream file;
    if (arguments.out != "-") file.open(arguments.out);
    std::ostream& out = arguments.out == "-" ? std::cout : file;
    out << text << std::flush;
    if (!out) return fail(ExitCode::Failed, "cannot write " + arguments.out + ": " + std::strerror(errno));
    return ExitCode::Done;
}

}  // namespace

Command addTuneEnhancementCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "tune-enhancement", "Tune the local enhancement to a scenario, as the published method does once");
    auto a = std::make_shared<TuneEnhancementArguments>();
    command->add_option("SCENARIO", a->scenario, "A built-in scenario")->required();
    command
        ->add_option_function<std::string>(
            "--objective",
            [a](const std::string& name) {
                a->objective = name == "guarded" ? EnhancementObjective::Guarded : EnhancementObjective::Published;
            },
            "published: edges, their strength and entropy, which rewards speckle; guarded: the same held against "
            "speckle (default published)")
        ->check(CLI::IsMember({"published", "guarded"}));
    command->add_option("--seed", a->seed, "Seed of the scenario and of the swarm (default 1000)");
    command->add_option("--pictures", a->pictures, "Sweeps it is tuned to, evenly through the scenario (default 3)")
        ->check(CLI::Range(1, 100));
    command->add_option("--out", a->out, "TOML file of the parameters; - is standard output (default)");
    return [a] { return tuneEnhancementTo(*a); };
}

}  // namespace echotrail
