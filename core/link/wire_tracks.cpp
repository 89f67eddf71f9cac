#include "core/link/link_limits.hpp"
#include "core/link/wire_values.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr int state_size = 4, triangle_size = 10;
constexpr double largest_variance = 1e12;

wire::TrackState stateOf(TrackState state) { return static_cast<wire::TrackState>(state); }

bool readState(const wire::Track& in, GaussianState& state) {
    const auto time = timeFrom(in.time_us());
    if (!time || in.mean_size() != state_size || in.covariance_size() != triangle_size) return false;
    state.time = *time;
    for (int i = 0; i < state_size; ++i) {
        if (!isSane(in.mean(i))) return false;
        state.mean[i] = in.mean(i);
    }
    int at = 0;
    for (int row = 0; row < state_size; ++row)
        for (int column = row; column < state_size; ++column, ++at) {
            const double value = in.covariance(at);
            if (!(std::abs(value) <= largest_variance) || (row == column && value < 0.0)) return false;
            state.covariance(row, column) = state.covariance(column, row) = value;
        }
    return true;
}

bool readInterest(const wire::Track& in, PolarBox& box) {
    for (const double value : {in.interest_north_m(), in.interest_east_m(), in.interest_centre_rad(),
                               in.interest_half_width_rad(), in.interest_near_m(), in.interest_far_m()})
        if (!isSane(value)) return false;
    box = {in.interest_north_m(),        in.interest_east_m(), Bearing::radians(in.interest_centre_rad()),
           in.interest_half_width_rad(), in.interest_near_m(), in.interest_far_m()};
    return true;
}

bool readCloud(const wire::Particles::Cloud& in, ParticleCloud& cloud) {
    const int size = in.north_m_size();
    if (in.east_m_size() != size || in.weight_size() != size ||
        static_cast<std::size_t>(size) > link_limits::most_particles || !isSane(in.effective()))
        return false;
    for (int i = 0; i < size; ++i) {
        if (!isSane(in.north_m(i)) || !isSane(in.east_m(i)) || !(in.weight(i) >= 0.0F && in.weight(i) <= 1.0F))
            return false;
        cloud.position_m.emplace_back(in.north_m(i), in.east_m(i));
        cloud.weight.push_back(in.weight(i));
    }
    cloud.effective = in.effective();
    if (in.size() > cloud.weight.size()) cloud.thinned_from = in.size();
    return true;
}

}  // namespace

void write(const TrackLook& look, wire::Look& out) {
    out.set_time_us(microsecondsOf(look.time));
    out.set_track(look.track);
    out.set_state(stateOf(look.state));
    out.set_target(look.target);
    out.set_seen(look.seen);
    out.set_no_echo(static_cast<int>(look.no_echo));
    out.set_range_m(look.range_m);
    out.set_bearing_rad(look.bearing.inRadians());
    out.set_north_m(look.position_m.x());
    out.set_east_m(look.position_m.y());
    out.set_velocity_north_mps(look.velocity_mps.x());
    out.set_velocity_east_mps(look.velocity_mps.y());
    out.set_covariance_nn_m2(look.covariance_m2(0, 0));
    out.set_covariance_ne_m2(look.covariance_m2(0, 1));
    out.set_covariance_ee_m2(look.covariance_m2(1, 1));
}

std::optional<TrackLook> read(const wire::Look& in) {
    const auto time = timeFrom(in.time_us());
    if (!time || !wire::TrackState_IsValid(in.state())) return std::nullopt;
    for (const double value :
         {in.range_m(), in.bearing_rad(), in.north_m(), in.east_m(), in.velocity_north_mps(), in.velocity_east_mps()})
        if (!isSane(value)) return std::nullopt;
    for (const double value : {in.covariance_nn_m2(), in.covariance_ne_m2(), in.covariance_ee_m2()})
        if (!(std::abs(value) <= largest_variance)) return std::nullopt;
    TrackLook look;
    look.time = *time;
    look.track = in.track();
    look.state = static_cast<TrackState>(in.state());
    look.target = in.target();
    look.seen = in.seen();
    // A cause that only a newer tracker knows is none here.
    if (in.no_echo() > 0 && in.no_echo() < no_echo_causes) look.no_echo = static_cast<NoEcho>(in.no_echo());
    look.range_m = in.range_m();
    look.bearing = Bearing::radians(in.bearing_rad());
    look.position_m = {in.north_m(), in.east_m()};
    look.velocity_mps = {in.velocity_north_mps(), in.velocity_east_mps()};
    look.covariance_m2 << in.covariance_nn_m2(), in.covariance_ne_m2(), in.covariance_ne_m2(), in.covariance_ee_m2();
    return look;
}

void write(const Track& track, bool with_history, wire::Track& out) {
    out.set_id(track.id);
    out.set_state(stateOf(track.state));
    out.set_target(track.target);
    out.set_time_us(microsecondsOf(track.estimate.time));
    for (int row = 0; row < state_size; ++row) {
        out.add_mean(track.estimate.mean[row]);
        for (int column = row; column < state_size; ++column)
            out.add_covariance(track.estimate.covariance(row, column));
    }
    out.set_born_us(microsecondsOf(track.born));
    out.set_last_seen_us(microsecondsOf(track.last_seen));
    out.set_existence(track.existence);
    out.set_looks(track.looks);
    out.set_misses(track.misses);
    out.set_score(track.score);
    out.set_innovation_m(track.innovation_m);
    out.set_nis(track.nis);
    write(track.seen_features, *out.mutable_seen_features());
    write(track.expected_features, *out.mutable_expected_features());
    const PolarBox& box = track.region_of_interest;
    out.set_interest_north_m(box.north_m);
    out.set_interest_east_m(box.east_m);
    out.set_interest_centre_rad(box.centre.inRadians());
    out.set_interest_half_width_rad(box.half_width_rad);
    out.set_interest_near_m(box.near_m);
    out.set_interest_far_m(box.far_m);
    if (with_history)
        for (const TrackLook& look : track.history) write(look, *out.add_history());
}

std::optional<Track> read(const wire::Track& in) {
    const auto born = timeFrom(in.born_us()), last_seen = timeFrom(in.last_seen_us());
    const auto seen = read(in.seen_features()), expected = read(in.expected_features());
    Track track;
    if (!born || !last_seen || !seen || !expected || !wire::TrackState_IsValid(in.state()) ||
        !readState(in, track.estimate) || !readInterest(in, track.region_of_interest) ||
        static_cast<std::size_t>(in.history_size()) > link_limits::longest_history)
        return std::nullopt;
    for (const double value : {in.existence(), in.score(), in.innovation_m()})
        if (!isSane(value)) return std::nullopt;
    if (!std::isfinite(in.nis())) return std::nullopt;
    track.id = in.id();
    track.state = static_cast<TrackState>(in.state());
    track.target = in.target();
    track.born = *born;
    track.last_seen = *last_seen;
    track.existence = in.existence();
    track.looks = in.looks();
    track.misses = in.misses();
    track.score = in.score();
    track.innovation_m = in.innovation_m();
    track.nis = in.nis();
    track.seen_features = *seen;
    track.expected_features = *expected;
    for (const wire::Look& each : in.history()) {
        auto look = read(each);
        if (!look) return std::nullopt;
        track.history.push_back(*std::move(look));
    }
    return track;
}

std::optional<LinkTracks> read(const wire::Tracks& in) {
    if (static_cast<std::size_t>(in.tracks_size()) > link_limits::most_tracks ||
        static_cast<std::size_t>(in.looks_size()) > link_limits::most_looks ||
        static_cast<std::size_t>(in.gone_size()) > link_limits::most_tracks)
        return std::nullopt;
    LinkTracks tracks;
    for (const wire::Track& each : in.tracks()) {
        auto track = read(each);
        if (!track) return std::nullopt;
        tracks.tracks.push_back(*std::move(track));
    }
    for (const wire::Look& each : in.looks()) {
        auto look = read(each);
        if (!look) return std::nullopt;
        tracks.looks.push_back(*std::move(look));
    }
    tracks.gone.assign(in.gone().begin(), in.gone().end());
    return tracks;
}

void write(int track, const ParticleCloud& cloud, std::size_t most, wire::Particles::Cloud& out) {
    const std::size_t size = std::min(cloud.position_m.size(), cloud.weight.size());
    const std::size_t stride = std::max<std::size_t>(1, (size + most - 1) / most);
    double sum = 0.0;
    for (std::size_t i = 0; i < size; i += stride) sum += static_cast<double>(cloud.weight[i]);
    out.set_track(track);
    out.set_effective(cloud.effective);
    out.set_size(static_cast<std::uint32_t>(cloud.size()));
    if (!(sum > 0.0)) return;
    for (std::size_t i = 0; i < size; i += stride) {
        out.add_north_m(cloud.position_m[i].x());
        out.add_east_m(cloud.position_m[i].y());
        out.add_weight(static_cast<float>(std::min(1.0, static_cast<double>(cloud.weight[i]) / sum)));
    }
}

std::optional<LinkClouds> read(const wire::Particles& in) {
    if (static_cast<std::size_t>(in.clouds_size()) > link_limits::most_tracks) return std::nullopt;
    LinkClouds clouds;
    for (const wire::Particles::Cloud& each : in.clouds()) {
        clouds.clouds.emplace_back(each.track(), ParticleCloud{});
        if (!readCloud(each, clouds.clouds.back().second)) return std::nullopt;
    }
    return clouds;
}

}  // namespace echotrail
