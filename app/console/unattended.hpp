#pragma once

#include "ui/main_window/main_window.hpp"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <limits>
#include <optional>
#include <vector>

namespace echotrail {

/// What the console does while nobody sits at it. Seconds of a recording are its own, from its first ping; else they
/// count from the start of the program.
struct Schedule {
    static constexpr double unsaid = std::numeric_limits<double>::infinity();

    struct Picture {
        QString path;
        double at_s = unsaid;  ///< unsaid: at the end of a recording, after a head's first sweep, else at once
    };
    std::vector<Picture> pictures;
    std::optional<double> exit_at_s;  ///< none: after the last picture; without one at the end of a recording
    QString dock;                     ///< brought to the front before the first picture; empty: as it is
};

/// Runs the window by a schedule and ends the program with one of the documented exit codes, a line on standard error
/// where it is not 0: 1 where a source or a picture failed, 3 where all was done but something of the source was lost,
/// or a moment asked for lies past its end.
/// A recording is not played but looked at in steps of its own time, so that one command always gives the same picture,
/// charts and alerts included, as fast as the machine can.
class Unattended : public QObject {
    Q_OBJECT

public:
    /// `has_source`: something is being opened or connected to.
    Unattended(MainWindow& window, Schedule schedule, bool has_source);

private:
    void turn();
    void followClock();
    void followRecording();
    bool restsAt(std::uint64_t position) const;
    bool isWhole(const Timeline& timeline) const;
    std::uint64_t positionOf(double at_s) const;
    std::uint64_t stepTowards(std::uint64_t goal) const;
    double nextMoment() const;
    bool isDue(const Schedule::Picture& picture) const;
    bool shoot();
    void conclude();
    QString losses() const;
    void fail(const QString& reason);

    MainWindow& window_;
    Schedule schedule_;  ///< without the pictures that are taken
    bool has_source_;
    bool past_end_ = false;
    std::optional<std::uint64_t> position_;  ///< of a recording: where it was sent last
    QElapsedTimer since_start_;
    QTimer timer_;
};

}  // namespace echotrail
