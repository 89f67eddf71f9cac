#include "quiet_offscreen.hpp"

#include <QString>
#include <algorithm>
#include <array>

namespace echotrail {
namespace {

constexpr std::array known{QLatin1String("This plugin does not support propagateSizeHints()"),
                           QLatin1String("This plugin does not support raise()"),
                           QLatin1String("QStandardPaths: XDG_RUNTIME_DIR not set, defaulting to ")};

QtMessageHandler others = nullptr;

void write(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&](QLatin1String line) { return message.startsWith(line); });
    if (!is_known) others(type, context, message);
}

}  // namespace

void quietOffscreen() { others = qInstallMessageHandler(write); }

}  // namespace echotrail
