#include "event_loop.hpp"

#include <QCoreApplication>
#include <QTimer>
#include <chrono>

namespace echotrail {
namespace {

constexpr int look_interval_ms = 50;

}  // namespace

const char* runEventLoop(std::optional<double> duration_s) {
    catchInterrupts();
    const auto begun = std::chrono::steady_clock::now();
    const char* reason = "";
    QTimer look;  // a signal handler may do no more than set a flag
    QObject::connect(&look, &QTimer::timeout, [&] {
        const double passed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        if (isInterrupted())
            reason = "interrupted";
        else if (duration_s && passed_s >= *duration_s)
            reason = "duration reached";
        else
            return;
        QCoreApplication::quit();
    });
    look.start(look_interval_ms);
    QCoreApplication::exec();
    return reason;
}

}  // namespace echotrail
