#include "ui/panels/tracks/target_card.hpp"

#include "ui/models/track_model.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/track_painter.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>
#include <cmath>

namespace echotrail {
namespace {

constexpr double nis_limit = 5.99;  ///< 95 % of a consistent track's values lie below: χ² of two dimensions
constexpr double least_moving_mps = 0.05;

QString plusMinus(double value, int decimals, const QString& unit) {
    if (!std::isfinite(value)) return {};
    const bool degrees = unit == QChar(0xb0);  // the only unit that follows its number without a space
    return QChar(0xb1) +
           (degrees ? Formatter::number(value, decimals) + unit : Formatter::withUnit(value, decimals, unit));
}

/// Deviation of a plane Gaussian in a direction.
double deviationAlong(const Eigen::Matrix2d& covariance, const Eigen::Vector2d& direction) {
    return std::sqrt(std::max(0.0, direction.dot(covariance * direction)));
}

QLabel* dimLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setObjectName("dim");
    return label;
}

void setName(QLabel& label, const char* name) {
    if (label.objectName() == name) return;
    label.setObjectName(name);
    label.style()->unpolish(&label);
    label.style()->polish(&label);
}

}  // namespace

TargetCard::TargetCard(QWidget* parent) : QWidget(parent) {
    const UiMetrics metrics(font());
    auto* column = new QVBoxLayout(this);
    column->setSpacing(metrics.pixels(6.0));
    auto* head = new QHBoxLayout;
    title_ = new QLabel(this);
    title_->setObjectName("title");
    subtitle_ = dimLabel({}, this);
    head->addWidget(title_);
    head->addWidget(subtitle_, 1);
    column->addLayout(head);
    auto* values = new QGridLayout;
    auto* comparisons = new QGridLayout;
    auto* facts = new QGridLayout;
    addValues(*values);
    addComparisons(*comparisons);
    addFacts(*facts);
    column->addLayout(values);
    column->addLayout(comparisons);
    column->addLayout(facts);
    column->addStretch(1);
    showNothing();
}

void TargetCard::addValues(QGridLayout& grid) {
    const std::array names{tr("Range"), tr("Bearing"), tr("Age of last echo"),
                           tr("Speed"), tr("Course"),  tr("Existence")};
    for (int i = 0; i < ValueCount; ++i) {
        const int row = i / 3 * 2;
        auto* box = new QHBoxLayout;
        values_[static_cast<std::size_t>(i)] = {new QLabel(this), new QLabel(this)};
        values_[static_cast<std::size_t>(i)].detail->setObjectName("card_detail");
        box->setSpacing(UiMetrics(font()).pixels(3.0));
        box->addWidget(values_[static_cast<std::size_t>(i)].value);
        box->addWidget(values_[static_cast<std::size_t>(i)].detail, 1, Qt::AlignBottom);
        grid.addWidget(dimLabel(names[static_cast<std::size_t>(i)], this), row, i % 3);
        grid.addLayout(box, row + 1, i % 3);
        grid.setColumnStretch(i % 3, 1);
    }
}

void TargetCard::addComparisons(QGridLayout& grid) {
    const std::array names{tr("Place"),           tr("Area"),    tr("Moment m*"), tr("Along the beam"),
                           tr("Across the beam"), tr("Strength")};
    grid.addWidget(dimLabel(tr("Why this echo"), this), 0, 0);
    grid.addWidget(dimLabel(tr("Expected"), this), 0, 1, Qt::AlignRight);
    grid.addWidget(dimLabel(tr("Seen"), this), 0, 2, Qt::AlignRight);
    for (int i = 0; i < ComparisonCount; ++i) {
        auto& comparison = comparisons_[static_cast<std::size_t>(i)];
        comparison = {dimLabel({}, this), new QLabel(this)};
        grid.addWidget(new QLabel(names[static_cast<std::size_t>(i)], this), i + 1, 0);
        grid.addWidget(comparison.expected, i + 1, 1, Qt::AlignRight);
        grid.addWidget(comparison.seen, i + 1, 2, Qt::AlignRight);
    }
    grid.setColumnStretch(0, 2);
    grid.setColumnStretch(1, 1);
    grid.setColumnStretch(2, 1);
}

void TargetCard::addFacts(QGridLayout& grid) {
    const std::array names{tr("Looks"), tr("Likeness"), tr("NIS, limit %1").arg(nis_limit), tr("Particles"),
                           tr("Born")};
    for (int i = 0; i < FactCount; ++i) {
        facts_[static_cast<std::size_t>(i)] = new QLabel(this);
        grid.addWidget(dimLabel(names[static_cast<std::size_t>(i)], this), i, 0);
        grid.addWidget(facts_[static_cast<std::size_t>(i)], i, 1);
    }
    grid.setColumnStretch(1, 1);
}

void TargetCard::setValue(ValueName name, const QString& value, const QString& detail, bool stale) {
    const Value& field = values_[name];
    field.value->setText(value);
    field.detail->setText(detail);
    setName(*field.value, stale ? "card_stale" : "card_value");
}

void TargetCard::showNothing() {
    title_->setText(tr("No track selected"));
    subtitle_->setText(tr("click a row to read its card"));
    setName(*subtitle_, "dim");
    for (int i = 0; i < ValueCount; ++i) setValue(static_cast<ValueName>(i), Formatter::unknown(), {}, true);
    for (const Comparison& comparison : comparisons_) {
        comparison.expected->setText(Formatter::unknown());
        comparison.seen->setText(Formatter::unknown());
    }
    for (QLabel* fact : facts_) fact->setText(Formatter::unknown());
}

void TargetCard::showValues(const Track& track, const Scene& scene) {
    const Pose& pose = scene.latest.pose;
    const double range = rangeOf(track, pose);
    const Bearing from_bow = bearingOf(track, pose);
    const double from_north = (from_bow + pose.heading.inRadians()).inRadians();
    const Eigen::Vector2d away(std::cos(from_north), std::sin(from_north));
    const Eigen::Vector2d across(-away.y(), away.x());
    const Eigen::Matrix2d place = track.estimate.covariance.topLeftCorner<2, 2>();
    const bool stale = track.state == TrackState::Lost;
    setValue(RangeValue, Formatter::range(range), plusMinus(deviationAlong(place, away), 2, "m"), stale);
    const double bearing_deg = degreesFromRadians(deviationAlong(place, across) / std::max(range, 0.1));
    setValue(BearingValue, Formatter::relativeBearing(from_bow), plusMinus(bearing_deg, 1, QChar(0xb0)), stale);
    const double age = secondsBetween(track.last_seen, scene.latest.time);
    setValue(AgeValue, Formatter::age(age), {}, stale);
    const Eigen::Vector2d velocity = track.estimate.mean.tail<2>();
    const double speed = velocity.norm();
    const bool moving = track.looks > 1 && speed >= least_moving_mps;
    const Eigen::Matrix2d velocity_spread = track.estimate.covariance.bottomRightCorner<2, 2>();
    if (track.looks > 1)
        setValue(SpeedValue, Formatter::speed(speed),
                 moving ? plusMinus(deviationAlong(velocity_spread, velocity / speed), 2, "m/s") : QString(), stale);
    else
        setValue(SpeedValue, Formatter::unknown(), tr("one look"), true);
    const Bearing course = Bearing::radians(std::atan2(velocity.y(), velocity.x()));
    const QString course_text = headingKnown(scene)
                                    ? Formatter::trueBearing(course)
                                    : Formatter::relativeBearing(Bearing::radians(course - pose.heading));
    setValue(CourseValue, moving ? course_text : Formatter::unknown(), moving ? QString() : tr("at rest"),
             stale || !moving);
    setValue(ExistenceValue, Formatter::probability(track.existence), {}, stale);
}

void TargetCard::showComparisons(const Track& track) {
    const RegionFeatures& expected = track.expected_features;
    const RegionFeatures& seen = track.seen_features;
    const auto compare = [this](ComparisonName name, double reference, double measured, int decimals,
                                const QString& unit) {
        const auto shown = [&](double value) {
            return unit.isEmpty() ? Formatter::number(value, decimals) : Formatter::withUnit(value, decimals, unit);
        };
        comparisons_[name].expected->setText(shown(reference));
        comparisons_[name].seen->setText(shown(measured));
    };
    comparisons_[Place].expected->setText(Formatter::unknown());
    comparisons_[Place].seen->setText(tr("%1 off").arg(Formatter::withUnit(track.innovation_m, 2, "m")));
    compare(Area, expected.area_m2, seen.area_m2, 2, "m²");
    compare(Moment, expected.moment, seen.moment, 2, {});
    compare(Along, expected.along_range_m, seen.along_range_m, 2, "m");
    compare(Across, expected.across_range_m, seen.across_range_m, 2, "m");
    compare(Strength, expected.strength_db, seen.strength_db, 1, "dB");
}

void TargetCard::showTrack(const Track& track, const Scene& scene) {
    title_->setText(Formatter::trackId(track.id));
    subtitle_->setText((track.target ? tr("target · %1") : QString("%1")).arg(stateWord(track.state)));
    setName(*subtitle_, track.state == TrackState::Lost ? "lost" : "dim");
    showValues(track, scene);
    showComparisons(track);
    facts_[Looks]->setText(tr("%1 with an echo · %2 missed since").arg(track.looks).arg(track.misses));
    facts_[Likeness]->setText(Formatter::probability(track.score));
    facts_[Consistency]->setText(Formatter::number(track.nis, 2));
    setName(*facts_[Consistency], track.nis > nis_limit ? "refusal" : "fact");
    const std::size_t particles = track.particles.weight.size();
    facts_[Particles]->setText(
        particles > 0
            ? tr("%1 effective of %2").arg(Formatter::number(track.particles.effective, 0), Formatter::count(particles))
            : Formatter::unknown());
    facts_[Born]->setText(
        tr("%1 · %2 ago")
            .arg(Formatter::utc(track.born).mid(11, 8), Formatter::age(secondsBetween(track.born, scene.latest.time))));
}

}  // namespace echotrail
