#pragma once

#include "ui/alerts/alert_book.hpp"

#include <optional>

namespace echotrail {

/// When to sound: an emergency every second, an alarm every two, a warning twice a minute, until acknowledged; a
/// caution never. Silence is for a time only, and what is raised meanwhile ends it.
class AlertSound {
public:
    static constexpr double silence_s = 30.0;

    void silence(Timestamp now) { silent_since_ = now; }
    /// Seconds of silence left; 0: it may sound.
    double silentFor(Timestamp now) const;
    /// Whether to sound now; it then counts as done.
    bool isDue(const AlertBook& book, Timestamp now);

private:
    std::optional<Timestamp> silent_since_;
    std::optional<Timestamp> last_;
};

}  // namespace echotrail
