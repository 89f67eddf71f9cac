#pragma once

namespace echotrail {

/// Without a display Qt says at every window what its offscreen platform cannot do, and where it keeps what nobody
/// asked for. From now on those lines are dropped; all others are written as ever.
void quietOffscreen();

}  // namespace echotrail
