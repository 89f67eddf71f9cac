#include "ui/main_window/message_strip.hpp"

#include "ui/language/language.hpp"
#include "ui/style/palette.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace echotrail {

MessageStrip::MessageStrip(QWidget* parent) : QFrame(parent) {
    label_ = new QLabel(this);
    label_->setWordWrap(true);
    label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long path does not widen the window
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    button_ = new QPushButton(this);
    button_->setFocusPolicy(Qt::TabFocus);
    auto* layout = new QHBoxLayout(this);
    const int gap = fontMetrics().height() / 3;
    layout->setContentsMargins(3 * gap, gap, gap, gap);
    layout->addWidget(label_, 1);
    layout->addWidget(button_);
    connect(button_, &QPushButton::clicked, this, [this] {
        if (busy_) Q_EMIT cancelled();
        clear();
    });
    inEveryLanguage(this, [this] { nameButton(); });
    hide();
}

void MessageStrip::say(Kind kind, const QString& text) {
    kind_ = kind;
    busy_ = false;
    label_->setText(text);
    nameButton();
    setAccessibleName(text);
    show();
    update();
}

void MessageStrip::sayBusy(const QString& text) {
    say(Kind::Notice, text);
    busy_ = true;
    nameButton();
}

void MessageStrip::nameButton() { button_->setText(busy_ ? tr("Cancel") : tr("Close")); }

void MessageStrip::clear() {
    busy_ = false;
    label_->clear();
    hide();
}

QString MessageStrip::text() const { return label_->text(); }

void MessageStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& colours = currentPalette();
    painter.fillRect(rect(), colours.raised);
    const int edge = fontMetrics().height() / 4;
    painter.fillRect(QRect(0, 0, edge, height()), kind_ == Kind::Problem ? colours.warning : colours.accent);
    painter.fillRect(QRect(0, height() - 1, width(), 1), colours.line);
}

}  // namespace echotrail
