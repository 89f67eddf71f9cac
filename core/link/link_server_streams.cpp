#include "core/link/link_server.hpp"
#include "core/link/wire_values.hpp"

#include <algorithm>

// What a tracker tells its consoles of itself.
namespace echotrail {

void LinkServer::write(wire::Snapshot& snapshot) const {
    echotrail::write(parameters_, *snapshot.mutable_parameters());
    echotrail::write(control_.state(), *snapshot.mutable_control());
    echotrail::write(health_, *snapshot.mutable_health());
    const auto& tracks = encoder_.tracks();
    for (std::size_t i = 0; i < std::min(tracks.size(), link_limits::most_tracks); ++i) {
        // Histories are for the eye; a snapshot must fit the lane however many tracks there are.
        const bool with_history = snapshot.ByteSizeLong() < link_limits::longest_message / 2;
        echotrail::write(tracks[i], with_history, *snapshot.add_tracks());
    }
    snapshot.set_first_ping_us(optionalMicroseconds(encoder_.firstPing()));
    for (const LinkLog& line : log_) echotrail::write(line, *snapshot.add_log());
}
void LinkServer::publish(LinkMoment moment, Timestamp now) {
    MomentFrames frames = encoder_.encode(std::move(moment));
    for (const auto& [console, session] : sessions_) {
        send(*session, SendQueue::Lane::Urgent, frames.tracks, now);
        stream(*session, SendQueue::Lane::Regions, frames.regions, now);
        stream(*session, SendQueue::Lane::Particles, frames.particles, now);
        session->queue.judge(now);
        stream(*session, SendQueue::Lane::Picture, encoder_.beamAt(frames, session->level(now)), now);
    }
}

void LinkServer::publish(const LinkHealth& health, Timestamp now) {
    health_ = health;
    health_.consoles = static_cast<std::uint32_t>(sessions_.size());
    wire::ToConsole out;
    out.set_sequence(++health_sent_);
    echotrail::write(health_, *out.mutable_health());
    sendToAll(out, now);
}

void LinkServer::publish(const LinkLog& line, Timestamp now) {
    log_.push_back({line.time, line.weight, cleanText(line.text, link_limits::longest_text)});
    if (log_.size() > link_limits::recent_log_lines) log_.pop_front();
    wire::ToConsole out;
    out.set_sequence(++log_sent_);
    echotrail::write(log_.back(), *out.mutable_log());
    sendToAll(out, now);
}

void LinkServer::publishParameters(std::vector<NamedValue> parameters, Timestamp now) {
    parameters_ = {parameters_.revision + 1, std::move(parameters)};
    wire::ToConsole out;
    echotrail::write(parameters_, *out.mutable_parameters());
    sendToAll(out, now);
}

}  // namespace echotrail
