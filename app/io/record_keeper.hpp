#pragma once

#include "core/link/link_values.hpp"
#include "core/recording/log_fetch.hpp"

#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace echotrail {

/// How far a copy of a recording aboard has come, for a person to read.
struct KeptRecording {
    std::string name;  ///< aboard; empty before the tracker has said it
    std::string path;  ///< of the copy; empty: none yet
    LogFetch::Progress rows;
    std::uint64_t bytes = 0;  ///< payload that came since it was begun or taken up again
    std::uint64_t free_bytes = 0;
    bool asking = false;  ///< the link is there, and rows are asked for
    bool whole = false;   ///< all that there is, is here
    std::string error;    ///< why it has ended: one line
};

/// Keeps a copy of a recording aboard: says what to ask for next, writes what comes, and goes on after a break with
/// what is missing. One request is under way at a time, no larger than what comes within half a second beyond the way's
/// own delay: so much, and no more, may be in front of a track. Threads: state() from any; all else in the one it lives
/// in, whose event loop runs.
class RecordKeeper : public QObject {
    Q_OBJECT
public:
    /// `recording` is a name of the tracker's list, which is fetched until it is whole; empty: the one being written,
    /// which is followed. `folder` is made.
    RecordKeeper(std::string folder, std::string recording);
    ~RecordKeeper() override;

    KeptRecording state() const;

    void linkUp(const std::string& tracker);
    void linkDown();
    void takeRecording(const LinkRecording& recording);
    /// `beyond`: how long the answer took, less the way there and back.
    void takeRows(const LinkRows& rows, Microseconds beyond);
    void takeRefusal(const std::string& reason);
    /// The copy is closed; what is missing stays missing.
    void close();

Q_SIGNALS:
    void wantsDescription(const std::string& name);
    void wantsRows(const LinkReadRows& wanted);
    /// Another run is written aboard now: of this one something may be missing, which is in the recording of that name.
    void leftBehind(const std::string& name);
    /// Whole, or it cannot be.
    void finished();

private:
    Result<void> begin(const LinkRecording& recording);
    Result<std::string> findPlace(const LogHeader& header);
    void askNext();
    void commit();
    void fail(const std::string& reason);
    void publish(bool asking);
    bool follows() const { return recording_.empty(); }

    const std::string folder_, recording_;
    std::string tracker_, name_;
    LogHeader header_;
    std::unique_ptr<QLockFile> lock_;
    std::optional<LogFetch> fetch_;
    std::optional<LogRowsWanted> asked_;
    std::size_t batch_;
    bool up_ = false, failed_ = false;
    QTimer commit_, look_;
    mutable std::mutex mutex_;
    KeptRecording published_;
};

}  // namespace echotrail
