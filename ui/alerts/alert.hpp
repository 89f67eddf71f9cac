#pragma once

#include "core/base/time.hpp"

#include <QString>
#include <functional>
#include <optional>

namespace echotrail {

/// The four of the sea, most urgent first. A caution is only shown; the others ask to be acknowledged.
enum class AlertPriority { Emergency, Alarm, Warning, Caution };

/// What an alert says, in the language in force when it was put into words.
struct AlertWords {
    QString title;
    QString cause;  ///< what is known of it, or what to do
};

/// Something that is so now, and that the operator should know.
struct Situation {
    QString key;  ///< one alert for each
    AlertPriority priority = AlertPriority::Caution;
    QString title;
    QString cause;         ///< may change while it lasts
    double delay_s = 0.0;  ///< it is told when it has lasted this long, and over when it has been gone this long
    int track = 0;         ///< that it speaks of; 0: none
    std::function<AlertWords()> words = {};  ///< title and cause anew, of the same values; without it they stay
};

/// A situation that was told, and what became of it.
struct Alert {
    int id = 0;  ///< counts from 1
    Situation situation;
    AlertPriority priority = AlertPriority::Caution;  ///< the situation's, or higher since it was escalated
    Timestamp raised{};
    std::optional<Timestamp> acknowledged;
    std::optional<Timestamp> ended;
    bool passing = false;  ///< a happening and no state: over when it is acknowledged

    /// It still asks for the operator, whether it lasts or not.
    bool isNew() const { return !acknowledged && priority != AlertPriority::Caution; }
    bool isOpen() const { return isNew() || !ended; }
};

}  // namespace echotrail
