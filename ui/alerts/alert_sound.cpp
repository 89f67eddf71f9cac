#include "ui/alerts/alert_sound.hpp"

#include <algorithm>

namespace echotrail {
namespace {

double period_s(AlertPriority priority) {
    switch (priority) {
        case AlertPriority::Emergency:
            return 1.0;
        case AlertPriority::Alarm:
            return 2.0;
        default:
            return 30.0;
    }
}

}  // namespace

double AlertSound::silentFor(Timestamp now) const {
    return silent_since_ ? std::clamp(silence_s - secondsBetween(*silent_since_, now), 0.0, silence_s) : 0.0;
}

bool AlertSound::isDue(const AlertBook& book, Timestamp now) {
    const Alert* loudest = book.mostUrgent();
    if (!loudest) {
        last_.reset();  // the next one sounds at once
        return false;
    }
    Timestamp newest = loudest->raised;
    for (const Alert& alert : book.alerts())
        if (alert.isNew()) newest = std::max(newest, alert.raised);
    if (silent_since_ && newest > *silent_since_) silent_since_.reset();
    if (silentFor(now) > 0.0) return false;
    const bool waited = !last_ || newest > *last_ || secondsBetween(*last_, now) >= period_s(loudest->priority);
    if (waited) last_ = now;
    return waited;
}

}  // namespace echotrail
