#include "ui/style/echo_map.hpp"

#include <QCoreApplication>
#include <cmath>
#include <span>

namespace echotrail {
namespace {

constexpr std::array<QRgb, 2> grey{0xff06080a, 0xffb8b8b8};
constexpr std::array<QRgb, 2> grey_night{0xff020203, 0xff726a64};
constexpr std::array<QRgb, 5> bronze{0xff000000, 0xff3a2206, 0xff7a4f17, 0xffb98736, 0xffe2bd7c};
// Every ninth of viridis (van der Walt, Smith 2015) and of cividis (Nuñez, Anderton, Renslow 2018).
constexpr std::array<QRgb, 10> viridis{0xff440154, 0xff482878, 0xff3e4989, 0xff31688e, 0xff26828e,
                                       0xff1f9e89, 0xff35b779, 0xff6ece58, 0xffb5de2b, 0xfffde725};
constexpr std::array<QRgb, 10> cividis{0xff00224e, 0xff123570, 0xff3b496c, 0xff575d6d, 0xff707173,
                                       0xff8a8678, 0xffa59c74, 0xffc3b369, 0xffe1cc55, 0xfffee838};
constexpr double night_dimming = 0.55;  ///< the brightest map colour stays darker than the night's marks

int mixed(int from, int to, double share, double dimming) {
    return static_cast<int>(std::lround((from + share * (to - from)) * dimming));
}

EchoColours table(std::span<const QRgb> stops, double dimming) {
    EchoColours colours{};
    for (std::size_t level = 0; level < colours.size(); ++level) {
        const double at = static_cast<double>(level) / 255.0 * static_cast<double>(stops.size() - 1);
        const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
        const double share = at - static_cast<double>(below);
        const QRgb from = stops[below];
        const QRgb to = stops[below + 1];
        colours[level] =
            qRgb(mixed(qRed(from), qRed(to), share, dimming), mixed(qGreen(from), qGreen(to), share, dimming),
                 mixed(qBlue(from), qBlue(to), share, dimming));
    }
    return colours;
}

}  // namespace

const EchoColours& echoColours(EchoMap map, Theme theme) {
    // The fan looks the same by day and at dusk.
    static const std::array tables{table(grey, 1.0), table(bronze, 1.0), table(viridis, 1.0), table(cividis, 1.0)};
    static const std::array night_tables{table(grey_night, 1.0), table(bronze, night_dimming),
                                         table(viridis, night_dimming), table(cividis, night_dimming)};
    return (theme == Theme::Night ? night_tables : tables)[static_cast<std::size_t>(map)];
}

QString echoMapTitle(EchoMap map) {
    switch (map) {
        case EchoMap::Bronze:
            return QCoreApplication::translate("EchoMap", "bronze");
        case EchoMap::Viridis:
            return QCoreApplication::translate("EchoMap", "viridis");
        case EchoMap::Cividis:
            return QCoreApplication::translate("EchoMap", "cividis");
        case EchoMap::Grey:
            break;
    }
    return QCoreApplication::translate("EchoMap", "grey");
}

}  // namespace echotrail
