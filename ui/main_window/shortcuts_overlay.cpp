#include "ui/main_window/shortcuts_overlay.hpp"

#include "ui/language/language.hpp"
#include "ui/style/palette.hpp"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <array>
#include <utility>

namespace echotrail {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 41> keys{{
    {"Space", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "play or pause")},
    {"← →", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "5 s back or on")},
    {"Shift ← →", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "one sweep back or on")},
    {"Ctrl ← →", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "one ping back or on")},
    {"Home End", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "start, end of the recording")},
    {", .", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "slower, faster")},
    {"Click", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "on an echo or a track: designate it")},
    {"Ctrl Enter", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "designate the selected track")},
    {"Ctrl R", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "name the selected track")},
    {"Ctrl M", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "mute the selected track: no alerts about it")},
    {"Delete", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "clear the designation")},
    {"Shift Delete", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "drop the selected track; Ctrl Z takes it back")},
    {"Ctrl click", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "on a track: read its card")},
    {"A", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "acknowledge the alert on top")},
    {"Shift A", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "silence alerts for 30 s")},
    {"+ − wheel", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "zoom the fan; 0 fits it again")},
    {"F2", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "follow the vehicle")},
    {"F4", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "measure between two places")},
    {"M", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "mark the moment and the place under the cursor")},
    {"G V", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "draw a guard zone, a veto area")},
    {"N", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "head up, north up, course up in turn")},
    {"O", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "off-centre: the cursor's place to the middle")},
    {"Ctrl Shift C", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "copy the cursor's place")},
    {"B P", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "beam, plan to the front and back")},
    {"Ctrl E", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "export the plan as CSV or PNG")},
    {"F5", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "day, dusk, night")},
    {"F11", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "full screen")},
    {"S", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "picture of the window")},
    {"W", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "picture of the fan only")},
    {"Ctrl O", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "open a recording")},
    {"Ctrl Shift O", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "open the last recording again")},
    {"Ctrl L", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "connect to a sonar head")},
    {"E", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "set the head's sector: ← → Shift Tab Enter")},
    {"Ctrl D", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "demonstration")},
    {"Ctrl F", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "find a parameter")},
    {"Ctrl B", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "star the selected parameter")},
    {"Ctrl Z", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "undo a parameter, mark or area; with Shift: redo")},
    {"Ctrl 1 2 3", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "docks to operate, review, tune")},
    {"F1", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "the manual, at what the mouse points at")},
    {"Esc", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "leave an edit or this sheet")},
    {"?", QT_TRANSLATE_NOOP("echotrail::ShortcutsOverlay", "this sheet")},
}};

}  // namespace

ShortcutsOverlay::ShortcutsOverlay(QWidget* window) : QWidget(window) {
    setFocusPolicy(Qt::StrongFocus);
    inEveryLanguage(this, [this] { setAccessibleName(tr("Keyboard shortcuts")); });
    window->installEventFilter(this);
    hide();
}

void ShortcutsOverlay::toggle() {
    if (isVisible()) {
        hide();
        return;
    }
    setGeometry(parentWidget()->rect());
    raise();
    show();
    setFocus(Qt::PopupFocusReason);
}

bool ShortcutsOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

void ShortcutsOverlay::mousePressEvent(QMouseEvent*) { hide(); }

void ShortcutsOverlay::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        hide();
    else
        QWidget::keyPressEvent(event);
}

void ShortcutsOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& colours = currentPalette();
    QColor veil = colours.window;
    veil.setAlphaF(0.75F);
    painter.fillRect(rect(), veil);
    const int line = fontMetrics().height();
    const int row = line * 3 / 2;
    const int key_width = line * 7;
    const int count = static_cast<int>(keys.size());
    const int columns = row * (count + 2) > height() ? 2 : 1;
    const int rows = (count + columns - 1) / columns;
    const int column_width = line * 28;
    QRect sheet(0, 0, column_width * columns, row * (rows + 2));
    sheet.moveCenter(rect().center());
    painter.fillRect(sheet, colours.panel);
    painter.setPen(colours.strong_line);
    painter.drawRect(sheet);
    QFont strong = font();
    strong.setWeight(QFont::DemiBold);
    const QRect first(sheet.left() + line, sheet.top() + line / 2, column_width - 2 * line, row);
    painter.setFont(strong);
    painter.setPen(colours.text);
    painter.drawText(first, Qt::AlignVCenter, tr("Keys"));
    for (int i = 0; i < count; ++i) {
        const auto& [key, meaning] = keys[static_cast<std::size_t>(i)];
        const QRect at = first.translated(i / rows * column_width, (i % rows + 1) * row);
        painter.setFont(strong);
        painter.setPen(colours.text);
        painter.drawText(at, Qt::AlignVCenter, QString::fromUtf8(key));
        painter.setFont(font());
        painter.setPen(colours.dim);
        painter.drawText(at.adjusted(key_width, 0, 0, 0), Qt::AlignVCenter, tr(meaning));
    }
}

}  // namespace echotrail
