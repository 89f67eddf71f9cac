#pragma once

#include <QColor>
#include <QString>

class QApplication;

namespace echotrail {

/// The light at the console: under a bright sky, at a normal desk, in a darkened wheelhouse.
enum class Theme { Day, Dusk, Night };

/// Every colour of the console by its role; nothing else may name a colour. The fan's canvas is dark in all three
/// themes, so that an echo level looks the same at noon and at night. Contrasts are held by tests.
struct Palette {
    QColor window;
    QColor panel;        ///< docks; the ground that contrasts are measured against
    QColor raised;       ///< buttons, heads
    QColor field;        ///< inputs, charts
    QColor line;         ///< separators
    QColor strong_line;  ///< edges of controls
    QColor text;
    QColor dim;       ///< labels, units, ages
    QColor off;       ///< disabled and stale values only
    QColor accent;    ///< edge of the selection, default button, charts
    QColor selected;  ///< ground of a selected row
    QColor ok;
    QColor warning;  ///< warning, caution, replay, threshold line
    QColor alarm;    ///< alarm, danger, lost. Nothing else
    QColor staged;   ///< sent or edited, not confirmed

    QColor canvas;     ///< behind the fan
    QColor track;      ///< track, its cloud, ellipse and region of interest
    QColor mark;       ///< own ship, cursor, marks, labels on the fan
    QColor region;     ///< segmented regions
    QColor guard;      ///< guard zones
    QColor danger;     ///< lost or dangerous, on the fan
    QColor graticule;  ///< rings, bearings, vetoes: structure, never a state
    QColor caution;    ///< filters at work, missing inputs, on the fan
    QColor halo;       ///< behind lines and text on the fan
};

const Palette& paletteOf(Theme theme);

/// The theme last applied, and its colours; dusk before there was one.
Theme currentTheme();
const Palette& currentPalette();

/// "day", "dusk", "night": as in settings and options. Any other name is dusk.
QString themeName(Theme theme);
Theme themeFromName(const QString& name);
/// For a person, translated.
QString themeTitle(Theme theme);

/// Dresses the whole application: style, fonts, QPalette and style sheet, tooltips, menus and dialogs included.
void applyTheme(QApplication& app, Theme theme);
/// Sets the size of everything: 1 is the normal one; kept within 0.8…2.
void applyFontScale(QApplication& app, double scale);
double fontScale();

}  // namespace echotrail
