#include "app/io/interrupts.hpp"
#include "console_options.hpp"
#include "libraries.hpp"
#include "live_connection.hpp"
#include "quiet_offscreen.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/message_strip.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "unattended.hpp"

#include <QApplication>
#include <QIcon>
#include <QSettings>
#include <QTimer>
#include <iostream>

namespace {

constexpr int interrupt_interval_ms = 100;

/// Whether there is anywhere to put a window. Qt would abort without saying what to do.
bool haveDisplay() {
    return !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
           !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

/// As soon as there is something to find the target in: before the first ping; a tracker is told when it first takes
/// orders from here.
void designateFirst(echotrail::PipelineBridge& bridge, std::pair<double, double> target) {
    auto* until_told = new QObject(&bridge);
    const auto designate = [&bridge, target, until_told] {
        bridge.designate(target.first, echotrail::radiansFromDegrees(target.second));
        until_told->deleteLater();
    };
    QObject::connect(&bridge, &echotrail::PipelineBridge::opened, until_told, [&bridge, designate] {
        if (!bridge.isTracker()) designate();
    });
    QObject::connect(&bridge, &echotrail::PipelineBridge::liveChanged, until_told,
                     [designate](const echotrail::LiveState& state) {
                         if (state.tracker && state.tracker->link.up && state.tracker->holds_control) designate();
                     });
}

}  // namespace

int main(int argc, char** argv) {
    using namespace echotrail;
    auto read = readConsoleOptions(argc, argv);
    if (const int* code = std::get_if<int>(&read)) return *code;
    const auto& options = std::get<ConsoleOptions>(read);
    const bool unattended = options.isUnattended();
    if (!unattended && !haveDisplay()) {
        std::cerr
            << "echotrail-console: there is no display; set DISPLAY, or say --headless, or use echotrail replay\n";
        return 1;
    }
    if (options.headless || !haveDisplay()) qputenv("QT_QPA_PLATFORM", "offscreen");
    if (qgetenv("QT_QPA_PLATFORM") == "offscreen") quietOffscreen();
    QApplication app(argc, argv);
    QApplication::setApplicationName("console");
    QApplication::setOrganizationName("echotrail");
    QApplication::setApplicationVersion(ECHOTRAIL_VERSION);
    QApplication::setDesktopFileName("echotrail-console");
    QApplication::setWindowIcon(QIcon(":/echotrail-console.png"));
    QApplication::setStyle("Fusion");
    QSettings::setDefaultFormat(QSettings::IniFormat);

    MainWindow window({.remember = !unattended,
                       .play_on_open = !unattended,
                       .language = QString::fromStdString(options.language),
                       .steady_alerts = unattended,
                       .live = liveAccess(),
                       .libraries = libraries()});
    if (!options.palette.empty()) window.setTheme(themeFromName(QString::fromStdString(options.palette)));
    window.bridge().setSeed(options.seed);
    window.setParams(options.params);
    window.bridge().setOverridesRecorded(options.params_given);
    if (options.width || options.height)
        window.resize(options.width.value_or(window.width()), options.height.value_or(window.height()));
    window.show();
    catchInterrupts();
    if (options.target) designateFirst(window.bridge(), *options.target);
    const bool chosen = !options.recording.empty() || !options.sonar.empty() || !options.connect.empty();
    if (options.demonstration) window.openDemonstration();
    if (!chosen) window.greet();
    if (!options.recording.empty()) window.openRecording(QString::fromStdString(options.recording));
    if (!options.connect.empty()) window.openTracker(QString::fromStdString(options.connect), !options.no_record);
    if (!options.sonar.empty())
        window.connection().connectTo(QString::fromStdString(options.sonar), QString::fromStdString(options.navigation),
                                      !options.no_record);
    if (options.isLive() && unattended && !window.bridge().isLive()) {
        std::cerr << "echotrail-console: " << window.messages().text().toStdString() << "\n";
        return 1;
    }
    if (unattended) new Unattended(window, options.schedule, options.hasSource());
    QTimer interrupts;  // a signal handler may do no more than set a flag
    if (!unattended) {
        QObject::connect(&interrupts, &QTimer::timeout, &window, [&window] {
            if (isInterrupted()) window.close();
        });
        interrupts.start(interrupt_interval_ms);
    }
    if (options.quit_after_s)
        QTimer::singleShot(static_cast<int>(*options.quit_after_s * 1000.0), &window, &QWidget::close);
    return QApplication::exec();
}
