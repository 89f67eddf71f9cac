#include "core/tracking/sector_follower.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double tolerance_deg = 1e-6;

/// `bearing` in degrees clockwise from the sector's left edge; what is outside on the left is negative.
double offsetIn(const ScanSector& sector, Bearing from_bow) {
    const double from_centre = degreesFromRadians(from_bow - Bearing::degrees(sector.centre_deg));
    return from_centre + sector.width_deg / 2.0;
}

}  // namespace

const std::optional<ScanSector>& SectorFollower::choose(const std::optional<TargetOutlook>& target,
                                                        const BeamMoment& beam, const HeadSettings& head) {
    const ScanSector limit = scanSector(head);
    if (!(limit == limit_)) {
        limit_ = limit;
        chosen_.reset();
        beginRound();
    }
    const bool proven =
        target && (target->state == TrackState::Confirmed || target->state == TrackState::Coasting);
    const auto wanted = params_.follow_target && proven ? needed(*target, beam, limit) : std::nullopt;
    const bool round = looksRound(beam, limit);  // also while nothing is followed, to know when it was last
    if (!wanted || round) {
        chosen_.reset();
        return chosen_;
    }
    if (chosen_ && willDo(*wanted, limit)) return chosen_;
    const Part part = withSlack(*wanted, limit, degreesFromRadians(beam.step_rad), head.mount_inverted);
    const double width = part.until - part.from;
    if (width >= limit.width_deg - tolerance_deg)
        chosen_.reset();
    else
        chosen_ = ScanSector{(limit.left() + radiansFromDegrees(part.from + width / 2.0)).inDegrees(), width};
    return chosen_;
}

/// What has to be scanned, cut to the limit; nothing where the target can be seen nowhere in it, or anywhere.
std::optional<SectorFollower::Part> SectorFollower::needed(const TargetOutlook& target, const BeamMoment& beam,
                                                           const ScanSector& limit) const {
    const ExpectedPlace place = expectedPlace(target.expected, beam.head);
    const double reach_m = params_.follow_margin_sigmas * place.across_sigma_m + target.across_range_m / 2.0;
    if (reach_m >= place.range_m) return std::nullopt;  // it may be all about the head
    // The beam has to leave the echo at either side: then it is whole.
    const double beside_rad = std::atan2(reach_m, place.range_m) + 2.0 * beam.step_rad;
    const double half_deg = degreesFromRadians(beside_rad) * std::pow(params_.follow_widening, target.misses);
    const Bearing from_bow = place.azimuth + -beam.head.heading.inRadians();
    const double middle = offsetIn(limit, from_bow);
    Part part{middle - half_deg, middle + half_deg};
    if (part.until - part.from >= limit.width_deg) return std::nullopt;
    // Round and round has no edge, but the way over it is no sector: the part is moved to this side of it.
    if (limit.fullCircle()) return part;
    if (part.until <= 0.0 || part.from >= limit.width_deg) return std::nullopt;
    return Part{std::max(part.from, 0.0), std::min(part.until, limit.width_deg)};
}

/// Widened by what it is to have to spare, up to whole steps from the edge that the head counts from.
SectorFollower::Part SectorFollower::withSlack(const Part& needed, const ScanSector& limit, double step_deg,
                                               bool from_left) const {
    const double missing = params_.follow_least_width_deg - (needed.until - needed.from);
    const double more = std::max(params_.follow_slack_deg, missing / 2.0);
    Part part{needed.from - more, needed.until + more};
    if (!limit.fullCircle()) {
        // At an edge there is nothing on the other side, and so more on this one.
        const double shift = std::max(-part.from, 0.0) - std::max(part.until - limit.width_deg, 0.0);
        const double least = std::min(params_.follow_least_width_deg, limit.width_deg);
        part = {std::max(part.from, 0.0), std::min(part.until, limit.width_deg)};
        if (shift > 0.0) part.until = std::min(std::max(part.until, least), limit.width_deg);
        if (shift < 0.0) part.from = std::max(std::min(part.from, limit.width_deg - least), 0.0);
    }
    const double anchor = from_left ? 0.0 : limit.width_deg;
    const auto onGrid = [&](double offset, auto rounded) {
        return anchor + rounded((offset - anchor) / step_deg) * step_deg;
    };
    part.from = onGrid(part.from + tolerance_deg, [](double steps) { return std::floor(steps); });
    part.until = onGrid(part.until - tolerance_deg, [](double steps) { return std::ceil(steps); });
    if (limit.fullCircle()) return part;
    return {std::max(part.from, 0.0), std::min(part.until, limit.width_deg)};
}

/// Whether the sector chosen before holds all that is needed, and not much more.
bool SectorFollower::willDo(const Part& needed, const ScanSector& limit) const {
    const double from = offsetIn(*chosen_, limit.left() + radiansFromDegrees(needed.from));
    const double width = needed.until - needed.from;
    if (from < -tolerance_deg || from + width > chosen_->width_deg + tolerance_deg) return false;
    const double usual = std::max(width + 2.0 * params_.follow_slack_deg, params_.follow_least_width_deg);
    return chosen_->width_deg <= usual + 2.0 * params_.follow_slack_deg;
}

void SectorFollower::beginRound() {
    looked_round_.reset();
    seen_round_ = {360.0, 0.0};
}

/// Whether the beam is to go over all of the operator's sector now.
bool SectorFollower::looksRound(const BeamMoment& beam, const ScanSector& limit) {
    if (looked_round_) {
        const bool due = params_.follow_look_round_s > 0.0 &&
                         secondsBetween(*looked_round_, beam.time) >= params_.follow_look_round_s;
        if (!due) return false;
        beginRound();
    }
    const double offset = offsetIn(limit, beam.azimuth + -beam.head.heading.inRadians());
    seen_round_ = {std::min(seen_round_.from, offset), std::max(seen_round_.until, offset)};
    const double edge = 1.5 * degreesFromRadians(beam.step_rad);
    if (seen_round_.from > edge || seen_round_.until < limit.width_deg - edge) return true;
    looked_round_ = beam.time;
    return false;
}

}  // namespace echotrail
