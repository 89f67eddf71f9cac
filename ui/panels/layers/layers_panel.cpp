#include "ui/panels/layers/layers_panel.hpp"

#include "ui/panels/layers/layer_icon.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/fan_view.hpp"
#include "ui/views/orientation.hpp"
#include "ui/views/track_painter.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace echotrail {
namespace {

constexpr int least_span_db = 5;  ///< between black and white

QLabel* named(const QString& text, const char* name, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setObjectName(name);
    return label;
}

}  // namespace

LayersPanel::LayersPanel(FanView& fan, QWidget* parent) : QWidget(parent), fan_(fan) {
    column_ = new QVBoxLayout(this);
    column_->setSpacing(UiMetrics(font()).pixels(3.0));
    addLayerRows();
    addOrientation();
    addEcho();
    column_->addStretch(1);
    connect(&fan_, &FanView::settingsChanged, this, &LayersPanel::readFan);
    readFan();
}

void LayersPanel::addLayerRows() {
    struct Row {
        QString title;
        LayerSymbol symbol;
        bool Layers::*layer;
    };
    const std::array rows{Row{tr("Echo"), LayerSymbol::Echo, &Layers::echoes},
                          Row{tr("Enhanced picture"), LayerSymbol::Echo, &Layers::enhanced},
                          Row{tr("Moving only"), LayerSymbol::Moving, &Layers::moving},
                          Row{tr("Regions kept"), LayerSymbol::RegionKept, &Layers::regions_kept},
                          Row{tr("Regions dropped"), LayerSymbol::RegionDropped, &Layers::regions_dropped},
                          Row{tr("Particles"), LayerSymbol::Particles, &Layers::particles},
                          Row{tr("Tracks"), LayerSymbol::Track, &Layers::tracks},
                          Row{tr("Ellipses 1σ · 95 %"), LayerSymbol::Ellipses, &Layers::ellipses},
                          Row{tr("History, prediction"), LayerSymbol::History, &Layers::history},
                          Row{tr("Region of interest"), LayerSymbol::RegionOfInterest, &Layers::region_of_interest},
                          Row{tr("Guard zones"), LayerSymbol::GuardZone, &Layers::guard_zones},
                          Row{tr("Veto areas"), LayerSymbol::Veto, &Layers::vetoes},
                          Row{tr("Marks"), LayerSymbol::Mark, &Layers::marks},
                          Row{tr("Echo trails"), LayerSymbol::Trail, &Layers::trails},
                          Row{tr("Rings and bearings"), LayerSymbol::Graticule, &Layers::graticule},
                          Row{tr("Target ×4"), LayerSymbol::Inset, &Layers::inset}};
    auto* grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const Row& row = rows[static_cast<std::size_t>(i)];
        auto* box = new QCheckBox(row.title, this);
        auto* count = named({}, "dim", this);
        grid->addWidget(new LayerIcon(row.symbol, this), i, 0);
        grid->addWidget(box, i, 1);
        grid->addWidget(count, i, 2, Qt::AlignRight);
        layers_ << LayerRow{row.layer, box, count};
        connect(box, &QCheckBox::toggled, this, [this, layer = row.layer](bool on) {
            if (reading_) return;
            Layers changed = fan_.layers();
            changed.*layer = on;
            fan_.setLayers(changed);
        });
    }
    column_->addLayout(grid);
}

void LayersPanel::addOrientation() {
    column_->addWidget(named(tr("Orientation"), "section", this));
    head_up_ = new QPushButton(tr("Head up"), this);
    north_up_ = new QPushButton(tr("North up"), this);
    course_up_ = new QPushButton(tr("Course up"), this);
    orientation_note_ = named({}, "dim", this);
    orientation_note_->setWordWrap(true);
    orientation_note_->hide();
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {head_up_, north_up_, course_up_}) {
        button->setCheckable(true);
        button->setAutoExclusive(true);
        // Three of the style's usual width would make the whole dock wider.
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) +
                                UiMetrics(font()).pixels(14.0));
        row->addWidget(button);
    }
    column_->addLayout(row);
    column_->addWidget(orientation_note_);
    connect(head_up_, &QPushButton::clicked, this, [this] { fan_.setOrientation(Orientation::HeadUp); });
    connect(north_up_, &QPushButton::clicked, this, [this] { fan_.setOrientation(Orientation::NorthUp); });
    connect(course_up_, &QPushButton::clicked, this, [this] { fan_.setOrientation(Orientation::CourseUp); });
}

LayersPanel::Level LayersPanel::addLevel(const QString& name, int least, int most) {
    const UiMetrics metrics(font());
    Level level{new QSlider(Qt::Horizontal, this), new QLabel(this)};
    level.slider->setRange(least, most);
    level.slider->setAccessibleName(name);
    level.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    level.value->setMinimumWidth(metrics.pixels(44.0));
    auto* title = named(name, "dim", this);
    title->setMinimumWidth(metrics.pixels(76.0));
    auto* row = new QHBoxLayout;
    row->addWidget(title);
    row->addWidget(level.slider, 1);
    row->addWidget(level.value);
    column_->addLayout(row);
    return level;
}

void LayersPanel::addEcho() {
    column_->addWidget(named(tr("Echo levels"), "section", this));
    map_ = new QComboBox(this);
    map_->setAccessibleName(tr("Colour map"));
    for (const EchoMap map : echo_maps) map_->addItem(echoMapTitle(map));
    auto* row = new QHBoxLayout;
    row->addWidget(named(tr("Colours"), "dim", this));
    row->addWidget(map_, 1);
    column_->addLayout(row);
    black_ = addLevel(tr("Black at"), 0, 80 - least_span_db);
    white_ = addLevel(tr("White at"), least_span_db, 80);
    fade_ = addLevel(tr("Fade by age"), 0, static_cast<int>(std::lround(100.0 * most_fade)));
    connect(map_, &QComboBox::currentIndexChanged, this, [this] { writeEcho(true); });
    connect(black_.slider, &QSlider::valueChanged, this, [this] { writeEcho(true); });
    connect(white_.slider, &QSlider::valueChanged, this, [this] { writeEcho(false); });
    connect(fade_.slider, &QSlider::valueChanged, this, [this] { writeEcho(true); });
}

void LayersPanel::writeEcho(bool black_moved) {
    if (reading_) return;
    EchoSettings echo = fan_.echo();
    echo.map = echo_maps[static_cast<std::size_t>(std::max(map_->currentIndex(), 0))];
    int black = black_.slider->value();
    int white = white_.slider->value();
    // The one that is moved pushes the other before it.
    if (black_moved)
        white = std::max(white, black + least_span_db);
    else
        black = std::min(black, white - least_span_db);
    echo.black_db = black;
    echo.white_db = white;
    echo.fade = fade_.slider->value() / 100.0;
    fan_.setEcho(echo);
}

void LayersPanel::readFan() {
    reading_ = true;
    for (const LayerRow& row : layers_) row.box->setChecked(fan_.layers().*row.layer);
    const bool north = fan_.orientation() == Orientation::NorthUp;
    const bool course = fan_.orientation() == Orientation::CourseUp;
    (north ? north_up_ : course ? course_up_ : head_up_)->setChecked(true);
    const EchoSettings& echo = fan_.echo();
    map_->setCurrentIndex(static_cast<int>(echo.map));
    const auto show = [](const Level& level, double value, const QString& unit) {
        level.slider->setValue(static_cast<int>(std::lround(value)));
        level.value->setText(Formatter::withUnit(value, 0, unit));
    };
    show(black_, echo.black_db, "dB");
    show(white_, echo.white_db, "dB");
    show(fade_, 100.0 * echo.fade, "%");
    reading_ = false;
}

void LayersPanel::setScene(const Scene& scene) {
    const auto dropped = std::count_if(scene.regions.begin(), scene.regions.end(), isDropped);
    std::size_t particles = 0;
    for (const Track& track : scene.tracks)
        if (track.target || particles == 0) particles = track.particles.size();
    const auto count = [this](bool Layers::*layer, std::size_t number) {
        for (const LayerRow& row : layers_)
            if (row.layer == layer) row.count->setText(Formatter::count(number));
    };
    count(&Layers::regions_kept, scene.regions.size() - static_cast<std::size_t>(dropped));
    count(&Layers::regions_dropped, static_cast<std::size_t>(dropped));
    count(&Layers::particles, particles);
    count(&Layers::tracks, scene.tracks.size());
    QStringList missing;
    for (const auto& [button, orientation] :
         {std::pair{north_up_, Orientation::NorthUp}, std::pair{course_up_, Orientation::CourseUp}}) {
        const QString input = missingInput(scene, orientation);
        button->setEnabled(input.isEmpty() || fan_.orientation() == orientation);
        if (!input.isEmpty()) missing << input;
    }
    orientation_note_->setText(missing.join('\n'));
    orientation_note_->setVisible(!missing.isEmpty());
}

}  // namespace echotrail
