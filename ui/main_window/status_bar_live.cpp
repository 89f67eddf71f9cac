#include "ui/main_window/status_bar.hpp"
#include "ui/main_window/status_chip.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/style/formatter.hpp"

namespace echotrail {
namespace {

using Health = StatusChip::Health;

constexpr double old_bytes_s = 2.0;  ///< a head that scans or waits says something every second
constexpr qint64 rate_interval_ms = 2000;

QString ageText(const std::optional<double>& age_s) { return age_s ? Formatter::age(*age_s) : QString(); }

QString megabytes(std::uint64_t bytes) { return Formatter::withUnit(static_cast<double>(bytes) / 1e6, 1, "MB"); }
QString gigabytes(std::uint64_t bytes) { return Formatter::withUnit(static_cast<double>(bytes) / 1e9, 1, "GB"); }

}  // namespace

void StatusBar::showLive(const LiveState& state, double longest_heading_gap_s) {
    if (mode_ != Mode::Live) setMode(Mode::Live);
    showLink(state);
    showSonar(state);
    showHeading(state, longest_heading_gap_s);
    showRecording(state.run.recorder);
    showCounts(state.run.counts);
}

void StatusBar::showLink(const LiveState& state) {
    const bool fresh = state.sonar.age_s && *state.sonar.age_s < old_bytes_s;
    const QString word = !state.sonar.up ? tr("down") : fresh ? tr("up") : tr("quiet");
    link_->show(state.sonar.up && fresh ? Health::Good : Health::Degraded, word, ageText(state.sonar.age_s));
    link_->setToolTip(state.sonar.reason.isEmpty() ? tr("Age of the last bytes from the head") : state.sonar.reason);
}

void StatusBar::showSonar(const LiveState& state) {
    const bool scanning = state.head.state == seanet::HeadState::Polling;
    const bool fresh = scanning && state.ping_age_s && *state.ping_age_s < old_bytes_s;
    const double rate = pingRate(state.head.pings);
    QStringList detail;
    if (scanning) detail << Formatter::withUnit(rate, 1, tr("pings/s"));
    if (state.ping_age_s) detail << ageText(state.ping_age_s);
    sonar_->show(fresh ? Health::Good : Health::Degraded, headStateTitle(state.head.state), detail.join("  "));
    sonar_->setToolTip(state.head.advice.empty() ? QString::fromStdString(state.head.head)
                                                 : QString::fromStdString(state.head.advice));
}

/// Over two seconds: single lines come too unevenly to be read.
double StatusBar::pingRate(std::uint64_t pings) {
    if (!rate_clock_.isValid()) {
        rate_clock_.start();
        rate_pings_ = pings;
        rate_ = 0.0;
    } else if (rate_clock_.elapsed() >= rate_interval_ms) {
        rate_ = 1e3 * static_cast<double>(pings - rate_pings_) / static_cast<double>(rate_clock_.restart());
        rate_pings_ = pings;
    }
    return rate_;
}

void StatusBar::showHeading(const LiveState& state, double longest_gap_s) {
    const auto& heading = state.run.navigation.heading;
    if (!heading || !state.heading_age_s) {
        const bool asked = state.navigation.has_value();
        heading_->show(asked ? Health::Degraded : Health::Absent, {}, asked ? tr("waiting") : tr("no navigation"));
        heading_->setToolTip(state.navigation ? state.navigation->reason : QString());
        return;
    }
    const bool fresh = *state.heading_age_s < longest_gap_s;
    heading_->show(fresh ? Health::Good : Health::Degraded, Formatter::trueBearing(*heading),
                   fresh ? ageText(state.heading_age_s) : tr("stale %1").arg(ageText(state.heading_age_s)));
    heading_->setToolTip(QString::fromStdString(state.run.navigation.heading_kind));
}

void StatusBar::showRecording(const RecorderStatus& recorder) {
    recording_->setToolTip(QString::fromStdString(recorder.error.empty() ? recorder.path : recorder.error));
    if (!recorder.error.empty()) return recording_->show(Health::Degraded, tr("ended"), tr("not recording"));
    if (!recorder.recording) return recording_->show(Health::Absent, tr("off"));
    const bool room = recorder.disk == DiskState::Good;
    const QString free = tr("%1 free").arg(gigabytes(recorder.free_bytes));
    recording_->show(room ? Health::Good : Health::Degraded, megabytes(recorder.bytes),
                     room ? free : tr("disk nearly full: %1").arg(free));
}

}  // namespace echotrail
