#pragma once

#include "ui/alerts/alert_book.hpp"

namespace echotrail {

/// Appends what became of alerts to a text file, a line each:
/// "2026-03-01T14:03:13.000Z raised alarm track_lost/3: T03 lost. Last 36.8 m 350.4°R".
/// A file that has grown to `most_bytes` is kept as NAME.1, in place of the one before.
class AlertLog {
public:
    static constexpr qint64 most_bytes = 4'000'000;

    explicit AlertLog(QString path) : path_(std::move(path)) {}
    /// False where it could not be written.
    bool write(const std::vector<AlertChange>& changes) const;
    const QString& path() const { return path_; }

private:
    QString path_;
};

/// Of this user: $XDG_DATA_HOME/echotrail/alerts.log.
QString alertLogPath();

}  // namespace echotrail
