#pragma once

#include "ui/main_window/main_window.hpp"

#include <QObject>
#include <QString>
#include <optional>

namespace echotrail {

/// Takes one picture of the window, once the recording is open and replay rests at the moment asked for, and ends the
/// program: exit code 0, or 1 with a line on standard error. Of a head that is polled: after its first whole sweep, or
/// so many seconds after the connection was asked for.
class Screenshot : public QObject {
    Q_OBJECT

public:
    Screenshot(MainWindow& window, const QString& path, std::optional<double> at_s, bool has_source);

private:
    void follow(const ReplayStatus& status);
    void waitForSweep();
    void shoot();
    void fail(const QString& reason);

    MainWindow& window_;
    QString path_;
    std::optional<double> at_s_;
    bool sought_ = false;
    bool shot_ = false;
};

}  // namespace echotrail
