#include "commands.hpp"
#include "core/recording/ping_log.hpp"
#include "core/recording/recording.hpp"
#include "core/runtime/denormals.hpp"
#include "recorded_run.hpp"
#include "sources.hpp"
#include "tracks_writer.hpp"

#include <CLI/CLI.hpp>
#include <opencv2/core/utility.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <ostream>

namespace echotrail {

namespace {

struct ConvertArguments {
    std::string in, out, what = "tracks";
};

Result<void> exportTracks(PingSource& source, const std::string& out) {
    auto settings = RecordedRunSettings::of(source, {});
    if (!settings) return Error{settings.error()};
    auto writer = TracksWriter::open(out, TracksFormat::Csv);
    if (!writer) return Error{writer.error()};
    (*writer)->setFirstPing(source.info().start);
    ScanningSonarPipeline pipeline(settings->params(), settings->seed());
    pipeline.setFanPainting(false);
    while (const auto ping = source.next()) {
        settings->apply(source.takeControls(), pipeline);
        const Update& update = pipeline.process(*ping, source.navigation());
        if (auto written = (*writer)->add(update, pipeline.settledUntil()); !written) return written;
    }
    if (auto written = (*writer)->add(pipeline.finish(), Timestamp::max()); !written) return written;
    return (*writer)->finish({});
}

/// A line for every ping; the levels (0…255 for 0…80 dB, nearest first) as two hexadecimal digits a bin.
void writePings(PingSource& source, std::ostream& out) {
    out << "sequence,time,t,bearing_deg,step_deg,range_scale_m,bin_size_m,frequency_hz,gain_percent,bins,levels_hex\n"
        << std::setprecision(10);
    constexpr char digits[] = "0123456789abcdef";
    while (const auto ping = source.next()) {
        std::string levels;
        for (const std::uint8_t level : ping->levels) levels += {digits[level >> 4], digits[level & 15]};
        out << ping->sequence << ',' << toIso8601(ping->time) << ',' << secondsBetween(source.info().start, ping->time)
            << ',' << ping->bearing.inDegrees() << ',' << degreesFromRadians(ping->step_rad) << ','
            << ping->range_scale_m << ',' << ping->binSize() << ',' << ping->frequency_hz << ',' << ping->gain_percent
            << ',' << ping->levels.size() << ',' << levels << '\n';
    }
}

Result<void> exportPings(PingSource& source, const std::string& out) {
    errno = 0;
    std::ofstream file(out);
    if (!file) return Error{"cannot write " + out + ": " + std::strerror(errno)};
    writePings(source, file);
    file.close();
    if (!file) return Error{"cannot write " + out + ": it takes no more"};
    return {};
}

Result<void> importLog(PingSource& source, const std::string& out) {
    ScanningSonarPipeline::Params params;
    params.head.sound_speed = source.info().sound_speed_mps;
    params.head.range_m = source.info().range_scale_m;
    const LogHeader header{ECHOTRAIL_VERSION, source.info().head + ", from " + source.info().name,
                           parameterText(params), 0, source.info().start};
    const auto pings = writePingLog(out, header, source);
    if (!pings) return Error{pings.error()};
    return {};
}

ExitCode convert(const ConvertArguments& arguments) {
    const bool to_csv = arguments.out.ends_with(".csv"), to_log = arguments.out.ends_with(log_format::suffix);
    if (!to_csv && !to_log)
        return fail(ExitCode::Usage, arguments.out + ": tracks and pings are written to .csv, imports to .echotrail");
    const auto address = parseSourceAddress(arguments.in);
    if (!address) return fail(ExitCode::Usage, address.error());
    const auto source = openSource(*address, {});
    if (!source) return fail(ExitCode::Failed, source.error());
    if (to_log && (*source)->recordedRun())
        return fail(ExitCode::Usage, arguments.in + " is an Echotrail log already; copy it");
    cv::setNumThreads(1);
    flushDenormals();
    const auto done = to_log                      ? importLog(**source, arguments.out)
                      : arguments.what == "pings" ? exportPings(**source, arguments.out)
                                                  : exportTracks(**source, arguments.out);
    if (!done) return fail(ExitCode::Failed, done.error());
    const SourceCounts counts = (*source)->counts();
    if (counts.lost_records == 0) return ExitCode::Done;
    return fail(ExitCode::Lossy, arguments.in + ": records lost: " + std::to_string(counts.lost_records));
}

}  // namespace

Command addConvertCommand(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("convert", "Tracks or pings to CSV; .V4LOG and .bin to an Echotrail log");
    auto a = std::make_shared<ConvertArguments>();
    command->add_option("IN", a->in, "Recording, or simulation://NAME?seed=N")->required();
    command->add_option("OUT", a->out, "File to write: .csv or .echotrail")->required();
    command->add_option("--what", a->what, "What goes into a .csv: tracks or pings (default tracks)")
        ->check(CLI::IsMember({"tracks", "pings"}));
    return [a] { return convert(*a); };
}

}  // namespace echotrail
