#include "ui/style/label_role.hpp"

#include <QLabel>
#include <QStyle>

namespace echotrail {

void setLabelRole(QLabel& label, const char* role) {
    if (label.objectName() == QLatin1String(role)) return;
    label.setObjectName(role);
    // A style sheet looks at names only when a widget is polished.
    label.style()->unpolish(&label);
    label.style()->polish(&label);
}

}  // namespace echotrail
