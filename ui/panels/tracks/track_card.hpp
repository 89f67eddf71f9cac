#pragma once

#include "core/runtime/scene.hpp"

#include <QWidget>
#include <map>

class QLabel;

namespace echotrail {

/// What is known of one track: each value with its unit, and how it came about.
class TrackCard : public QWidget {
    Q_OBJECT

public:
    explicit TrackCard(QWidget* parent = nullptr);
    /// Null: nothing is selected.
    void show(const Track* track, const Scene& scene);

private:
    enum Value {
        Range,
        BearingValue,
        Age,
        Speed,
        Course,
        Existence,
        Looks,
        Particles,
        Innovation,
        Area,
        Moment,
        Strength
    };
    void set(Value value, const QString& text);

    QLabel* title_;
    std::map<Value, QLabel*> values_;
};

}  // namespace echotrail
