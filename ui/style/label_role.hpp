#pragma once

class QLabel;

namespace echotrail {

/// Gives a label another of the roles of the style sheet ("dim", "staged", "good", "refusal"…).
void setLabelRole(QLabel& label, const char* role);

}  // namespace echotrail
