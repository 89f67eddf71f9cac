#pragma once

#include "core/base/parameters.hpp"

namespace echotrail {

/// How regions speak about a particle (method card, section f).
enum class LikelihoodForm {
    Soft,     ///< every gated region, by place, likeness and strength, against clutter (form C)
    Lookup,   ///< the score of the region that holds the particle, else nothing (form A, as published)
    Position  ///< by place alone, in closed form: probabilistic data association, the baseline
};
enum class MotionForm { ConstantVelocity, RandomWalk };
enum class Births { Everything, Picked };
enum class Sharing { Joint, Alone };
enum class PredictedCovariance { Refreshed, AsPrinted };

/// Which form of the method is used. The defaults are ours; resources/presets/paper.toml is the published one.
struct MethodParams {
    LikelihoodForm likelihood = LikelihoodForm::Soft;
    MotionForm motion = MotionForm::ConstantVelocity;
    double random_walk_sigma = 0.45;
    Births births = Births::Everything;
    Sharing sharing = Sharing::Joint;
    PredictedCovariance predicted_covariance = PredictedCovariance::Refreshed;
    bool motion_correction = true;
};

template <>
struct Described<MethodParams> {
    using P = MethodParams;
    static constexpr std::string_view group = "Form of the method";
    static constexpr auto fields = std::tuple{
        ChoiceField<P, LikelihoodForm, 3>{&P::likelihood,
                                          "likelihood",
                                          {"soft", "lookup", "position"},
                                          "How regions weigh particles: ours, as published, or by place alone"},
        ChoiceField<P, MotionForm, 2>{
            &P::motion, "motion", {"constant_velocity", "random_walk"}, "How objects are taken to move between looks"},
        Field{&P::random_walk_sigma, "random_walk_sigma", "m/√s", 0.01, 10,
              "Step of the random walk, where that is used"},
        ChoiceField<P, Births, 2>{
            &P::births, "births", {"everything", "picked"}, "Whether every region may start a track, or only a pick"},
        ChoiceField<P, Sharing, 2>{
            &P::sharing, "sharing", {"joint", "alone"}, "Whether tracks settle jointly whose echo a region is"},
        ChoiceField<P, PredictedCovariance, 2>{
            &P::predicted_covariance,
            "predicted_covariance",
            {"refreshed", "as_printed"},
            "As printed, equation 6 never refreshes the predicted covariance: only to show what that does"},
        flag(&P::motion_correction, "motion_correction",
             "Place each ping by where the vehicle was then; off, a whole sweep is drawn from where it began: only to "
             "show what that does")};
};

}  // namespace echotrail
