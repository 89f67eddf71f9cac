#include "ui/main_window/tour_panel.hpp"

#include "ui/language/language.hpp"
#include "ui/style/label_role.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace echotrail {

TourPanel::TourPanel(QWidget* parent) : QWidget(parent) {
    title_ = new QLabel(this);
    title_->setObjectName("title");
    title_->setWordWrap(true);
    text_ = new QLabel(this);
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::RichText);
    state_ = new QLabel(this);
    back_ = new QPushButton(this);
    next_ = new QPushButton(this);
    leave_ = new QPushButton(this);
    auto* column = new QVBoxLayout(this);
    const int gap = UiMetrics(font()).pixels(8.0);
    column->setContentsMargins(gap, gap, gap, gap);
    column->setSpacing(gap);
    column->addWidget(title_);
    column->addWidget(text_);
    column->addWidget(state_);
    auto* row = new QHBoxLayout;
    row->addWidget(leave_);
    row->addStretch(1);
    row->addWidget(back_);
    row->addWidget(next_);
    column->addLayout(row);
    column->addStretch(1);
    connect(back_, &QPushButton::clicked, this, [this] { goTo(step_ - 1); });
    connect(next_, &QPushButton::clicked, this, [this] { goTo(step_ + 1); });
    connect(leave_, &QPushButton::clicked, this, &TourPanel::ended);
    inEveryLanguage(this, [this] { showStep(); });
}

void TourPanel::start() {
    std::fill(std::begin(done_), std::end(done_), false);
    goTo(0);
}

void TourPanel::did(Step step) {
    done_[step] = true;
    if (step == step_) showStep();
}

void TourPanel::goTo(int step) {
    if (step >= StepCount) return Q_EMIT ended();
    step_ = std::max(step, 0);
    showStep();
}

void TourPanel::showStep() {
    const std::pair<QString, QString> steps[StepCount] = {
        {tr("Point at your target"),
         tr("A simulated approach is playing. Wait until an echo has a blue circle, and <b>click</b> it: brackets show "
            "that it is the target now. <b>Tracks</b>, on the right, says where it is and why its last echo was "
            "taken. <b>Delete</b> takes the designation back.")},
        {tr("Mark and measure"),
         tr("Put the cursor on the fan and press <b>K</b>: a mark stays at that place of the ground. <b>M</b> measures "
            "between two places: click one, then the other; <b>Esc</b> puts the measure away.")},
        {tr("Change a parameter"),
         tr("<b>Ctrl+F</b>, type <b>seed excess</b>, press the down key, type a number and <b>Enter</b>. The picture "
            "follows at once; <b>Ctrl+Z</b> takes it back, as it does a mark. <b>F1</b> explains what the mouse points "
            "at, <b>?</b> shows all keys.")}};
    title_->setText(tr("Step %1 of %2: %3").arg(step_ + 1).arg(int(StepCount)).arg(steps[step_].first));
    text_->setText(steps[step_].second);
    state_->setText(done_[step_] ? tr("✓ Done.") : tr("Try it now, or go on."));
    setLabelRole(*state_, done_[step_] ? "good" : "dim");
    back_->setText(tr("Back"));
    back_->setEnabled(step_ > 0);
    next_->setText(step_ + 1 < StepCount ? tr("Next") : tr("Finish"));
    leave_->setText(tr("Leave the tour"));
    leave_->setToolTip(tr("Help → Tour brings it back"));
}

}  // namespace echotrail
