#pragma once

#include "ui/alerts/alert.hpp"

#include <vector>

namespace echotrail {

/// What became of an alert, for the log.
struct AlertChange {
    enum class What { Raised, Escalated, Acknowledged, Ended };
    What what = What::Raised;
    Alert alert;
    Timestamp time{};
};

/// The life of alerts: told once for each situation, acknowledged, escalated where nobody looks, over.
/// Order: the time never goes back; where it does (a recording was wound back), clear() first.
class AlertBook {
public:
    static constexpr double escalation_s = 60.0;     ///< a warning that nobody acknowledged becomes an alarm
    static constexpr std::size_t most_alerts = 200;  ///< older ones that are over are forgotten

    /// All situations that are so at `now`; what was so and is missing has ended.
    void update(const std::vector<Situation>& situations, Timestamp now);
    /// Something happened. While the last of its key is not acknowledged, that one is told again.
    void happened(const Situation& situation, Timestamp now);
    void acknowledge(int id, Timestamp now);
    /// Says all anew, what is over too: the language has changed.
    void reword();
    void clear();

    /// As they are listed: what asks for the operator by priority, then what lasts, then what is over; newest first.
    const std::vector<Alert>& alerts() const { return alerts_; }
    /// The first in the list that asks to be acknowledged; null where none does.
    const Alert* mostUrgent() const;
    /// Raised within the last ten minutes.
    int recent(Timestamp now) const;
    std::vector<AlertChange> takeChanges();

private:
    /// A situation that has not lasted, or not been gone, for its delay.
    struct Waiting {
        QString key;
        Timestamp since{};
    };

    Alert* openOf(const QString& key);
    bool hasLasted(std::vector<Waiting>& waiting, const Situation& situation, Timestamp now);
    void raise(const Situation& situation, bool passing, Timestamp now);
    void endWhatIsOver(const std::vector<Situation>& situations, Timestamp now);
    void escalate(Timestamp now);
    void note(AlertChange::What what, const Alert& alert, Timestamp now);
    void arrange();

    std::vector<Alert> alerts_;
    std::vector<Waiting> coming_, going_;
    std::vector<AlertChange> changes_;
    int next_id_ = 1;
};

}  // namespace echotrail
