#pragma once

#include "core/base/parameters.hpp"
#include "core/data/head_settings.hpp"
#include "core/data/track.hpp"
#include "core/tracking/beam_pass.hpp"

#include <optional>

namespace echotrail {

struct FollowParams {
    bool follow_target = false;
    double follow_least_width_deg = 18.0;
    double follow_margin_sigmas = 3.0;
    double follow_slack_deg = 2.0;
    double follow_widening = 2.0;
    double follow_look_round_s = 20.0;
};

template <>
struct Described<FollowParams> {
    using P = FollowParams;
    static constexpr std::string_view group = "The head follows the target";
    static constexpr auto fields = std::tuple{
        flag(&P::follow_target, "follow_target",
             "The head scans only about the designated target, and so looks at it several times as often; never beyond "
             "the sector that is set, and all of that while there is no target or it is lost"),
        Field{&P::follow_least_width_deg, "follow_least_width_deg", "deg", 5, 180,
              "The narrowest sector it scans then"},
        Field{&P::follow_margin_sigmas, "follow_margin_sigmas", "", 1, 10,
              "Deviations of the expected place that are scanned to each side of it"},
        Field{&P::follow_slack_deg, "follow_slack_deg", "deg", 0, 30,
              "What the sector has to spare at each side, so that the head is not told anew at every ping"},
        Field{&P::follow_widening, "follow_widening", "", 1, 10,
              "Each look in a row without an echo makes the sector this many times as wide"},
        Field{&P::follow_look_round_s, "follow_look_round_s", "s", 0, 600,
              "So long after it last did, the head scans all of its sector once for the sake of the rest; 0: never"}};
};

/// The operator's target as it is expected at its next look.
struct TargetOutlook {
    TrackState state = TrackState::Tentative;
    int misses = 0;             ///< looks in a row without an echo
    GaussianState expected;     ///< predicted to that time
    double across_range_m = 0;  ///< how wide its echo is expected, beam and all
};

/// Chooses what the head scans next: about the place where the operator's target is expected, so that the same head
/// looks there several times as often. Never more than the operator's sector; all of it where there is no proven
/// target, it is lost, or no part of where it may be lies within; and all of it now and then, for the sake of the rest.
/// Order: choose() once per ping, in time order. State: the sector chosen last, so that it is kept while it will do.
class SectorFollower {
public:
    explicit SectorFollower(const FollowParams& params) : params_(params) {}
    void setParams(const FollowParams& params) { params_ = params; }

    /// The sector for the pings to come, narrower than the one of `head`; nothing where that one is to be scanned.
    /// Its edges are whole steps from that one's, so that the beam goes on over the same bearings.
    const std::optional<ScanSector>& choose(const std::optional<TargetOutlook>& target, const BeamMoment& beam,
                                            const HeadSettings& head);
    const std::optional<ScanSector>& chosen() const { return chosen_; }

private:
    /// Part of the operator's sector: degrees clockwise from its left edge.
    struct Part {
        double from = 0.0, until = 0.0;
    };
    std::optional<Part> needed(const TargetOutlook& target, const BeamMoment& beam, const ScanSector& limit) const;
    Part withSlack(const Part& needed, const ScanSector& limit, double step_deg, bool from_left) const;
    bool willDo(const Part& needed, const ScanSector& limit) const;
    void beginRound();
    bool looksRound(const BeamMoment& beam, const ScanSector& limit);

    FollowParams params_;
    std::optional<ScanSector> chosen_;
    ScanSector limit_;          ///< that it was chosen in
    Part seen_round_{360, 0};   ///< of the operator's sector, since the beam began to look round
    std::optional<Timestamp> looked_round_;  ///< when the beam had been all over it; nothing while it is on its way
};

}  // namespace echotrail
