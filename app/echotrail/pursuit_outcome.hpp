#pragma once

#include "core/base/result.hpp"
#include "core/evaluation/pursuit_record.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace echotrail {

/// Where both paths of a pursuit are written; empty: nowhere.
struct PursuitFiles {
    std::string paths;    ///< CSV
    std::string picture;  ///< SVG
};
Result<void> writePursuit(const PursuitFiles& files, const PursuitRecord& record, const std::string& title);

/// "seconds", "range_error_mean_m", "range_error_p95_m", "range_error_max_m": how well the range was kept since the
/// vehicle first heard of its target, and in "since_reached" since it was first within a metre of it. Null where there
/// was no such time.
nlohmann::ordered_json pursuitFigures(const PursuitRecord& record);

}  // namespace echotrail
