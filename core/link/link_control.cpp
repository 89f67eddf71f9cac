#include "core/link/link_control.hpp"

#include "core/link/link_limits.hpp"

#include <cmath>

namespace echotrail {

Result<void> ControlDesk::act(ControlAction action, std::uint32_t console, const std::string& name, Timestamp now) {
    switch (action) {
        case ControlAction::Ask:
            return ask(console, name, now);
        case ControlAction::Take:
            return take(console, now);
        case ControlAction::Give:
        case ControlAction::Keep:
            break;
    }
    if (!holds(console)) return Error{"this console does not hold control"};
    if (action == ControlAction::Give)
        handOver();
    else
        forgetAsking();
    return {};
}

Result<void> ControlDesk::ask(std::uint32_t console, const std::string& name, Timestamp now) {
    if (holds(console)) return {};
    if (state_.holder == 0) {
        state_.holder = console;
        state_.holder_name = name;
        return {};
    }
    if (state_.asking == console) return {};
    if (state_.asking != 0) return Error{state_.asking_name + " has asked for control before"};
    state_.asking = console;
    state_.asking_name = name;
    asked_ = now;
    return {};
}

Result<void> ControlDesk::take(std::uint32_t console, Timestamp now) {
    if (holds(console)) return {};
    if (state_.asking != console) return Error{"control must be asked for first"};
    if (now - asked_ < link_limits::control_answer) {
        const double left_s = secondsBetween(now, asked_ + link_limits::control_answer);
        return Error{state_.holder_name + " has " + std::to_string(std::lround(std::ceil(left_s))) +
                     " s left to answer"};
    }
    handOver();
    return {};
}

void ControlDesk::left(std::uint32_t console) {
    if (state_.asking == console) forgetAsking();
    if (holds(console)) handOver();
}

void ControlDesk::handOver() {
    state_.holder = state_.asking;
    state_.holder_name = state_.asking_name;
    forgetAsking();
}

void ControlDesk::forgetAsking() {
    state_.asking = 0;
    state_.asking_name.clear();
}

}  // namespace echotrail
