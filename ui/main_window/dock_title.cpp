#include "ui/main_window/dock_title.hpp"

#include "ui/style/palette.hpp"

#include <QAbstractButton>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

namespace echotrail {
namespace {

/// A small drawn sign: a cross, or two panes.
class TitleButton : public QAbstractButton {
public:
    TitleButton(bool cross, QWidget* parent) : QAbstractButton(parent), cross_(cross) { setFocusPolicy(Qt::TabFocus); }
    void setName(const QString& name) {
        setAccessibleName(name);
        setToolTip(name);
    }
    QSize sizeHint() const override { return {fontMetrics().height() * 5 / 4, fontMetrics().height() * 5 / 4}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const bool hot = underMouse() || hasFocus();
        painter.setPen(QPen(hot ? currentPalette().text : currentPalette().dim, fontMetrics().height() / 12.0));
        const double half = 0.25 * fontMetrics().height();
        painter.translate(QRectF(rect()).center());
        if (cross_) {
            painter.drawLine(QPointF(-half, -half), QPointF(half, half));
            painter.drawLine(QPointF(-half, half), QPointF(half, -half));
        } else {
            painter.drawRect(QRectF(-half, -half / 2, 1.4 * half, 1.4 * half));
            painter.drawPolyline(
                QPolygonF({QPointF(-half / 3, -half / 2), QPointF(-half / 3, -half), QPointF(half, -half),
                           QPointF(half, half / 3), QPointF(half * 0.4, half / 3)}));
        }
    }

private:
    bool cross_;
};

}  // namespace

DockTitle::DockTitle(QDockWidget* dock) : QWidget(dock) {
    auto* title = new QLabel(this);
    QFont strong = font();
    strong.setWeight(QFont::DemiBold);
    title->setFont(strong);
    summary_ = new QLabel(this);
    summary_->setObjectName("dim");
    auto* layout_widget = new TitleButton(false, this);
    auto* close = new TitleButton(true, this);
    connect(dock, &QWidget::windowTitleChanged, this, [this, title, layout_widget, close](const QString& name) {
        title->setText(name);
        layout_widget->setName(tr("Float or dock “%1”").arg(name));
        close->setName(tr("Close “%1”; the Window menu brings it back").arg(name));
    });
    auto* row = new QHBoxLayout(this);
    const int gap = fontMetrics().height() / 2;
    row->setContentsMargins(gap, gap / 3, gap / 2, gap / 3);
    row->setSpacing(gap);
    row->addWidget(title);
    row->addWidget(summary_, 1);
    row->addWidget(layout_widget);
    row->addWidget(close);
    connect(layout_widget, &QAbstractButton::clicked, dock, [dock] { dock->setFloating(!dock->isFloating()); });
    connect(close, &QAbstractButton::clicked, dock, &QDockWidget::close);
}

void DockTitle::setSummary(const QString& summary) { summary_->setText(summary); }

void DockTitle::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), currentPalette().raised);
    painter.fillRect(QRect(0, height() - 1, width(), 1), currentPalette().line);
}

QDockWidget* makeDock(const QString& object_name, QWidget* content, QWidget* parent) {
    auto* dock = new QDockWidget(parent);
    dock->setObjectName(object_name);
    dock->setWidget(content);
    dock->setTitleBarWidget(new DockTitle(dock));
    return dock;
}

void setSummary(QDockWidget* dock, const QString& summary) {
    static_cast<DockTitle*>(dock->titleBarWidget())->setSummary(summary);
}

}  // namespace echotrail
