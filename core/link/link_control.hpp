#pragma once

#include "core/base/result.hpp"
#include "core/base/time.hpp"
#include "core/link/link_values.hpp"

namespace echotrail {

/// Who commands the tracker: one console at a time. Another asks; the holder gives it, or keeps it, or does not answer
/// in time: then who has asked may take it.
class ControlDesk {
public:
    /// The error says what stands against it.
    Result<void> act(ControlAction action, std::uint32_t console, const std::string& name, Timestamp now);
    /// Its control goes to who has asked.
    void left(std::uint32_t console);

    bool holds(std::uint32_t console) const { return console != 0 && state_.holder == console; }
    const LinkControl& state() const { return state_; }

private:
    Result<void> ask(std::uint32_t console, const std::string& name, Timestamp now);
    Result<void> take(std::uint32_t console, Timestamp now);
    void handOver();
    void forgetAsking();

    LinkControl state_;
    Timestamp asked_{};
};

}  // namespace echotrail
