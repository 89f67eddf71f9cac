#include "ui/panels/tracks/track_card.hpp"

#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

namespace echotrail {
namespace {

/// "0.42 → 0.29 m²": what was expected, and what was seen.
QString expectedAndSeen(double expected, double seen, int decimals, const QString& unit) {
    return QString("%1 → %2").arg(Formatter::number(expected, decimals), Formatter::withUnit(seen, decimals, unit));
}

}  // namespace

TrackCard::TrackCard(QWidget* parent) : QWidget(parent), title_(new QLabel(this)) {
    const UiMetrics metrics(font());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics.pixels(8), metrics.pixels(4), metrics.pixels(8), metrics.pixels(8));
    title_->setFont(metrics.sized(font(), 15, true));
    column->addWidget(title_);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(metrics.pixels(12));
    grid->setVerticalSpacing(metrics.pixels(2));
    column->addLayout(grid);
    column->addStretch(1);
    const std::pair<Value, QString> labels[] = {{Range, tr("Range")},
                                                {BearingValue, tr("Bearing")},
                                                {Age, tr("Last echo")},
                                                {Speed, tr("Speed")},
                                                {Course, tr("Course")},
                                                {Existence, tr("Existence")},
                                                {Looks, tr("Looks, missed")},
                                                {Particles, tr("Particles that count")},
                                                {Innovation, tr("Echo off prediction")},
                                                {Area, tr("Area, due → seen")},
                                                {Moment, tr("Moment, due → seen")},
                                                {Strength, tr("Strength, due → seen")}};
    int cell = 0;
    for (const auto& [value, name] : labels) {
        auto* label = new QLabel(name, this);
        label->setFont(metrics.sized(font(), 11));
        label->setForegroundRole(QPalette::PlaceholderText);
        auto* number = new QLabel(Formatter::unknown(), this);
        number->setTextInteractionFlags(Qt::TextSelectableByMouse);
        grid->addWidget(label, 2 * (cell / 2), cell % 2);
        grid->addWidget(number, 2 * (cell / 2) + 1, cell % 2);
        values_[value] = number;
        ++cell;
    }
    title_->setText(tr("No track selected"));
}

void TrackCard::set(Value value, const QString& text) { values_[value]->setText(text); }

void TrackCard::show(const Track* track, const Scene& scene) {
    if (!track) {
        title_->setText(tr("No track selected"));
        for (const auto& [value, label] : values_) label->setText(Formatter::unknown());
        return;
    }
    title_->setText(Formatter::trackId(track->id) + (track->target ? tr("  designated target") : QString()));
    const Pose& pose = scene.latest.pose;
    const Eigen::Vector2d sight = track->estimate.mean.head<2>() - Eigen::Vector2d(pose.north_m, pose.east_m);
    const double range = std::max(sight.norm(), 1e-3);
    const Eigen::Vector2d along = sight / range, across(-along.y(), along.x());
    const Eigen::Matrix2d covariance = track->estimate.covariance.topLeftCorner<2, 2>();
    const double along_sigma = std::sqrt(std::max(along.dot(covariance * along), 0.0));
    const double across_sigma = std::sqrt(std::max(across.dot(covariance * across), 0.0));
    set(Range, QString("%1 ± %2").arg(Formatter::range(range), Formatter::rangeNumber(along_sigma)));
    const Bearing azimuth = Bearing::radians(std::atan2(sight.y(), sight.x()));
    set(BearingValue, QString("%1 ± %2°")
                          .arg(Formatter::relativeBearing(Bearing::radians(azimuth - pose.heading)),
                               Formatter::number(degreesFromRadians(std::atan2(across_sigma, range)), 1)));
    set(Age, Formatter::age(secondsBetween(track->last_seen, scene.latest.time)));
    const Eigen::Vector2d velocity = track->estimate.mean.tail<2>();
    const bool moves = track->looks >= 2;  // after one look the velocity is the filter's starting value
    set(Speed, moves ? Formatter::speed(velocity.norm()) : Formatter::unknown());
    set(Course, moves ? Formatter::trueBearing(Bearing::radians(std::atan2(velocity.y(), velocity.x())))
                      : Formatter::unknown());
    set(Existence, Formatter::probability(track->existence));
    set(Looks, QString("%1, %2").arg(track->looks).arg(track->misses));
    const auto particles = track->particles.weight.size();
    set(Particles, particles == 0 ? Formatter::unknown()
                                  : tr("%1 of %2")
                                        .arg(Formatter::count(static_cast<std::uint64_t>(track->particles.effective)),
                                             Formatter::count(particles)));
    set(Innovation,
        moves ? QString("%1, NIS %2").arg(Formatter::range(track->innovation_m), Formatter::number(track->nis, 1))
              : Formatter::unknown());
    const RegionFeatures &due = track->expected_features, &seen = track->seen_features;
    set(Area, expectedAndSeen(due.area_m2, seen.area_m2, 2, "m²"));
    set(Moment, expectedAndSeen(due.moment, seen.moment, 2, {}));
    set(Strength, expectedAndSeen(due.strength_db, seen.strength_db, 0, "dB"));
}

}  // namespace echotrail
