#include "app/io/byte_server.hpp"
#include "app/io/simulated_device.hpp"
#include "commands.hpp"
#include "core/evaluation/pursuit.hpp"
#include "core/recording/ping_log.hpp"
#include "core/runtime/denormals.hpp"
#include "core/simulation/demonstration.hpp"
#include "core/simulation/ping_model.hpp"
#include "core/simulation/truth_file.hpp"
#include "event_loop.hpp"
#include "pursuit_outcome.hpp"
#include "settings.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>

#include <QCoreApplication>
#include <QTimer>
#include <cstring>
#include <fstream>
#include <iostream>

namespace echotrail {

namespace {

constexpr int record_interval_ms = 1000;

struct SimulateArguments {
    std::string scenario, log, truth, serve_sonar, serve_navigation, follow_report;
    PursuitFiles pursuit;
    std::vector<std::string> head_settings, faults, vehicle_settings, settings;
    std::uint64_t seed = default_scenario_seed;
    double duration_s = 0.0;
    bool list = false, pursue = false;
};

ExitCode list() {
    for (const Scenario& scenario : scenarios()) std::cout << scenario.name << "\t" << scenario.description << "\n";
    return ExitCode::Done;
}

Result<void> writeTruth(const std::string& path, const SimulatedSource& source) {
    errno = 0;
    std::ofstream file(path);
    file << truthCsv(source);
    file.close();
    if (!file) return Error{"cannot write " + path + ": " + std::strerror(errno)};
    return {};
}

/// The scenario as a recording, at once.
ExitCode writeLog(const SimulateArguments& arguments, SimulatedSource& source) {
    const LogHeader header{ECHOTRAIL_VERSION, "simulated: " + source.scenario().name,
                           parameterText(ScanningSonarPipeline::Params{}), 0, simulation_start};
    std::optional<Timestamp> end;
    if (arguments.duration_s > 0.0) end = source.info().start + microsecondsFromSeconds(arguments.duration_s);
    std::vector<std::pair<Timestamp, std::string>> navigation;
    NmeaOutput nmea(source.scenario(), arguments.seed, source.info().start);
    const Microseconds duration = end.value_or(source.info().end) - source.info().start;
    for (NmeaOutput::Said& said : nmea.take(duration + Microseconds(1'000'000)))
        navigation.emplace_back(source.info().start + said.at, std::move(said.text));
    const auto pings = writePingLog(arguments.log, header, source, end, navigation);
    if (!pings) return fail(ExitCode::Failed, pings.error());
    std::cout << nlohmann::ordered_json{{"scenario", source.scenario().name},
                                        {"seed", arguments.seed},
                                        {"log", arguments.log},
                                        {"pings", *pings}}
                     .dump()
              << std::endl;
    return ExitCode::Done;
}

template <class Params>
Result<void> setAll(Params& params, const std::vector<std::string>& assignments) {
    for (const std::string& assignment : assignments)
        if (auto set = setParameterFromText(params, assignment); !set) return set;
    return {};
}

Result<std::unique_ptr<ByteServer>> serverAt(const std::optional<LinkAddress>& address) {
    if (!address) return std::unique_ptr<ByteServer>();
    return ByteServer::listen(*address);
}

Result<PursuitParams> pursuitOf(const SimulateArguments& arguments, const Scenario& scenario) {
    PursuitParams pursuit;
    if (const auto set = setAll(pursuit, arguments.vehicle_settings); !set) return Error{set.error()};
    if (scenario.targets.empty()) return Error{"in " + scenario.name + " there is no target to follow"};
    return pursuit;
}

std::string pursuitTitle(const Scenario& scenario, std::uint64_t seed) {
    return scenario.name + ", seed " + std::to_string(seed) + ": a vehicle fed only by reports follows the target";
}

void sample(SimulatedDevice& device, PursuitRecord& record) {
    const PursuingVehicle* vehicle = device.pursuer();
    if (const auto time_s = device.scenarioTime()) record.take(device.scenario(), *time_s, vehicle->validReports() > 0);
}

/// Acts as a head, and its vehicle's navigation, until it is told to end.
ExitCode serve(const SimulateArguments& arguments, const Scenario& scenario) {
    SimulatedDevice::Setup setup{scenario, arguments.seed, {}, {}, {}};
    if (const auto set = setAll(setup.head, arguments.head_settings); !set) return fail(ExitCode::Usage, set.error());
    if (const auto set = setAll(setup.faults, arguments.faults); !set) return fail(ExitCode::Usage, set.error());
    if (!arguments.follow_report.empty()) {
        const auto pursuit = pursuitOf(arguments, scenario);
        if (!pursuit) return fail(ExitCode::Usage, pursuit.error());
        setup.pursuit = *pursuit;
    }
    const auto report_address = parseLinkOption("--follow-report", arguments.follow_report);
    if (!report_address) return fail(ExitCode::Usage, report_address.error());
    const auto sonar_address = parseLinkOption("--serve-sonar", arguments.serve_sonar);
    if (!sonar_address) return fail(ExitCode::Usage, sonar_address.error());
    const auto navigation_address = parseLinkOption("--serve-navigation", arguments.serve_navigation);
    if (!navigation_address) return fail(ExitCode::Usage, navigation_address.error());
    if (*navigation_address && (*navigation_address)->kind == LinkAddress::Kind::Udp)
        return fail(ExitCode::Usage,
                    "--serve-navigation: who listens to navigation never speaks, so that with UDP nobody "
                    "knows where to send it; say tcp://ADDR:PORT or pty");
    int argc = 1;
    char name[] = "echotrail";
    char* argv[] = {name, nullptr};
    const QCoreApplication application(argc, argv);
    auto sonar = serverAt(*sonar_address);
    if (!sonar) return fail(ExitCode::Failed, sonar.error());
    auto navigation = serverAt(*navigation_address);
    if (!navigation) return fail(ExitCode::Failed, navigation.error());
    auto reports = serverAt(*report_address);
    if (!reports) return fail(ExitCode::Failed, reports.error());
    nlohmann::ordered_json told{{"scenario", scenario.name}, {"seed", arguments.seed}, {"sonar", (*sonar)->address()}};
    if (*navigation) told["navigation"] = (*navigation)->address();
    if (*reports) told["reports"] = (*reports)->address();
    std::cout << told.dump() << std::endl;
    SimulatedDevice device(setup);
    ByteServer& line = **sonar;
    QObject::connect(&line, &ByteServer::received, &device, &SimulatedDevice::receive);
    QObject::connect(&device, &SimulatedDevice::sonarSaid, &line, &ByteServer::send);
    QObject::connect(&device, &SimulatedDevice::linkBroke, &line, &ByteServer::drop);
    if (*navigation) QObject::connect(&device, &SimulatedDevice::navigationSaid, navigation->get(), &ByteServer::send);
    std::optional<PursuitRecord> record;
    QTimer sampling;
    if (*reports) {
        QObject::connect(reports->get(), &ByteServer::received, &device, &SimulatedDevice::receiveReports);
        record.emplace(setup.pursuit->keep_range_m);
        QObject::connect(&sampling, &QTimer::timeout, &device, [&] { sample(device, *record); });
        sampling.start(record_interval_ms);
    }
    device.start();
    runEventLoop(arguments.duration_s > 0.0 ? std::optional(arguments.duration_s) : std::nullopt);
    nlohmann::ordered_json ended{
        {"transmissions", device.transmissions()}, {"ignored", device.ignored()}, {"faults", device.faults()}};
    if (record) {
        sample(device, *record);
        ended["valid_reports"] = device.pursuer()->validReports();
        ended["bad_reports"] = device.badReports();
        ended["pursuit"] = pursuitFigures(*record);
    }
    std::cout << ended.dump() << std::endl;
    if (!record) return ExitCode::Done;
    const auto written = writePursuit(arguments.pursuit, *record, pursuitTitle(scenario, arguments.seed));
    return written ? ExitCode::Done : fail(ExitCode::Failed, written.error());
}

/// The whole loop of a trial in this process, at once.
ExitCode pursue(const SimulateArguments& arguments, Scenario scenario) {
    const auto pursuit = pursuitOf(arguments, scenario);
    if (!pursuit) return fail(ExitCode::Usage, pursuit.error());
    const auto settings = readSettings({}, arguments.settings);
    if (!settings) return fail(ExitCode::Usage, settings.error());
    if (arguments.duration_s > 0.0) scenario.duration_s = arguments.duration_s;
    cv::setNumThreads(1);
    flushDenormals();
    catchInterrupts();
    const PursuitResult result =
        runPursuit(scenario, settings->params, *pursuit, arguments.seed, [] { return isInterrupted(); });
    const auto& samples = result.record.samples();
    const double data_s = samples.empty() ? 0.0 : samples.back().time_s;
    const double looks_per_s = data_s > 0.0 ? static_cast<double>(result.looks) / data_s : 0.0;
    std::cout << nlohmann::ordered_json{{"scenario", scenario.name},
                                        {"seed", arguments.seed},
                                        {"data_seconds", data_s},
                                        {"pings", result.pings},
                                        {"looks_per_s", looks_per_s},
                                        {"reports", result.reports},
                                        {"valid_reports", result.valid},
                                        {"picks", result.picks},
                                        {"pursuit", pursuitFigures(result.record)}}
                     .dump()
              << std::endl;
    const auto written = writePursuit(arguments.pursuit, result.record, pursuitTitle(scenario, arguments.seed));
    return written ? ExitCode::Done : fail(ExitCode::Failed, written.error());
}

/// What was given and would have no effect.
std::string idleOption(const SimulateArguments& arguments) {
    const bool follows = arguments.pursue || !arguments.follow_report.empty();
    if (arguments.pursue && !arguments.serve_sonar.empty()) return "--pursue has its own head: leave --serve-sonar out";
    if (!arguments.settings.empty() && !arguments.pursue) return "--set is for the tracker of --pursue";
    if (!follows && !arguments.vehicle_settings.empty()) return "--vehicle is for --pursue or --follow-report";
    if (!follows && !arguments.pursuit.paths.empty()) return "--paths is for --pursue or --follow-report";
    if (!follows && !arguments.pursuit.picture.empty()) return "--picture is for --pursue or --follow-report";
    return {};
}

ExitCode simulate(const SimulateArguments& arguments) {
    if (arguments.list) return list();
    if (arguments.scenario.empty())
        return fail(ExitCode::Usage, "name a scenario; echotrail simulate --list shows them all");
    if (arguments.log.empty() && arguments.serve_sonar.empty() && arguments.truth.empty() && !arguments.pursue)
        return fail(ExitCode::Usage, "nothing to do: give --log LOG, --truth FILE, --serve-sonar ADDRESS or --pursue");
    if (!arguments.follow_report.empty() && arguments.serve_sonar.empty())
        return fail(ExitCode::Usage, "--follow-report: the vehicle carries the head of --serve-sonar; give both");
    if (const std::string idle = idleOption(arguments); !idle.empty()) return fail(ExitCode::Usage, idle);
    const auto source = openSimulation(arguments.scenario, arguments.seed);
    if (!source) return fail(ExitCode::Usage, source.error());
    if (!arguments.truth.empty())
        if (const auto written = writeTruth(arguments.truth, **source); !written)
            return fail(ExitCode::Failed, written.error());
    if (!arguments.log.empty())
        if (const ExitCode code = writeLog(arguments, **source); code != ExitCode::Done) return code;
    if (arguments.pursue) return pursue(arguments, (*source)->scenario());
    return arguments.serve_sonar.empty() ? ExitCode::Done : serve(arguments, (*source)->scenario());
}

}  // namespace

Command addSimulateCommand(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("simulate", "A scenario as a recording with truth, or as a head on a port");
    auto a = std::make_shared<SimulateArguments>();
    command->add_option("SCENARIO", a->scenario, "Name of a built-in scenario");
    command->add_flag("--list", a->list, "Name the scenarios and what is in them");
    command->add_option("--seed", a->seed, "Seed of the random numbers (default 1)");
    command->add_option("--duration", a->duration_s, "Seconds: of the recording, or until the head on a port ends")
        ->check(CLI::PositiveNumber);
    command->add_option("--log", a->log, "Write the scenario as a recording (.echotrail), faster than real time");
    command->add_option("--truth", a->truth,
                        "Write where the targets truly are (CSV), in seconds since the first ping");
    command->add_option("--serve-sonar", a->serve_sonar,
                        "Act as a head on tcp://ADDR:PORT, udp://ADDR:PORT or pty; port 0 is any free one");
    command->add_option("--head", a->head_settings, "NAME=VALUE of the simulated head, as in head_model=dfs");
    command->add_option("--serve-navigation", a->serve_navigation,
                        "Say the vehicle's navigation (NMEA 0183) on tcp://ADDR:PORT or pty");
    command->add_option("--follow-report", a->follow_report,
                        "The vehicle follows the target by the reports that come to udp://ADDR:PORT or tcp://ADDR:PORT "
                        "(`track --report`), and by nothing else; how well it keeps its range is told at the end");
    command->add_flag("--pursue", a->pursue,
                      "The same in one process, as fast as the machine can: head, tracker and vehicle");
    command->add_option("--set", a->settings, "With --pursue: NAME=VALUE of the tracker, as in follow_target=true");
    command->add_option("--vehicle", a->vehicle_settings, "NAME=VALUE of the vehicle, as in keep_range_m=15");
    command->add_option("--paths", a->pursuit.paths, "Write both paths (CSV)");
    command->add_option("--picture", a->pursuit.picture, "Draw both paths and the range over time (SVG)");
    command->add_option("--fault", a->faults, "NAME=VALUE of a fault of the link to the head, as in lost_bytes=0.001");
    command->footer([] {
        return "\n" + parameterHelp("For --head NAME=VALUE", describeParameters<SimulatedHeadOptions>()) + "\n" +
               parameterHelp("For --fault NAME=VALUE", describeParameters<LinkFaultParams>()) + "\n" +
               parameterHelp("For --vehicle NAME=VALUE", describeParameters<PursuitParams>());
    });
    return [a] { return simulate(*a); };
}

}  // namespace echotrail
