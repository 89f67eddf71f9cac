#include "ui/style/palette.hpp"

#include <QCoreApplication>
#include <array>

namespace echotrail {
namespace {

constexpr std::array themes{Theme::Day, Theme::Dusk, Theme::Night};

Palette dayPalette() {
    Palette p;
    p.window = QColor(QRgb{0xffe9edf1});
    p.panel = QColor(QRgb{0xfff4f6f8});
    p.raised = QColor(QRgb{0xffffffff});
    p.field = QColor(QRgb{0xffffffff});
    p.line = QColor(QRgb{0xffc3cbd3});
    p.strong_line = QColor(QRgb{0xff8a96a2});
    p.text = QColor(QRgb{0xff101418});
    p.dim = QColor(QRgb{0xff46515c});
    p.off = QColor(QRgb{0xff6b7783});
    p.accent = QColor(QRgb{0xff0067a3});
    p.selected = QColor(QRgb{0xffcfe4f2});
    p.ok = QColor(QRgb{0xff1b6e3c});
    p.warning = QColor(QRgb{0xff7a5b00});
    p.alarm = QColor(QRgb{0xffb00020});
    p.staged = QColor(QRgb{0xff8a4b00});
    p.canvas = QColor(QRgb{0xff0f1419});
    p.track = QColor(QRgb{0xff35c8ff});
    p.mark = QColor(QRgb{0xffffffff});
    p.region = QColor(QRgb{0xff2ee66b});
    p.guard = QColor(QRgb{0xffff4fd8});
    p.danger = QColor(QRgb{0xffff5349});
    p.graticule = QColor(QRgb{0xff8fa3b5});
    p.caution = QColor(QRgb{0xffffd60a});
    p.halo = QColor(0, 0, 0, 217);
    return p;
}

Palette duskPalette() {
    Palette p = dayPalette();  // what lies on the fan is the same
    p.window = QColor(QRgb{0xff14181d});
    p.panel = QColor(QRgb{0xff191e24});
    p.raised = QColor(QRgb{0xff222930});
    p.field = QColor(QRgb{0xff0f1317});
    p.line = QColor(QRgb{0xff2c343c});
    p.strong_line = QColor(QRgb{0xff46515c});
    p.text = QColor(QRgb{0xffd5dbe2});
    p.dim = QColor(QRgb{0xff97a2ae});
    p.off = QColor(QRgb{0xff6b7783});
    p.accent = QColor(QRgb{0xff5cc8ff});
    p.selected = QColor(QRgb{0xff173a4d});
    p.ok = QColor(QRgb{0xff4fd18b});
    p.warning = QColor(QRgb{0xffffd60a});
    p.alarm = QColor(QRgb{0xffff6b60});
    p.staged = QColor(QRgb{0xffff9f43});
    p.canvas = QColor(QRgb{0xff0a0d10});
    return p;
}

Palette nightPalette() {
    Palette p;
    p.window = QColor(QRgb{0xff060708});
    p.panel = QColor(QRgb{0xff090a0b});
    p.raised = QColor(QRgb{0xff120e0d});
    p.field = QColor(QRgb{0xff040404});
    p.line = QColor(QRgb{0xff2b1815});
    p.strong_line = QColor(QRgb{0xff4d2822});
    p.text = QColor(QRgb{0xffdc5a48});
    p.dim = QColor(QRgb{0xffcf4d3e});
    p.off = QColor(QRgb{0xff8a3a2e});
    p.accent = QColor(QRgb{0xff3487b3});
    p.selected = QColor(QRgb{0xff081922});
    p.ok = QColor(QRgb{0xff9f4c3c});
    p.warning = QColor(QRgb{0xffa88300});
    p.alarm = QColor(QRgb{0xffdc5a48});
    p.staged = QColor(QRgb{0xffa88300});
    p.canvas = QColor(QRgb{0xff030303});
    p.track = QColor(QRgb{0xff2f86b3});
    p.mark = QColor(QRgb{0xffb3a397});
    p.region = QColor(QRgb{0xff2f9a50});
    p.guard = QColor(QRgb{0xffa63a90});
    p.danger = QColor(QRgb{0xffe8523e});
    p.graticule = QColor(QRgb{0xff96705f});
    p.caution = QColor(QRgb{0xffa88300});
    p.halo = QColor(0, 0, 0, 217);
    return p;
}

}  // namespace

const Palette& paletteOf(Theme theme) {
    static const Palette day = dayPalette();
    static const Palette dusk = duskPalette();
    static const Palette night = nightPalette();
    switch (theme) {
        case Theme::Day:
            return day;
        case Theme::Night:
            return night;
        case Theme::Dusk:
            break;
    }
    return dusk;
}

const Palette& currentPalette() { return paletteOf(currentTheme()); }

QString themeName(Theme theme) {
    switch (theme) {
        case Theme::Day:
            return "day";
        case Theme::Night:
            return "night";
        case Theme::Dusk:
            break;
    }
    return "dusk";
}

Theme themeFromName(const QString& name) {
    for (const Theme theme : themes)
        if (themeName(theme) == name) return theme;
    return Theme::Dusk;
}

QString themeTitle(Theme theme) {
    switch (theme) {
        case Theme::Day:
            return QCoreApplication::translate("Theme", "Day");
        case Theme::Night:
            return QCoreApplication::translate("Theme", "Night");
        case Theme::Dusk:
            break;
    }
    return QCoreApplication::translate("Theme", "Dusk");
}

}  // namespace echotrail
