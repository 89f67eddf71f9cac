#pragma once

#include "core/runtime/scene.hpp"
#include "ui/alerts/alert_book.hpp"
#include "ui/alerts/alert_log.hpp"
#include "ui/alerts/alert_model.hpp"
#include "ui/alerts/alert_sound.hpp"
#include "ui/bridge/live_source.hpp"
#include "ui/style/formatter.hpp"

#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QTimer>
#include <functional>
#include <memory>

namespace echotrail {

/// Open alerts at a glance.
struct AlertSummary {
    int alarms = 0;  ///< emergencies too
    int warnings = 0;
    int cautions = 0;
    int recent = 0;  ///< raised within ten minutes
    bool new_alarm = false, new_warning = false;
    QString title;  ///< of the most urgent one that asks for the operator; empty where none does
};

/// Watches what is shown for what is worth an alert, and tells it: to the list, by flashing, by sound, to the log.
/// Of a head that is polled the time is the computer's; of a recording it is the recording's, there is no sound and
/// nothing is logged: it is history.
class AlertCentre : public QObject {
    Q_OBJECT

public:
    explicit AlertCentre(QObject* parent = nullptr);

    AlertModel& model() { return model_; }
    AlertSummary summary() const;
    void setSound(std::function<void()> sound) { sound_ = std::move(sound); }
    /// What time it is for alerts of a head that is polled, instead of the computer's.
    void setClock(std::function<Timestamp()> clock) { clock_ = std::move(clock); }
    /// Where what becomes of alerts is written; without it nowhere.
    void setLog(const QString& path) { log_ = std::make_unique<AlertLog>(path); }
    /// Nothing flashes: what would is shown filled.
    void setSteady(bool on);
    bool isSteady() const { return steady_; }
    /// Whether new alerts of this priority are shown filled at this moment of flashing.
    bool isLit(AlertPriority priority) const;
    double silentFor() const { return sound_rule_.silentFor(now()); }

    /// What tracks are called in alerts from now on.
    void setTrackNames(const TrackNames& names) { names_ = names; }
    void showNothing();
    void showLive(const LiveState& state, double longest_heading_gap_s);
    void showScene(const Scene& scene, bool live);

public Q_SLOTS:
    void guardZoneEntered(int track, const QString& zone);
    /// No alerts about this track until another source is opened; those that ask are acknowledged.
    void setMuted(int track, bool on);
    void acknowledge(int id);
    /// The one at the top of the list.
    void acknowledgeMostUrgent();
    void silence();

Q_SIGNALS:
    /// The list or its summary changed.
    void changed();
    /// Only how it looks at this moment of flashing.
    void flashed();
    void noticed(const QString& text, bool ok);

private:
    Timestamp now() const;
    void update();
    void tell();
    void tick();

    AlertBook book_;
    AlertModel model_;
    AlertSound sound_rule_;
    std::unique_ptr<AlertLog> log_;
    bool log_failure_told_ = false;
    std::function<void()> sound_;
    std::function<Timestamp()> clock_;
    std::vector<Situation> of_live_, of_scene_;
    QSet<int> muted_;
    TrackNames names_;
    bool live_ = false;
    Timestamp replay_time_{};
    Timestamp started_{};
    QElapsedTimer running_;  ///< a computer's clock may be set; alerts must not jump with it
    QTimer timer_;
    unsigned phase_ = 0;
    bool steady_ = false;
};

}  // namespace echotrail
