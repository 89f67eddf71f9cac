#include "ui/main_window/start_page.hpp"

#include "ui/language/language.hpp"
#include "ui/style/palette.hpp"

#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <algorithm>

namespace echotrail {
namespace {

QFont scaled(QFont font, double factor, bool bold) {
    if (font.pixelSize() > 0)
        font.setPixelSize(qRound(font.pixelSize() * factor));
    else
        font.setPointSizeF(font.pointSizeF() * factor);
    if (bold) font.setWeight(QFont::DemiBold);
    return font;
}

}  // namespace

StartChoice::StartChoice(Picture picture, QWidget* parent) : QAbstractButton(parent), picture_(picture) {
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
}

void StartChoice::setWords(const QString& title, const QString& text, const QString& key) {
    title_ = title;
    text_ = text;
    key_ = key;
    setFact(fact_);
}

void StartChoice::setFact(const QString& fact) {
    fact_ = fact;
    setAccessibleName(title_);
    setAccessibleDescription(text_ + " " + fact_);
    update();
}

QSize StartChoice::sizeHint() const { return {fontMetrics().averageCharWidth() * 78, fontMetrics().height() * 25 / 4}; }

/// In a low window the fact gives way.
QSize StartChoice::minimumSizeHint() const {
    return {fontMetrics().averageCharWidth() * 40, fontMetrics().height() * 21 / 4};
}

void StartChoice::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

void StartChoice::paintPicture(QPainter& painter, const QRectF& box) const {
    const Palette& colours = currentPalette();
    painter.fillRect(box, colours.canvas);
    painter.setPen(QPen(colours.dim, 1.4));
    painter.setBrush(Qt::NoBrush);
    const double u = box.height() / 10.0;
    const QPointF c = box.center();
    switch (picture_) {
        case Picture::Fan: {
            const QPointF head(c.x(), box.bottom() - u);
            for (const double radius : {4.0 * u, 7.5 * u})
                painter.drawArc(QRectF(head.x() - radius, head.y() - radius, 2 * radius, 2 * radius), 45 * 16, 90 * 16);
            painter.drawLine(head, head + QPointF(-5.3 * u, -5.3 * u));
            painter.drawLine(head, head + QPointF(5.3 * u, -5.3 * u));
            painter.setPen(QPen(colours.track, 1.8));
            painter.drawEllipse(head + QPointF(1.2 * u, -5.0 * u), 0.9 * u, 0.9 * u);
            break;
        }
        case Picture::Head: {
            // A head hanging below the surface, and the sound it sends out.
            const QPointF head(box.left() + 4.0 * u, c.y() + u);
            painter.drawLine(QPointF(box.left() + 2 * u, box.top() + 2 * u),
                             QPointF(box.right() - 2 * u, box.top() + 2 * u));
            painter.drawLine(QPointF(head.x(), box.top() + 2 * u), head);
            painter.drawEllipse(head, u, u);
            for (const double radius : {3.0 * u, 5.0 * u})
                painter.drawArc(QRectF(head.x() - radius, head.y() - radius, 2 * radius, 2 * radius), -35 * 16,
                                70 * 16);
            break;
        }
        case Picture::TimeLine: {
            const QRectF lane(box.left() + 2 * u, c.y() - 1.5 * u, box.width() - 4 * u, 3 * u);
            painter.drawRect(lane);
            painter.fillRect(QRectF(lane.left() + 3 * u, lane.top() + 1.0 * u, 4 * u, u), colours.accent);
            painter.setPen(QPen(colours.text, 1.6));
            painter.drawLine(QPointF(c.x(), lane.top() - 2 * u), QPointF(c.x(), lane.bottom() + u));
            break;
        }
        case Picture::List:
            for (int row = 0; row < 3; ++row) {
                const double y = box.top() + (2.2 + 2.2 * row) * u;
                painter.drawRect(QRectF(box.left() + 2 * u, y, 1.2 * u, 1.2 * u));
                painter.drawLine(QPointF(box.left() + 4.4 * u, y + 0.6 * u), QPointF(box.right() - 2 * u, y + 0.6 * u));
            }
            break;
    }
}

void StartChoice::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& colours = currentPalette();
    const double line = fontMetrics().height();
    painter.fillRect(rect(), isEnabled() && underMouse() ? colours.selected : colours.raised);
    const bool focus = hasFocus() || window()->focusWidget() == this;  // also while the window itself has none
    painter.setPen(QPen(focus ? colours.accent : colours.strong_line, focus ? 2.0 : 1.0));
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    const QRectF picture(0.6 * line, 0.6 * line, 8.0 * line, height() - 1.2 * line);
    paintPicture(painter, picture);

    const double left = picture.right() + line;
    const double key_width = key_.isEmpty() ? 0.0 : fontMetrics().horizontalAdvance(key_) + line;
    const QRectF words(left, 0.7 * line, width() - left - key_width - line, height() - 1.4 * line);
    painter.setFont(scaled(font(), 1.4, true));
    painter.setPen(isEnabled() ? colours.text : colours.off);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignTop, title_);
    const double title_height = 1.2 * QFontMetrics(painter.font()).height();
    painter.setFont(font());
    painter.setPen(isEnabled() ? colours.dim : colours.off);
    QRectF text;
    painter.drawText(words.adjusted(0, title_height, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text_,
                     &text);
    painter.setPen(isEnabled() ? colours.text : colours.off);
    if (text.bottom() + line <= words.bottom() + 1.0)
        painter.drawText(words, Qt::AlignLeft | Qt::AlignBottom,
                         fontMetrics().elidedText(fact_, Qt::ElideMiddle, static_cast<int>(words.width())));
    if (key_.isEmpty()) return;
    const QRectF cap(width() - key_width - 0.8 * line, (height() - 1.5 * line) / 2, key_width, 1.5 * line);
    painter.setPen(QPen(colours.strong_line, 1.0));
    painter.drawRect(cap);
    painter.setPen(colours.dim);
    painter.drawText(cap, Qt::AlignCenter, key_);
}

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    heading_ = new QLabel(this);
    heading_->setFont(scaled(font(), 1.65, true));
    heading_->setObjectName("on_canvas");
    demonstration_ = new StartChoice(StartChoice::Picture::Fan, this);
    connect_ = new StartChoice(StartChoice::Picture::Head, this);
    open_ = new StartChoice(StartChoice::Picture::TimeLine, this);
    recent_ = new StartChoice(StartChoice::Picture::List, this);
    connect(demonstration_, &QAbstractButton::clicked, this, &StartPage::demonstrationChosen);
    connect(connect_, &QAbstractButton::clicked, this, &StartPage::connectChosen);
    connect(open_, &QAbstractButton::clicked, this, &StartPage::openChosen);
    connect(recent_, &QAbstractButton::clicked, this, [this] {
        if (!paths_.isEmpty()) Q_EMIT recentChosen(paths_.front());
    });
    auto* column = new QVBoxLayout;
    column->setSpacing(fontMetrics().height() * 2 / 3);
    column->addStretch(2);
    for (QWidget* part : std::initializer_list<QWidget*>{heading_, demonstration_, connect_, open_, recent_})
        column->addWidget(part);
    column->addStretch(3);
    auto* across = new QHBoxLayout(this);
    across->addStretch(1);
    across->addLayout(column);
    across->addStretch(1);
    inEveryLanguage(this, [this] { nameAll(); });
}

void StartPage::nameAll() {
    heading_->setText(tr("What do you want to look at?"));
    demonstration_->setWords(tr("Demonstration"),
                             tr("A simulated approach at 50 m range, with the tracker running. Nothing is "
                                "connected or sent."),
                             tr("Enter"));
    demonstration_->setFact(tr("works offline"));
    connect_->setWords(tr("Connect to a sonar head"),
                       tr("A SeaKing on a serial port, or by TCP or UDP. It scans as soon as it answers; all "
                          "of it is recorded."),
                       "Ctrl+L");
    connect_->setFact(tr("serial, TCP, UDP"));
    open_->setWords(tr("Open a recording"),
                    tr("An .echotrail log, a Seanet Pro .V4LOG or a raw .bin. Read only; or drop the file on this "
                       "window."),
                    "Ctrl+O");
    open_->setFact(tr("UTC as recorded"));
    recent_->setWords(tr("Open the last one again"), tr("The recording this console showed most recently."),
                      "Ctrl+Shift+O");
    setRecent(paths_);
}

void StartPage::setRecent(const QStringList& paths) {
    paths_ = paths;
    recent_->setEnabled(!paths.isEmpty());
    recent_->setFact(paths.isEmpty() ? tr("No recent recordings") : QFileInfo(paths.front()).fileName());
}

void StartPage::focusFirst() { demonstration_->setFocus(Qt::OtherFocusReason); }

void StartPage::paintEvent(QPaintEvent*) {
    // A faint empty fan behind, so that the place is known before there is anything in it.
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& colours = currentPalette();
    painter.fillRect(rect(), colours.canvas);
    painter.setPen(QPen(colours.line, 1.0));
    const QPointF head(width() / 2.0, height() * 0.95);
    const double radius = std::min(width() * 0.65, height() * 0.85);
    for (int ring = 1; ring <= 5; ++ring) {
        const double r = radius * ring / 5.0;
        painter.drawArc(QRectF(head.x() - r, head.y() - r, 2 * r, 2 * r), 45 * 16, 90 * 16);
    }
    const double side = radius * 0.70711;
    for (const double across : {-side, 0.0, side})
        painter.drawLine(head, head - QPointF(across, across == 0.0 ? radius : side));
}

}  // namespace echotrail
