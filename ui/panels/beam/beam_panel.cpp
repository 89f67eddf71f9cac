#include "ui/panels/beam/beam_panel.hpp"

#include "core/data/beam_line.hpp"
#include "core/data/ping.hpp"
#include "ui/language/language.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/graticule_painter.hpp"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double reach_rad = radiansFromDegrees(2.0);
constexpr int db_step = 20;

double dbOf(std::uint8_t level) { return level / levels_per_db; }

/// The highest cell of those where something can be detected: the transducer's ringing is none.
std::size_t peakCell(const BeamLine& line) {
    std::size_t highest = 0;
    int most = -1;
    for (std::size_t i = 0; i < line.level.size(); ++i) {
        const bool blank = i < line.threshold.size() && line.threshold[i] == BeamLine::never;
        if (blank || line.level[i] <= most) continue;
        most = line.level[i];
        highest = i;
    }
    return highest;
}

}  // namespace

std::shared_ptr<const BeamLine> lineTowards(const Scene& scene, Bearing from_north) {
    std::shared_ptr<const BeamLine> nearest;
    for (const auto& line : scene.lines) {
        if (!line || std::abs(line->from_north - from_north) > reach_rad) continue;
        const double away = std::abs(line->from_north - from_north);
        if (!nearest || away < std::abs(nearest->from_north - from_north)) nearest = line;
    }
    return nearest;
}

/// Where range and level lie on the widget.
struct BeamPanel::Axes {
    QRectF box;
    double range_m = 1.0;

    double x(double metres) const { return box.left() + box.width() * metres / range_m; }
    double y(double db) const { return box.bottom() - box.height() * std::clamp(db / full_scale_db, 0.0, 1.0); }
};

BeamPanel::BeamPanel(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    inEveryLanguage(this, [this] { setAccessibleName(tr("Beam")); });
}

QSize BeamPanel::sizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(640.0), metrics.pixels(150.0)};
}

QSize BeamPanel::minimumSizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(240.0), metrics.pixels(90.0)};
}

void BeamPanel::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    choose();
}

void BeamPanel::setCursor(const std::optional<Eigen::Vector2d>& place) {
    cursor_ = place;
    choose();
}

void BeamPanel::setSelectedTrack(int id) {
    selected_track_ = id;
    choose();
}

std::optional<Eigen::Vector2d> BeamPanel::trackPlace() const {
    std::optional<Eigen::Vector2d> place;
    for (const Track& track : scene_->tracks) {
        if (!track.target && (track.id != selected_track_ || place)) continue;
        place = Eigen::Vector2d(track.estimate.mean.head<2>());
        if (track.target) break;
    }
    return place;
}

void BeamPanel::choose() {
    line_.reset();
    marked_range_m_.reset();
    source_.clear();
    if (scene_) {
        const auto place = cursor_ ? cursor_ : trackPlace();
        if (place) {
            const Pose& pose = scene_->latest.pose;
            const Eigen::Vector2d away = *place - Eigen::Vector2d(pose.north_m, pose.east_m);
            line_ = lineTowards(*scene_, Bearing::radians(std::atan2(away.y(), away.x())));
            if (line_) marked_range_m_ = away.norm();
            source_ = cursor_ ? tr("under the cursor") : tr("on the target");
        }
        if (!line_) {
            line_ = scene_->live_line;
            source_ = tr("live");
        }
    }
    update();
    if (const QString summary = line_ ? source_ : QString(); summary != summary_) {
        summary_ = summary;
        Q_EMIT summaryChanged(summary_);
    }
}

QString BeamPanel::reading() const {
    if (!line_ || line_->level.empty()) return tr("No beam yet");
    const std::size_t cell = peakCell(*line_);
    const std::uint8_t peak = line_->level[cell];
    QString text = tr("%1, %2 old   peak %3 at %4")
                       .arg(Formatter::relativeBearing(line_->from_bow),
                            Formatter::age(secondsBetween(line_->time, scene_->latest.time)),
                            Formatter::withUnit(dbOf(peak), 0, "dB"),
                            Formatter::range((static_cast<double>(cell) + 0.5) * line_->cell_m));
    if (line_->threshold.empty()) return text + "   " + tr("threshold not told");
    const std::uint8_t limit = line_->threshold[cell];
    text +=
        "   " + (limit == BeamLine::never ? tr("nothing is detected there")
                                          : tr("threshold there %1").arg(Formatter::withUnit(dbOf(limit), 0, "dB")));
    const auto full = std::count(line_->level.begin(), line_->level.end(), 255);
    return text + "   " + tr("saturated cells %1").arg(full);
}

void BeamPanel::paintGrid(QPainter& painter, const Axes& axes) const {
    const Palette& palette = currentPalette();
    const QFontMetricsF metrics(painter.font(), this);
    const auto text = [&](double x, double y, const QString& words, bool left_of) {
        painter.setPen(palette.dim);
        const double width = metrics.horizontalAdvance(words);
        painter.drawText(QPointF(left_of ? x - width : x - width / 2.0, y), words);
    };
    for (int db = 0; db <= 80; db += db_step) {
        painter.setPen(palette.line);
        painter.drawLine(QPointF(axes.box.left(), axes.y(db)), QPointF(axes.box.right(), axes.y(db)));
        const QString words = db == 80 ? Formatter::withUnit(db, 0, "dB") : Formatter::number(db, 0);
        text(axes.box.left() - metrics.averageCharWidth() * 0.7, axes.y(db) + metrics.ascent() / 2.5, words, true);
    }
    const double step = ringStep(axes.range_m);
    for (int i = 0; i * step <= axes.range_m * 1.001; ++i) {
        const double x = axes.x(i * step);
        painter.setPen(palette.line);
        painter.drawLine(QPointF(x, axes.box.top()), QPointF(x, axes.box.bottom()));
        const bool last = (i + 1) * step > axes.range_m * 1.001;
        text(x, axes.box.bottom() + metrics.ascent() * 1.15,
             Formatter::number(i * step, step < 1.0 ? 1 : 0) + (last ? " m" : ""), false);
    }
}

void BeamPanel::paintLine(QPainter& painter, const Axes& axes, const std::vector<std::uint8_t>& levels, double cell_m,
                          const QPen& pen) const {
    painter.setPen(pen);
    QPolygonF run;
    const auto draw = [&] {
        if (run.size() > 1) painter.drawPolyline(run);
        run.clear();
    };
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (&levels == &line_->threshold && levels[i] == BeamLine::never)
            draw();
        else
            run << QPointF(axes.x((static_cast<double>(i) + 0.5) * cell_m), axes.y(dbOf(levels[i])));
    }
    draw();
}

void BeamPanel::paintPlace(QPainter& painter, const Axes& axes) const {
    if (!marked_range_m_ || *marked_range_m_ > axes.range_m) return;
    painter.setPen(QPen(currentPalette().accent, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(axes.x(*marked_range_m_), axes.box.top()),
                     QPointF(axes.x(*marked_range_m_), axes.box.bottom()));
}

void BeamPanel::paintReading(QPainter& painter) const {
    const QFontMetrics metrics(painter.font(), this);
    const int edge = metrics.averageCharWidth();
    const QRect row(edge, 0, width() - 2 * edge, metrics.height() + 2);
    painter.setPen(currentPalette().text);
    const QString keys = tr("bright: this beam   grey: live   dashes: threshold");
    const bool room = metrics.horizontalAdvance(reading() + keys) + 3 * edge < row.width();
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(reading(), Qt::ElideRight, row.width()));
    painter.setPen(currentPalette().dim);
    if (room) painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, keys);
}

void BeamPanel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& palette = currentPalette();
    const UiMetrics metrics(font());
    painter.fillRect(rect(), palette.field);
    painter.setFont(metrics.sized(font(), 11.0));
    paintReading(painter);
    if (!line_ || line_->level.empty()) return;
    painter.setFont(metrics.sized(font(), 10.0));
    const double line = QFontMetricsF(painter.font(), this).height();
    const Axes axes{QRectF(rect()).adjusted(3.4 * line, 1.9 * line, -1.5 * line, -1.4 * line),
                    line_->cell_m * static_cast<double>(line_->level.size())};
    paintGrid(painter, axes);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto& live = scene_->live_line;
    if (live && live != line_) paintLine(painter, axes, live->level, live->cell_m, QPen(palette.off, 1.0));
    paintLine(painter, axes, line_->level, line_->cell_m, QPen(palette.text, 1.4));
    paintLine(painter, axes, line_->threshold, line_->cell_m, QPen(palette.warning, 1.2, Qt::DashLine));
    paintPlace(painter, axes);
}

void BeamPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) update();
    QWidget::changeEvent(event);
}

}  // namespace echotrail
