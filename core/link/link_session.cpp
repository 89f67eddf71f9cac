#include "core/link/link_session.hpp"

#include <algorithm>

namespace echotrail {

bool LinkSession::mayAsk(Timestamp now) {
    const double more = link_limits::requests_per_second * std::max(0.0, secondsBetween(budget_filled, now));
    budget = std::min(link_limits::requests_at_once, budget + more);
    budget_filled = now;
    if (budget < 1.0) return false;
    budget -= 1.0;
    return true;
}

}  // namespace echotrail
