#pragma once

#include "ui/style/palette.hpp"

#include <QRgb>
#include <QString>
#include <array>

namespace echotrail {

/// How echo levels become colours. Grey is the default: capped below white, every overlay colour stays visible on it.
enum class EchoMap { Grey, Bronze, Viridis, Cividis };
inline constexpr std::array echo_maps{EchoMap::Grey, EchoMap::Bronze, EchoMap::Viridis, EchoMap::Cividis};

/// Opaque colours from the weakest to the strongest level. By night all maps are dimmed alike.
using EchoColours = std::array<QRgb, 256>;
const EchoColours& echoColours(EchoMap map, Theme theme);

QString echoMapTitle(EchoMap map);

}  // namespace echotrail
