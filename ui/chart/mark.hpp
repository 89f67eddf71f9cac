#pragma once

#include "core/base/time.hpp"

#include <Eigen/Core>

#include <QString>

namespace echotrail {

/// A place that the operator wants to find again. It stays on the ground.
struct Mark {
    int number = 0;                 ///< counts from 1, never given twice while a source is open
    QString text;                   ///< may be empty
    Eigen::Vector2d place_m{0, 0};  ///< north, east in the local frame
    Timestamp time{};               ///< of the picture it was set in
    bool operator==(const Mark&) const = default;

    /// "M4", or "M4 net?"
    QString label() const {
        const QString name = QStringLiteral("M%1").arg(number);
        return text.isEmpty() ? name : name + ' ' + text;
    }
};

}  // namespace echotrail
