#include "ui/panels/tracks/target_card.hpp"

#include "core/features/likeness_deviations.hpp"
#include "ui/models/track_model.hpp"
#include "ui/panels/tracks/strip_chart.hpp"
#include "ui/panels/tracks/term_bar.hpp"
#include "ui/panels/tracks/track_reasons.hpp"
#include "ui/panels/tracks/track_strips.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/label_role.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/track_painter.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

namespace echotrail {
namespace {

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

}  // namespace

TargetCard::TargetCard(QWidget* parent) : QWidget(parent) {
    const UiMetrics metrics(font());
    auto* column = new QVBoxLayout(this);
    column->setSpacing(metrics.pixels(4.0));
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
    chart_ = new StripChart(this);
    column->addWidget(chart_);
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
    const std::array names{tr("Place"), tr("Area"), tr("Moment m*"), tr("Strength"), tr("Level")};
    grid.addWidget(dimLabel(tr("Why this echo"), this), 0, 0);
    grid.addWidget(dimLabel(tr("Reference"), this), 0, 1, Qt::AlignRight);
    grid.addWidget(dimLabel(tr("Seen"), this), 0, 2, Qt::AlignRight);
    grid.addWidget(dimLabel(tr("log likelihood"), this), 0, 3, Qt::AlignRight);
    for (int i = 0; i < ComparisonCount; ++i) {
        auto& comparison = comparisons_[static_cast<std::size_t>(i)];
        comparison = {dimLabel({}, this), new QLabel(this), new TermBar(this)};
        grid.addWidget(new QLabel(names[static_cast<std::size_t>(i)], this), i + 1, 0);
        grid.addWidget(comparison.expected, i + 1, 1, Qt::AlignRight);
        grid.addWidget(comparison.seen, i + 1, 2, Qt::AlignRight);
        grid.addWidget(comparison.term, i + 1, 3, Qt::AlignRight);
    }
    grid.setVerticalSpacing(UiMetrics(font()).pixels(2.0));
    for (const int column : {0, 1, 2, 3}) grid.setColumnStretch(column, 1);
}

void TargetCard::addFacts(QGridLayout& grid) {
    const std::array names{tr("State"), tr("Last looks"), tr("Near it"), tr("NIS"), tr("Particles"), tr("Born")};
    for (int i = 0; i < FactCount; ++i) {
        QLabel* fact = facts_[static_cast<std::size_t>(i)] = new QLabel(this);
        fact->setObjectName("fact");
        fact->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long one must not widen the card
        grid.addWidget(dimLabel(names[static_cast<std::size_t>(i)], this), i, 0, Qt::AlignTop);
        grid.addWidget(fact, i, 1);
    }
    for (const FactName reason : {State, LastLooks}) facts_[reason]->setWordWrap(true);
    facts_[Competing]->setToolTip(tr("Regions of the last sweep in its gate: likeness to the reference, and distance"));
    facts_[Consistency]->setToolTip(
        tr("Normalised innovation squared: a track that knows how sure it is has 95 % of its looks below %1")
            .arg(TrackStrips::nis_limit));
    grid.setVerticalSpacing(UiMetrics(font()).pixels(2.0));
    grid.setColumnStretch(1, 1);
}

void TargetCard::setValue(ValueName name, const QString& value, const QString& detail, bool stale) {
    const Value& field = values_[name];
    field.value->setText(value);
    field.detail->setText(detail);
    setLabelRole(*field.value, stale ? "card_stale" : "card_value");
}

void TargetCard::showNothing() {
    title_->setText(tr("No track selected"));
    subtitle_->setText(tr("click a row to read its card"));
    setLabelRole(*subtitle_, "dim");
    for (int i = 0; i < ValueCount; ++i) setValue(static_cast<ValueName>(i), Formatter::unknown(), {}, true);
    for (const Comparison& comparison : comparisons_) {
        comparison.expected->setText(Formatter::unknown());
        comparison.seen->setText(Formatter::unknown());
        comparison.term->setTerm(std::numeric_limits<double>::quiet_NaN());
    }
    for (QLabel* fact : facts_) fact->setText(Formatter::unknown());
    chart_->setStrips({}, {}, chartSpan(0.0));
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

void TargetCard::showComparisons(const Track& track, const LikenessParams& params) {
    const RegionFeatures& expected = track.expected_features;
    const RegionFeatures& seen = track.seen_features;
    const LikenessDeviations off = likenessDeviations(seen, expected, params);
    const auto compare = [this](ComparisonName name, const QString& reference, const QString& measured,
                                double deviation) {
        comparisons_[name].expected->setText(reference);
        comparisons_[name].seen->setText(measured);
        comparisons_[name].term->setTerm(-0.5 * deviation * deviation);
    };
    const auto metres2 = [](double value) { return Formatter::withUnit(value, 2, "m²"); };
    const auto decibels = [](double value) { return Formatter::withUnit(value, 1, "dB"); };
    compare(Place, Formatter::unknown(), tr("%1 off").arg(Formatter::withUnit(track.innovation_m, 2, "m")),
            std::sqrt(track.nis));
    compare(Area, metres2(expected.area_m2), metres2(seen.area_m2), off.area);
    compare(Moment, Formatter::number(expected.moment, 2), Formatter::number(seen.moment, 2), off.moment);
    compare(Strength, decibels(expected.strength_db), decibels(seen.strength_db), off.strength);
    compare(Level, decibels(expected.level_db), decibels(seen.level_db), off.level);
}

void TargetCard::showFacts(const Track& track, const Scene& scene, const std::vector<TrackSample>& samples,
                           const Tracker::Params& params) {
    const Timestamp now = scene.latest.time;
    facts_[State]->setText(TrackReasons::ofState(track, now, params.life));
    setLabelRole(*facts_[State], track.state == TrackState::Lost ? "lost" : "fact");
    facts_[LastLooks]->setText(TrackReasons::ofLastLooks(track));
    facts_[Competing]->setText(TrackReasons::competing(track, scene, params));
    const auto within = std::count_if(samples.begin(), samples.end(),
                                      [](const TrackSample& sample) { return sample.nis <= TrackStrips::nis_limit; });
    facts_[Consistency]->setText(samples.empty() ? Formatter::number(track.nis, 2)
                                                 : tr("%1 · %2 of %3 echoes within %4")
                                                       .arg(Formatter::number(track.nis, 2))
                                                       .arg(within)
                                                       .arg(samples.size())
                                                       .arg(TrackStrips::nis_limit));
    setLabelRole(*facts_[Consistency], track.nis > TrackStrips::nis_limit ? "refusal" : "fact");
    const std::size_t particles = track.particles.size();
    facts_[Particles]->setText(
        particles > 0
            ? tr("%1 effective of %2").arg(Formatter::number(track.particles.effective, 0), Formatter::count(particles))
            : Formatter::unknown());
    facts_[Born]->setText(TrackReasons::ofBirth(track, now));
}

void TargetCard::showTrack(const Track& track, const Scene& scene, const std::vector<TrackSample>& samples,
                           const Tracker::Params& params, const TrackNames& names) {
    title_->setText(Formatter::trackLabel(track.id, names));
    subtitle_->setText((track.target ? tr("target · %1") : QString("%1")).arg(stateWord(track.state)));
    setLabelRole(*subtitle_, track.state == TrackState::Lost ? "lost" : "dim");
    showValues(track, scene);
    showComparisons(track, params.likeness);
    showFacts(track, scene, samples, params);
    const Timestamp now = scene.latest.time;
    chart_->setStrips(TrackStrips::of(track, samples), now, chartSpan(TrackStrips::length(track, samples, now)));
}

}  // namespace echotrail
