#pragma once

#include "core/runtime/scene.hpp"
#include "ui/alerts/alert.hpp"
#include "ui/bridge/live_source.hpp"
#include "ui/style/formatter.hpp"

#include <QCoreApplication>
#include <vector>

namespace echotrail {

/// What is worth an alert. The limits stand here and nowhere else.
class AlertRules {
    Q_DECLARE_TR_FUNCTIONS(AlertRules)

public:
    static constexpr double stale_link_s = 2.0;  ///< a head that scans or waits says something every second
    static constexpr double link_delay_s = 2.0;  ///< a link that heals within this was no trouble
    static constexpr double heading_delay_s = 1.0;
    static constexpr double disk_alarm_min = 5.0;  ///< room for so long, at the present rate
    static constexpr double disk_caution_min = 60.0;
    static constexpr double least_rate_time_s = 30.0;  ///< of recording, before its rate means something

    /// Of a head that is polled, or a tracker that is followed. `longest_heading_gap_s`: an older heading is no use.
    static std::vector<Situation> ofLive(const LiveState& state, double longest_heading_gap_s);
    /// Of what the tracker makes of the echoes. `live`: its heading is judged by ofLive().
    static std::vector<Situation> ofScene(const Scene& scene, bool live, const TrackNames& names = {});
    /// A confirmed track has come into a guard zone.
    static Situation guardZoneEntered(int track, const QString& zone, const TrackNames& names = {});

private:
    static void addLinks(const LiveState& state, std::vector<Situation>& situations);
    static void addHeading(const LiveState& state, double longest_gap_s, std::vector<Situation>& situations);
    static void addRecording(const LiveStatus& run, std::vector<Situation>& situations);
};

/// Minutes of recording that the disk has room for; none while the rate is not known.
std::optional<double> minutesLeft(const LiveStatus& run);
/// "alarm", translated.
QString priorityWord(AlertPriority priority);

}  // namespace echotrail
