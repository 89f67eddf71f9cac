#pragma once

#include "core/base/result.hpp"
#include "core/data/head_settings.hpp"
#include "core/runtime/live_runner.hpp"
#include "core/seanet/head_session.hpp"

#include <QList>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

namespace echotrail {

/// What the operator asks for when connecting.
struct LiveRequest {
    QString sonar;       ///< address, e.g. "serial:///dev/ttyUSB0?baud=115200"
    QString navigation;  ///< address of NMEA 0183; empty: none
    bool record = true;
    LiveRunner::Params params;
    std::uint64_t seed = 0;
};

/// One link of a live source, for a person to read.
struct LiveLink {
    bool up = false;
    QString reason;               ///< why it is down, one line; empty while it is up or was never tried
    std::optional<double> age_s;  ///< since the last bytes; none before the first
};

/// A copy of a recording aboard that is made here, as far as it has come.
struct RecordingCopy {
    QString name;   ///< aboard; empty before the tracker has said it
    QString path;   ///< here; empty: none yet
    QString error;  ///< why it has ended, one line
    qint64 rows = 0, there = 0;
    qint64 missed = 0;       ///< rows of while the link was down that are not here yet
    quint64 bytes = 0;       ///< that came
    quint64 free_bytes = 0;  ///< on the disk; 0: not known yet
    bool asking = false;     ///< else the link is down, or it has ended
    bool whole = false;
};

/// A recording that lies aboard.
struct RecordingAboard {
    QString name;
    quint64 bytes = 0;
    Timestamp changed{};
    bool written = false;  ///< by the tracker, now
    bool operator==(const RecordingAboard&) const = default;
};

/// A tracker far away, where the live source is one.
struct TrackerState {
    LiveLink link;
    QString name;                          ///< of the vehicle; empty before it has said so
    std::optional<double> latency_s;       ///< of the last echo line, from its transmission to this console
    std::optional<double> round_trip_s;    ///< of the link
    double report_age_s = 0.0;             ///< of what it last said of head, navigation and log, once a second
    quint64 messages = 0;                  ///< that came
    quint64 gaps = 0;                      ///< messages that did not come
    bool holds_control = false;            ///< this console does
    bool asks_control = false;             ///< this console does
    QString holder, asking;                ///< names of consoles; empty: nobody
    std::optional<RecordingCopy> record;   ///< of the run, kept here; none where it is not
    std::optional<RecordingCopy> fetched;  ///< the recording that is fetched, or was the last
    QList<RecordingAboard> recordings;     ///< as last listed, the newest first
    QString recordings_error;              ///< why they could not be listed
};

/// What one can do about control of a far tracker.
enum class TrackerControl { Ask, Give, Keep, Take };

/// Something the operator should read.
struct LiveNotice {
    QString text;
    bool ok = true;
};

/// A live source at a glance.
struct LiveState {
    LiveLink sonar;
    std::optional<LiveLink> navigation;  ///< none where none was asked for
    seanet::HeadStatus head;
    LiveStatus run;
    std::optional<double> ping_age_s;     ///< none before the first ping
    std::optional<double> heading_age_s;  ///< none before the first heading
    std::optional<TrackerState> tracker;  ///< only of a tracker far away
};

/// A head that is polled, seen from the window: whoever makes it moves the bytes. Calls return at once; scenes and
/// states are fetched at the display's pace. Destruction ends the links and closes the log.
class LiveSource {
public:
    virtual ~LiveSource() = default;

    /// Once, first: opens the links, which no one else may hold then.
    virtual void start() = 0;
    virtual std::optional<Scene> takeScene() = 0;
    /// The run so far, where there is more of it than at the last call.
    virtual std::optional<Timeline> takeTimeline() { return std::nullopt; }
    virtual LiveState state() const = 0;
    /// The head's settings among them are told to the head.
    virtual void setParams(const LiveRunner::Params& params) = 0;
    virtual void designate(double range_m, Bearing from_bow) = 0;
    virtual void clearDesignation() = 0;
    /// Nobody is told of this track any more, which is at this place; restore() takes it back.
    virtual void drop(int track, double range_m, Bearing from_bow) = 0;
    virtual void restore(int track) = 0;
    /// The parameters in force, where someone else has changed them or they were not taken.
    virtual std::optional<LiveRunner::Params> takeParams() { return std::nullopt; }
    virtual std::optional<LiveNotice> takeNotice() { return std::nullopt; }
    virtual void control(TrackerControl) {}
    /// Of the recordings that lie aboard; the state tells what has come.
    virtual void listRecordings() {}
    virtual void fetchRecording(const QString& /*name*/) {}
    virtual void cancelFetch() {}
    /// Scenes carry the locally enhanced picture too.
    virtual void setEnhanced(bool on) = 0;
};

/// Makes a live run, not started; the error, one line, says what is wrong with the request. A head that is not there is
/// no error: the links keep trying, and the state says so.
using LiveOpener = std::function<Result<std::unique_ptr<LiveSource>>(const LiveRequest&)>;

/// A head that is simulated in this program.
struct SimulatedHeadChoice {
    QString title, address, description;
};

/// The same of a tracker far away; with `record` a copy of its run is kept here.
using TrackerOpener = std::function<Result<std::unique_ptr<LiveSource>>(const QString& address, bool record)>;

/// How a window reaches live sources; a program without links leaves it empty.
struct LiveAccess {
    LiveOpener open;
    std::function<QStringList()> ports;  ///< addresses of this computer's serial ports, now
    QList<SimulatedHeadChoice> simulated_heads;
    TrackerOpener open_tracker;
    QString recordings;  ///< the folder that live runs are recorded in
};

}  // namespace echotrail
