#include "ui/style/instrument_style.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/style_sheet.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QApplication>
#include <QToolTip>
#include <algorithm>

namespace echotrail {
namespace {

constexpr double least_scale = 0.8;
constexpr double most_scale = 2.0;
constexpr auto styled_property = "echotrail_styled";

Theme current_theme = Theme::Dusk;
double current_scale = 1.0;

QPalette qtPalette(const Palette& p) {
    QPalette palette;
    palette.setColor(QPalette::Window, p.panel);
    palette.setColor(QPalette::WindowText, p.text);
    palette.setColor(QPalette::Base, p.field);
    palette.setColor(QPalette::AlternateBase, p.panel);
    palette.setColor(QPalette::Text, p.text);
    palette.setColor(QPalette::PlaceholderText, p.off);
    palette.setColor(QPalette::Button, p.raised);
    palette.setColor(QPalette::ButtonText, p.text);
    palette.setColor(QPalette::BrightText, p.alarm);
    palette.setColor(QPalette::ToolTipBase, p.raised);
    palette.setColor(QPalette::ToolTipText, p.text);
    palette.setColor(QPalette::Highlight, p.selected);
    palette.setColor(QPalette::HighlightedText, p.text);
    palette.setColor(QPalette::Link, p.accent);
    palette.setColor(QPalette::LinkVisited, p.accent);
    palette.setColor(QPalette::Light, p.strong_line);
    palette.setColor(QPalette::Midlight, p.line);
    palette.setColor(QPalette::Mid, p.line);
    palette.setColor(QPalette::Dark, p.line);
    palette.setColor(QPalette::Shadow, p.window);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        palette.setColor(QPalette::Disabled, role, p.off);
    return palette;
}

void dress(QApplication& app) {
    // Setting the style anew would polish every widget twice.
    if (!app.property(styled_property).toBool()) {
        QApplication::setStyle(new InstrumentStyle);
        app.setProperty(styled_property, true);
    }
    const QFont font = applicationFont(current_scale);
    // Half of the time of a start goes into dressing every widget: not again in what it wears already.
    const QString sheet = styleSheet(currentPalette(), UiMetrics(font));
    if (app.styleSheet() == sheet) return;
    const QPalette palette = qtPalette(currentPalette());
    QApplication::setFont(font);
    QApplication::setPalette(palette);
    QToolTip::setFont(font);
    QToolTip::setPalette(palette);
    app.setStyleSheet(sheet);
}

}  // namespace

Theme currentTheme() { return current_theme; }
double fontScale() { return current_scale; }

void applyTheme(QApplication& app, Theme theme) {
    current_theme = theme;
    dress(app);
}

void applyFontScale(QApplication& app, double scale) {
    current_scale = std::clamp(scale, least_scale, most_scale);
    dress(app);
}

}  // namespace echotrail
