#include "core/link/link_server.hpp"
#include "core/link/wire_values.hpp"

#include <algorithm>

// The part of a LinkServer that gives recordings away: what is asked for waits until the way and the budget are free.
namespace echotrail {
namespace {

constexpr double burst_s = 0.25;  // of the budget

std::optional<LinkRecordRequest> requestOf(std::uint32_t console, const wire::ToTracker& message) {
    LinkRecordRequest request{console, message.request(), LinkListRecordings{}};
    if (message.has_describe_recording()) {
        const std::string& name = message.describe_recording().recording();
        if (name.size() > link_limits::longest_word) return std::nullopt;
        request.content = LinkDescribeRecording{name};
    }
    if (message.has_read_rows()) {
        auto wanted = read(message.read_rows());
        if (!wanted) return std::nullopt;
        request.content = *std::move(wanted);
    }
    return request;
}

}  // namespace

void LinkServer::takeRecordRequest(LinkSession& session, const wire::ToTracker& message, Timestamp now) {
    auto request = requestOf(session.console, message);
    if (!request || message.request() == 0)
        return refuse(session, message.request(), "unsound", "rows that cannot be", now);
    if (!recordings_)
        return refuse(session, message.request(), "no_recordings", "this tracker gives no recordings away", now);
    // Rows have a budget of their own, in bytes.
    if (!message.has_read_rows() && !session.mayAsk(now))
        return refuse(session, message.request(), "too_many", "too many requests at once", now);
    const auto waiting = std::count_if(record_pending_.begin(), record_pending_.end(),
                                       [&](const auto& each) { return each.console == session.console; });
    if (static_cast<std::size_t>(waiting) >= link_limits::most_record_requests)
        return refuse(session, message.request(), "too_many", "too many requests wait", now);
    record_pending_.push_back(*std::move(request));
}

/// Whether its answer could be sent soon; on a slow way it is made smaller.
bool LinkServer::mayGo(LinkRecordRequest& request, Timestamp now) const {
    const LinkSession* session = find(request.console);
    if (!session || session->queue.waitingIn(SendQueue::Lane::Record) > 0) return false;
    auto* rows = std::get_if<LinkReadRows>(&request.content);
    if (!rows || session->queue.level() == SendQueue::Everything) return true;
    rows->rows.most_bytes = std::min(rows->rows.most_bytes, link_limits::fewest_rows);
    return now - session->rows_sent >= link_limits::between_rows_spared;
}

std::optional<LinkRecordRequest> LinkServer::nextRecordRequest(Timestamp now) {
    constexpr double most = burst_s * link_limits::rows_per_second;
    const double more = link_limits::rows_per_second * std::max(0.0, secondsBetween(rows_budget_filled_, now));
    rows_budget_ = std::min(most, rows_budget_ + more);
    rows_budget_filled_ = now;
    if (rows_budget_ <= 0.0) return std::nullopt;
    const auto next = std::find_if(record_pending_.begin(), record_pending_.end(),
                                   [&](LinkRecordRequest& each) { return mayGo(each, now); });
    if (next == record_pending_.end()) return std::nullopt;
    LinkRecordRequest request = std::move(*next);
    record_pending_.erase(next);
    return request;
}

void LinkServer::answer(const LinkRecordRequest& request, const Result<LinkRecordAnswer>& result, Timestamp now) {
    LinkSession* session = find(request.console);
    if (!session || session->closing) return;
    if (!result) return refuse(*session, request.request, "not_done", result.error(), now);
    LinkRecordAnswer answer = *result;
    std::visit([&](auto& each) { each.request = request.request; }, answer);
    wire::ToConsole out;
    if (const auto* recordings = std::get_if<LinkRecordings>(&answer))
        echotrail::write(*recordings, *out.mutable_recordings());
    if (const auto* recording = std::get_if<LinkRecording>(&answer))
        echotrail::write(*recording, *out.mutable_recording());
    if (const auto* rows = std::get_if<LinkRows>(&answer)) echotrail::write(*rows, *out.mutable_rows());
    auto frame = std::make_shared<const std::string>(linkFrame(out.SerializeAsString()));
    rows_budget_ -= static_cast<double>(frame->size());
    counts_.record_bytes += frame->size();
    session->rows_sent = now;
    // Its lane was empty, and has room for any answer.
    static_cast<void>(session->queue.add(SendQueue::Lane::Record, std::move(frame), now));
}

}  // namespace echotrail
