#include "core/recording/recording.hpp"

#include "core/recording/byte_dump.hpp"
#include "core/recording/echotrail_log.hpp"
#include "core/recording/v4log.hpp"

#include <filesystem>
#include <fstream>

namespace echotrail {

Result<std::unique_ptr<PingSource>> openRecording(const std::string& path, const RecordingOptions& options) {
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status)) return Error{"cannot open " + path + ": there is no such file"};
    if (std::filesystem::is_directory(status))
        return Error{"cannot open " + path + ": it is a folder, not a recording"};
    if (!std::filesystem::is_regular_file(status))  // to open a pipe would wait for its writer
        return Error{"cannot open " + path + ": it is not a file but a pipe or a device"};
    std::ifstream file(path, std::ios::binary);
    if (!file) return Error{"cannot open " + path + ": it cannot be read; check its permissions"};
    constexpr std::size_t looked_at = 100;  // SQLite's file header
    std::string start(looked_at, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (file.gcount() == 0) return Error{"cannot open " + path + ": the file is empty"};
    if (LogReader::isLog(start)) {
        auto log = EchotrailLog::open(path, options);
        if (!log) return Error{log.error()};
        return std::unique_ptr<PingSource>(*std::move(log));
    }
    std::unique_ptr<PingSource> source;
    if (start.starts_with(V4Log::magic))
        source = std::make_unique<V4Log>(path, std::move(file), options);
    else
        source = std::make_unique<ByteDump>(path, std::move(file), options);
    if (source->info().pings == 0)
        return Error{
            "cannot open " + path +
            ": no sonar ping in it; an .echotrail log, a Seanet Pro .V4LOG or a raw Seanet byte stream is needed"};
    return source;
}

}  // namespace echotrail
