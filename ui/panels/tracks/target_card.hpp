#pragma once

#include "core/runtime/scene.hpp"

#include <QWidget>
#include <array>

class QGridLayout;
class QLabel;

namespace echotrail {

/// All about one track: where it is and how sure that is, and why its last echo was taken for it.
class TargetCard : public QWidget {
    Q_OBJECT

public:
    explicit TargetCard(QWidget* parent = nullptr);
    void showTrack(const Track& track, const Scene& scene);
    void showNothing();

private:
    struct Value {
        QLabel* value = nullptr;
        QLabel* detail = nullptr;
    };
    struct Comparison {
        QLabel* expected = nullptr;
        QLabel* seen = nullptr;
    };
    enum ValueName { RangeValue, BearingValue, AgeValue, SpeedValue, CourseValue, ExistenceValue, ValueCount };
    enum ComparisonName { Place, Area, Moment, Along, Across, Strength, ComparisonCount };
    enum FactName { Looks, Likeness, Consistency, Particles, Born, FactCount };

    void addValues(QGridLayout& grid);
    void addComparisons(QGridLayout& grid);
    void addFacts(QGridLayout& grid);
    void showValues(const Track& track, const Scene& scene);
    void showComparisons(const Track& track);
    void setValue(ValueName name, const QString& value, const QString& detail, bool stale);

    std::array<Value, ValueCount> values_{};
    std::array<Comparison, ComparisonCount> comparisons_{};
    std::array<QLabel*, FactCount> facts_{};
    QLabel* title_ = nullptr;
    QLabel* subtitle_ = nullptr;
};

}  // namespace echotrail
