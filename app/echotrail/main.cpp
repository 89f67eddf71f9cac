#include "commands.hpp"

#include <CLI/CLI.hpp>

#include <csignal>
#include <exception>
#include <map>
#include <string>

namespace {

using echotrail::ExitCode;

ExitCode runCommand(int argc, char** argv) {
    CLI::App program{"Echotrail without a screen: sonar recordings in, tracked targets out.", "echotrail"};
    program.set_version_flag("--version", ECHOTRAIL_VERSION);
    program.require_subcommand(1);
    const std::map<std::string, echotrail::Command> commands{
        {"track", echotrail::addTrackCommand(program)},       {"replay", echotrail::addReplayCommand(program)},
        {"simulate", echotrail::addSimulateCommand(program)}, {"verify", echotrail::addVerifyCommand(program)},
        {"convert", echotrail::addConvertCommand(program)},   {"recover", echotrail::addRecoverCommand(program)},
        {"evaluate", echotrail::addEvaluateCommand(program)}, {"info", echotrail::addInfoCommand(program)},
        {"pair", echotrail::addPairCommand(program)},         {"fetch", echotrail::addFetchCommand(program)},
        {"tune-enhancement", echotrail::addTuneEnhancementCommand(program)}};
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return static_cast<ExitCode>(program.exit(error));  // help was asked for
        return echotrail::fail(ExitCode::Usage, std::string(error.what()) + "; see echotrail --help");
    }
    return commands.at(program.get_subcommands().front()->get_name())();
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away is a failed write, and is told as one
    try {
        return static_cast<int>(runCommand(argc, argv));
    } catch (const std::exception& failure) {
        return static_cast<int>(echotrail::fail(ExitCode::Failed, failure.what()));
    }
}
