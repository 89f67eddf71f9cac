#include "commands.hpp"
#include "core/recording/log_recovery.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

namespace echotrail {

namespace {

ExitCode recoverLog(const std::string& in, const std::string& out) {
    const auto counts = recover(in, out);
    if (!counts) return fail(ExitCode::Failed, counts.error());
    std::cout << "recovered " << counts->events << " events and " << counts->results << " results from "
              << counts->parts << (counts->parts == 1 ? " part" : " parts") << " into " << out << std::endl;
    if (counts->whole()) return ExitCode::Done;
    std::string reason = in + ": ";
    if (counts->was_readable)
        reason += "some rows of it were damaged";
    else
        reason += counts->cut ? "it was cut; what followed is gone" : "it was damaged";
    if (counts->missing_events > 0) reason += "; events missing in between: " + std::to_string(counts->missing_events);
    if (!counts->header_found) reason += "; its header is gone: seed and parameters are the defaults";
    return fail(ExitCode::Lossy, reason);
}

}  // namespace

Command addRecoverCommand(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("recover", "Save all that is whole in a damaged recording of our own to a new one");
    auto paths = std::make_shared<std::pair<std::string, std::string>>();
    command->add_option("LOG", paths->first, "Damaged recording (.echotrail); it is not changed")->required();
    command->add_option("OUT", paths->second, "New recording")->required();
    return [paths] { return recoverLog(paths->first, paths->second); };
}

}  // namespace echotrail
