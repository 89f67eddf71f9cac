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

enum class TracksFormat { JsonLines, Csv };

/// Writes tracks as JSON Lines, the summary last, or as CSV with a header and no summary. A look is known only when the
/// beam has left its place, so looks come a little out of order; lines are held back until no earlier one can follow,
/// and are written in order of time. Order: add() for every update in turn, then finish() once.
class TracksWriter {
public:
    /// `path` is a file, or "-" for standard output. The error says why it cannot be written.
    static Result<std::unique_ptr<TracksWriter>> open(const std::string& path,
                                                      TracksFormat format = TracksFormat::JsonLines);
    /// What `t` counts from; needed before the first look.
    void setFirstPing(Timestamp time) { first_ping_ = time; }

    /// Takes in the looks of an update, after which none from before `settled` can follow; fails when the medium takes
    /// no more.
    Result<void> add(const Update& update, Timestamp settled);
    Result<void> finish(const nlohmann::ordered_json& summary);
    /// Looks that came later than a line already written, and had to be left out.
    std::uint64_t lateLooks() const { return late_; }

private:
    TracksWriter(std::string path, TracksFormat format) : path_(std::move(path)), format_(format) {}
    Result<void> writeUntil(Timestamp time);

    std::string path_;
    TracksFormat format_;
    std::ofstream file_;
    std::ostream* out_ = nullptr;
    Timestamp first_ping_{};
    std::multimap<Timestamp, TrackLook> held_;
    std::optional<Timestamp> written_until_;
    std::uint64_t late_ = 0;
};

}  // namespace echotrail
