#pragma once

#include "core/base/result.hpp"
#include "core/data/update.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

namespace echotrail {

/// What the numbers of a tracks file count from: the first ping, and where the vehicle was then. Navigation may have
/// begun elsewhere.
struct TracksOrigin {
    Timestamp first_ping{};
    double north_m = 0.0;
    double east_m = 0.0;
};

/// Writes tracks as JSON Lines, the summary last. A look is known only when the beam has left its place, so looks come
/// a little out of order; lines are held back for as long as the last sweep took, and are written in order of time.
/// Order: add() for every update in turn, then finish() once.
class TracksWriter {
public:
    /// `path` is a file, or "-" for standard output. The error says why it cannot be written.
    static Result<std::unique_ptr<TracksWriter>> open(const std::string& path, const TracksOrigin& origin);

    /// Takes in the looks of an update; fails when the medium takes no more.
    Result<void> add(const Update& update);
    Result<void> finish(const nlohmann::ordered_json& summary);
    /// Looks that came later than a line already written, and had to be left out.
    std::uint64_t lateLooks() const { return late_; }

private:
    TracksWriter(std::string path, const TracksOrigin& origin) : path_(std::move(path)), origin_(origin) {}
    Result<void> writeUntil(Timestamp time);

    std::string path_;
    std::ofstream file_;
    std::ostream* out_ = nullptr;
    TracksOrigin origin_;
    std::multimap<Timestamp, TrackLook> held_;
    std::optional<Timestamp> sweep_start_, written_until_;
    std::optional<Microseconds> sweep_duration_;
    std::uint64_t late_ = 0;
};

/// A line of the tracks file: the fields' names are fixed, other programs read them.
nlohmann::ordered_json trackLine(const TrackLook& look, const TracksOrigin& origin);

}  // namespace echotrail
