#pragma once

#include "core/runtime/scene.hpp"
#include "core/tracking/tracker.hpp"
#include "ui/models/track_samples.hpp"
#include "ui/style/formatter.hpp"

#include <QWidget>
#include <array>

class QGridLayout;
class QLabel;

namespace echotrail {

class StripChart;
class TermBar;

/// All about one track: where it is and how sure that is, why its last echo was taken for it, why it is in its state,
/// and how that went.
class TargetCard : public QWidget {
    Q_OBJECT

public:
    explicit TargetCard(QWidget* parent = nullptr);
    /// `samples`: of this track, so far. `params`: by which the tracker judges it.
    void showTrack(const Track& track, const Scene& scene, const std::vector<TrackSample>& samples,
                   const Tracker::Params& params, const TrackNames& names = {});
    void showNothing();

private:
    struct Value {
        QLabel* value = nullptr;
        QLabel* detail = nullptr;
    };
    struct Comparison {
        QLabel* expected = nullptr;
        QLabel* seen = nullptr;
        TermBar* term = nullptr;
    };
    enum ValueName { RangeValue, BearingValue, AgeValue, SpeedValue, CourseValue, ExistenceValue, ValueCount };
    enum ComparisonName { Place, Area, Moment, Strength, Level, ComparisonCount };
    enum FactName { State, LastLooks, Competing, Consistency, Particles, Born, FactCount };

    void addValues(QGridLayout& grid);
    void addComparisons(QGridLayout& grid);
    void addFacts(QGridLayout& grid);
    void showValues(const Track& track, const Scene& scene);
    void showComparisons(const Track& track, const LikenessParams& params);
    void showFacts(const Track& track, const Scene& scene, const std::vector<TrackSample>& samples,
                   const Tracker::Params& params);
    void setValue(ValueName name, const QString& value, const QString& detail, bool stale);

    std::array<Value, ValueCount> values_{};
    std::array<Comparison, ComparisonCount> comparisons_{};
    std::array<QLabel*, FactCount> facts_{};
    StripChart* chart_ = nullptr;
    QLabel* title_ = nullptr;
    QLabel* subtitle_ = nullptr;
};

}  // namespace echotrail
