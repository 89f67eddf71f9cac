#include "pursuit_outcome.hpp"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>

namespace echotrail {

namespace {

Result<void> write(const std::string& path, const std::string& text) {
    if (path.empty()) return {};
    errno = 0;
    std::ofstream file(path);
    file << text;
    file.close();
    if (!file) return Error{"cannot write " + path + ": " + std::strerror(errno)};
    return {};
}

double millimetres(double metres) { return std::round(metres * 1e3) / 1e3; }

}  // namespace

Result<void> writePursuit(const PursuitFiles& files, const PursuitRecord& record, const std::string& title) {
    if (auto written = write(files.paths, record.csv()); !written) return written;
    return write(files.picture, record.svg(title));
}

nlohmann::ordered_json pursuitFigures(const PursuitRecord& record) {
    const auto told = [](const std::optional<PursuitRecord::Figures>& figures) -> nlohmann::ordered_json {
        if (!figures) return nullptr;
        return {{"seconds", millimetres(figures->seconds)},
                {"range_error_mean_m", millimetres(figures->mean_m)},
                {"range_error_p95_m", millimetres(figures->percentile_95_m)},
                {"range_error_max_m", millimetres(figures->greatest_m)}};
    };
    auto figures = told(record.figures());
    if (!figures.is_null()) figures["since_reached"] = told(record.figuresSinceReached());
    return figures;
}

}  // namespace echotrail
