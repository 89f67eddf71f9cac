#pragma once

#include <QCoreApplication>

namespace echotrail {

/// Speaks for what is written on the fan itself, which is painted by functions: FanText::tr("…").
class FanText {
    Q_DECLARE_TR_FUNCTIONS(echotrail::FanText)
};

}  // namespace echotrail
