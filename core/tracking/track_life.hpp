#pragma once

#include "core/base/parameters.hpp"
#include "core/data/track.hpp"

namespace echotrail {

struct LifeParams {
    double birth_existence = 0.2;
    double picked_existence = 0.9;
    double confirm_existence = 0.99;
    int confirm_looks = 3;
    double confirm_sigma_m = 2.5;
    double lost_existence = 0.05;
    int lost_misses = 4;
    double lost_after_s = 30.0;
    int tentative_misses = 2;
    double remember_s = 120.0;
    double survival_per_sweep = 0.98;
    double miss_widening = 1.5;
    double widest_sigma_m = 8.0;
    double widest_sigma_mps = 0.7;
    double reacquire_score = 0.6;
};

template <>
struct Described<LifeParams> {
    using P = LifeParams;
    static constexpr std::string_view group = "Life of a track";
    static constexpr auto fields = std::tuple{
        Field{&P::birth_existence, "birth_existence", "", 0.01, 0.9, "Probability that a new region is an object"},
        Field{&P::picked_existence, "picked_existence", "", 0.1, 0.999, "The same where the operator pointed at it"},
        Field{&P::confirm_existence, "confirm_existence", "", 0.5, 0.9999,
              "A track is confirmed above this probability"},
        Field{&P::confirm_looks, "confirm_looks", "looks", 1, 20, "… and with at least this many echoes"},
        Field{&P::confirm_sigma_m, "confirm_sigma_m", "m", 0.1, 1000,
              "… and where its place is known to this deviation: echoes here and there are no object yet"},
        Field{&P::lost_existence, "lost_existence", "", 0.001, 0.5, "A track is lost below this probability"},
        Field{&P::lost_misses, "lost_misses", "looks", 1, 50, "… or after this many looks in a row without an echo"},
        Field{&P::lost_after_s, "lost_after_s", "s", 1, 600, "… or this long after its last echo"},
        Field{&P::tentative_misses, "tentative_misses", "looks", 1, 20,
              "A track that was never confirmed is dropped after this many looks without an echo"},
        Field{&P::remember_s, "remember_s", "s", 0, 3600,
              "A lost track may be found again this long after its last echo"},
        Field{&P::survival_per_sweep, "survival_per_sweep", "", 0.5, 1,
              "Probability that an object is still there a sweep later"},
        Field{&P::miss_widening, "miss_widening", "", 1, 5,
              "A look without an echo multiplies the position covariance by this"},
        Field{&P::widest_sigma_m, "widest_sigma_m", "m", 0.5, 50, "… but not beyond this deviation"},
        Field{&P::widest_sigma_mps, "widest_sigma_mps", "m/s", 0.05, 20,
              "Nor does the deviation of the velocity grow beyond this in the search"},
        Field{&P::reacquire_score, "reacquire_score", "", 0, 1,
              "A lost track is found again by two looks running that are this much like it"}};
};

/// What came of one pass of the beam over a track's place.
enum class LookResult {
    Seen,
    Missed,       ///< the beam was there and there was no echo
    NotLookedAt,  ///< the beam did not cover the place: no evidence either way
};

/// Existence probability after evidence `likelihood_ratio` (of the echoes, object against clutter alone):
/// r⁺ = Λr / (1 − r + Λr), kept within [1e-6, 1 − 1e-6] so that it can always change its mind.
double existenceAfter(double existence, double likelihood_ratio);

/// Counts the look and moves the track through tentative → confirmed → coasting → lost. A lost track stays lost
/// here; it comes back by reacquire().
void advanceLife(Track& track, LookResult result, double likelihood_ratio, Timestamp time, const LifeParams& params);

/// A lost track that was found again goes on as confirmed.
void reacquire(Track& track, Timestamp time);

/// Widens the position covariance after a miss, so that the search grows.
void widenSearch(Track& track, const LifeParams& params);

/// Whether a tentative track was given up, or a lost one has been lost for too long to remember.
bool isForgotten(const Track& track, Timestamp now, const LifeParams& params);

}  // namespace echotrail
