#include "core/recording/ping_log.hpp"

#include "core/recording/log_writer.hpp"
#include "core/seanet/ping_decoder.hpp"
#include "core/seanet/ping_receiver.hpp"

namespace echotrail {
namespace {

constexpr std::uint64_t events_per_commit = 1000;

/// Numbers events and writes them, in order of time.
class EventLog {
public:
    EventLog(LogWriter& log, Timestamp start) : log_(log), start_(start) {}

    Result<void> add(EventKind kind, Timestamp utc, std::vector<std::uint8_t> payload) {
        const Event event{number_++, kind, utc, utc - start_, std::move(payload)};
        if (auto added = log_.add(event); !added) return added;
        return number_ % events_per_commit == 0 ? log_.commit() : Result<void>{};
    }

private:
    LogWriter& log_;
    Timestamp start_;
    std::uint64_t number_ = 0;
};

}  // namespace

Result<std::uint64_t> writePingLog(const std::string& path, const LogHeader& header, PingSource& source,
                                   std::optional<Timestamp> end,
                                   const std::vector<std::pair<Timestamp, std::string>>& navigation) {
    auto log = LogWriter::create(path, header);
    if (!log) return Error{log.error()};
    Timestamp start = source.info().start;
    if (!navigation.empty()) start = std::min(start, navigation.front().first);
    EventLog events(**log, start);
    auto said = navigation.begin();
    const auto addNavigationUntil = [&](Timestamp time) -> Result<void> {
        for (; said != navigation.end() && said->first <= time; ++said)
            if (auto added =
                    events.add(EventKind::NavigationBytes, said->first, {said->second.begin(), said->second.end()});
                !added)
                return added;
        return {};
    };
    std::uint64_t pings = 0;
    while (const auto ping = source.next()) {
        if (end && ping->time > *end) break;
        const seanet::HeadData line = seanet::lineFrom(*ping);
        // As PingReceiver takes it off again.
        const double flight_s =
            seanet::pingFrom(line, 0, {}, ping->sound_speed_mps).bin_interval_s * static_cast<double>(line.data.size());
        const Timestamp arrival = ping->time + microsecondsFromSeconds(flight_s) + seanet::PingReceiver::head_latency;
        if (auto added = addNavigationUntil(arrival); !added) return Error{added.error()};
        if (auto added = events.add(EventKind::SonarBytes, arrival, seanet::encodeHeadData(line)); !added)
            return Error{added.error()};
        ++pings;
    }
    if (auto added = addNavigationUntil(end.value_or(Timestamp::max())); !added) return Error{added.error()};
    if (auto closed = (*log)->close(); !closed) return Error{closed.error()};
    return pings;
}

}  // namespace echotrail
