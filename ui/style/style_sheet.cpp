#include "ui/style/style_sheet.hpp"

#include <QHash>
#include <QRegularExpression>

namespace echotrail {
namespace {

/// `@role` is a colour, `@8px` a length of 8 px at scale 1. Controls are drawn by InstrumentStyle; here are frames.
constexpr auto sheet_template = R"(
QToolTip { background: @raised; color: @text; border: 1px solid @strong_line; padding: @3px @6px; }
QMenuBar { background: @window; color: @text; border-bottom: 1px solid @line; padding: @1px; }
QMenuBar::item { background: transparent; padding: @3px @8px; }
QMenuBar::item:selected, QMenuBar::item:pressed { background: @selected; color: @text; }
QMenuBar::item:disabled { color: @off; }
QMenu { background: @panel; color: @text; border: 1px solid @strong_line; padding: @3px 0; }
QMenu::item { padding: @4px @24px @4px @24px; }
QMenu::item:selected { background: @selected; color: @text; }
QMenu::item:disabled { color: @off; }
QMenu::separator { height: 1px; background: @line; margin: @3px @8px; }
QHeaderView { background: @panel; border: none; }
QHeaderView::section { background: @panel; color: @dim; border: none; border-bottom: 1px solid @line;
    padding: @2px @4px; font-weight: normal; }
QAbstractItemView { background: @panel; color: @text; border: none; alternate-background-color: @panel;
    selection-background-color: @selected; selection-color: @text; gridline-color: @line; outline: none; }
QComboBox QAbstractItemView { border: 1px solid @strong_line; }
QTableCornerButton::section { background: @panel; border: none; }
QScrollBar { background: @panel; border: none; }
QScrollBar:vertical { width: @10px; }
QScrollBar:horizontal { height: @10px; }
QScrollBar::handle { background: @strong_line; border: none; border-radius: @2px; margin: @2px; }
QScrollBar::handle:vertical { min-height: @24px; }
QScrollBar::handle:horizontal { min-width: @24px; }
QScrollBar::handle:hover { background: @dim; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QTabBar::tab { background: @window; color: @dim; border: 1px solid @line; border-bottom: none;
    padding: @4px @12px; }
QTabBar::tab:selected { background: @panel; color: @text; border-bottom: @2px solid @accent; }
QMainWindow::separator { background: @line; width: @3px; height: @3px; }
QMainWindow::separator:hover { background: @accent; }
QStatusBar { background: @window; color: @dim; border-top: 1px solid @line; }
QStatusBar::item { border: none; }
QToolBar { background: @raised; border: none; spacing: 0; padding: 0; }
QGroupBox { border: none; border-top: 1px solid @line; margin-top: @18px; padding-top: @4px; font-weight: 600; }
QGroupBox::title { subcontrol-origin: margin; subcontrol-position: top left; padding: @3px 0; color: @dim; }
QLabel#dim { color: @dim; }
QLabel#dim:disabled, QLabel#card_stale { color: @off; }
QLabel#title { font-weight: 600; }
QLabel#card_value, QLabel#card_stale { font-size: @15px; font-weight: 600; }
QLabel#card_detail { color: @dim; font-size: @11px; }
QLabel#on_canvas { color: @mark; }
QLabel#refusal { color: @warning; }
QLabel#staged { color: @staged; font-weight: 600; }
QLabel#good { color: @ok; }
QLabel#lost { color: @alarm; font-weight: 600; }
QLabel#section { color: @dim; font-weight: 600; border-top: 1px solid @line; padding-top: @4px; }
QLabel#clock { font-family: "DejaVu Sans Mono"; font-weight: 600; }
QProgressBar { background: @field; color: @text; border: 1px solid @strong_line; border-radius: @2px;
    text-align: center; }
QProgressBar::chunk { background: @accent; }
)";

QHash<QString, QColor> rolesOf(const Palette& p) {
    return {{"window", p.window}, {"panel", p.panel},       {"raised", p.raised},
            {"field", p.field},   {"line", p.line},         {"strong_line", p.strong_line},
            {"text", p.text},     {"dim", p.dim},           {"off", p.off},
            {"accent", p.accent}, {"selected", p.selected}, {"warning", p.warning},
            {"alarm", p.alarm},   {"staged", p.staged},     {"ok", p.ok},
            {"mark", p.mark}};
}

}  // namespace

QString styleSheet(const Palette& palette, const UiMetrics& metrics) {
    static const QRegularExpression token("@(?:(\\d+)px|([a-z_]+))");
    const QHash<QString, QColor> roles = rolesOf(palette);
    const QString source = QString::fromLatin1(sheet_template);
    QString sheet;
    qsizetype copied = 0;
    for (auto found = token.globalMatch(source); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        sheet += source.mid(copied, match.capturedStart() - copied);
        copied = match.capturedEnd();
        if (match.hasCaptured(1) && !match.captured(1).isEmpty()) {
            sheet += QString("%1px").arg(metrics.pixels(match.captured(1).toDouble()));
        } else {
            Q_ASSERT(roles.contains(match.captured(2)));
            sheet += roles.value(match.captured(2)).name();
        }
    }
    return sheet + source.mid(copied);
}

}  // namespace echotrail
