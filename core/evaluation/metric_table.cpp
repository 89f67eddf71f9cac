#include "core/evaluation/metric_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace echotrail {
namespace {

using Value = std::optional<MetricValue>;
using Summary = ScenarioSummary;
constexpr double seconds_per_hour = 3600.0;

/// The mean over trials of a number that each has, or may have. Student's interval knows no least value; `least` cuts
/// off what cannot be.
template <class Of>
Value meanOver(const Summary& summary, const Of& of, double least = 0.0) {
    const std::vector<double> values = summary.each(of);
    if (values.empty()) return std::nullopt;
    const MeanEstimate estimate = meanEstimate(values);
    MetricValue value{.value = estimate.mean, .worst = *std::max_element(values.begin(), values.end())};
    if (values.size() > 1)
        value.interval = ConfidenceInterval{std::max(least, estimate.interval.low), estimate.interval.high};
    return value;
}

/// The median over trials, and the greatest.
template <class Of>
Value medianOver(const Summary& summary, const Of& of) {
    const FiveNumbers numbers = fiveNumbers(summary.each(of));
    if (summary.each(of).empty()) return std::nullopt;
    return MetricValue{numbers.median, std::nullopt, numbers.greatest};
}

/// Deviations of one kind of output, per trial that has any.
template <DeviationStatistics TrialMetrics::*kind>
std::optional<double> meanOf(const TrialMetrics& trial) {
    return (trial.*kind).count ? std::optional((trial.*kind).mean_m()) : std::nullopt;
}
template <DeviationStatistics TrialMetrics::*kind>
std::optional<double> greatestOf(const TrialMetrics& trial) {
    return (trial.*kind).count ? std::optional((trial.*kind).greatest_m) : std::nullopt;
}
template <DeviationStatistics TrialMetrics::*kind>
Value meanDeviation(const Summary& summary) {
    return meanOver(summary, meanOf<kind>);
}
template <DeviationStatistics TrialMetrics::*kind>
Value greatestDeviation(const Summary& summary) {
    return medianOver(summary, greatestOf<kind>);
}

/// The same in percent of the range scale.
Value ofRange(const Summary& summary, Value value) {
    if (!value || summary.pooled.range_scale_m <= 0) return std::nullopt;
    const double factor = 100.0 / summary.pooled.range_scale_m;
    value->value *= factor;
    if (value->worst) *value->worst *= factor;
    if (value->interval) value->interval = {factor * value->interval->low, factor * value->interval->high};
    return value;
}

template <DeviationStatistics TrialMetrics::*kind>
Value rms(const Summary& summary) {
    const DeviationStatistics& all = summary.pooled.*kind;
    return all.count ? Value(MetricValue{all.rms_m()}) : std::nullopt;
}

template <ConsistencyStatistics TrialMetrics::*kind>
Value nees(const Summary& summary) {
    if ((summary.pooled.*kind).count == 0) return std::nullopt;
    Value value = meanOver(summary, [](const TrialMetrics& trial) {
        return (trial.*kind).count ? std::optional((trial.*kind).nees()) : std::nullopt;
    });
    value->expected = neesBounds((summary.pooled.*kind).count);
    return value;
}

template <ConsistencyStatistics TrialMetrics::*kind>
Value coverage(const Summary& summary) {
    const ConsistencyStatistics& all = summary.pooled.*kind;
    if (all.count == 0) return std::nullopt;
    const ConfidenceInterval share = wilsonInterval(all.inside, all.count);
    return MetricValue{100 * all.coverage(), ConfidenceInterval{100 * share.low, 100 * share.high}};
}

Value lossPooled(const Summary& summary) {
    const TrialMetrics& all = summary.pooled;
    if (all.opportunities == 0) return std::nullopt;
    const ConfidenceInterval share = wilsonInterval(all.opportunities - all.correct, all.opportunities);
    return MetricValue{100 * all.loss(), ConfidenceInterval{100 * share.low, 100 * share.high}};
}

std::optional<double> lossOf(const TrialMetrics& trial) {
    return trial.opportunities ? std::optional(100 * trial.loss()) : std::nullopt;
}

template <std::size_t TrialMetrics::*outcome>
Value shareOfLooks(const Summary& summary) {
    const TrialMetrics& all = summary.pooled;
    if (all.opportunities == 0) return std::nullopt;
    const ConfidenceInterval share = wilsonInterval(all.*outcome, all.opportunities);
    return MetricValue{100.0 * static_cast<double>(all.*outcome) / static_cast<double>(all.opportunities),
                       ConfidenceInterval{100 * share.low, 100 * share.high}};
}

template <double Gospa::*part>
Value gospaPart(const Summary& summary) {
    const TrialMetrics& all = summary.pooled;
    return all.sweeps ? Value(MetricValue{std::sqrt(all.gospa_sum.*part / all.sweeps)}) : std::nullopt;
}

std::optional<double> gospaOf(const TrialMetrics& trial) {
    return trial.sweeps ? std::optional(trial.gospa_sum.distance() / std::sqrt(trial.sweeps)) : std::nullopt;
}

std::optional<double> ospaOf(const TrialMetrics& trial) {
    return trial.sweeps ? std::optional(trial.ospa_sum_m / trial.sweeps) : std::nullopt;
}

std::optional<double> motaOf(const TrialMetrics& trial) {
    return trial.mot.objects ? std::optional(100 * trial.mot.mota()) : std::nullopt;
}

/// More is better here, so that the least is the worst; and it may be negative.
Value mota(const Summary& summary) {
    Value value = meanOver(summary, motaOf, -HUGE_VAL);
    if (value) value->worst = fiveNumbers(summary.each(motaOf)).least;
    return value;
}

template <int ClearMot::Counts::*count>
Value motShare(const Summary& summary) {
    const ClearMot::Counts& all = summary.pooled.mot;
    if (all.objects == 0) return std::nullopt;
    return MetricValue{100.0 * (all.*count) / all.objects};
}

template <int TrialMetrics::*count>
Value perHour(const Summary& summary) {
    const double hours = summary.pooled.data_s / seconds_per_hour;
    if (hours <= 0) return std::nullopt;
    const int events = summary.pooled.*count;
    return MetricValue{events / hours, poissonRateInterval(static_cast<std::size_t>(events), hours)};
}

template <int TrialMetrics::*count>
Value perTrial(const Summary& summary) {
    return meanOver(summary, [](const TrialMetrics& trial) { return std::optional<double>(trial.*count); });
}

Value opportunities(const Summary& summary) {
    if (summary.trials.empty()) return std::nullopt;
    return MetricValue{static_cast<double>(summary.pooled.opportunities) / static_cast<double>(summary.trials.size())};
}

Value looksPerSecond(const Summary& summary) {
    return meanOver(summary, [](const TrialMetrics& trial) {
        return trial.data_s > 0 ? std::optional(static_cast<double>(trial.correct) / trial.data_s) : std::nullopt;
    });
}

Value reacquisition(const Summary& summary) {
    const FiveNumbers numbers = fiveNumbers(summary.pooled.reacquired_after_s);
    if (summary.pooled.reacquired_after_s.empty()) return std::nullopt;
    return MetricValue{numbers.median, std::nullopt, numbers.greatest};
}

std::optional<double> percentOfPublishedRange(double deviation_m) { return 100.0 * deviation_m / 50.0; }

using M = TrialMetrics;
using P = PublishedTrial;
constexpr auto Higher = Metric::Better::Higher;
constexpr auto Lower = Metric::Better::Lower;

constexpr std::array metrics{
    Metric{"loss_percent", "Loss rate", "%", 1, Lower,
           "Share of opportunities (sweeps whose scanned area held the target) without a confirmed estimate from the "
           "target's own echo; over all trials together, Wilson interval",
           lossPooled, [](const P& p) { return std::optional(p.loss_percent); }, true, true},
    Metric{"loss_mean_percent", "Loss rate, mean over trials", "%", 1, Lower,
           "The loss rates of the trials averaged, with the interval that their scatter allows (Student's t)",
           [](const Summary& s) { return meanOver(s, lossOf); }},
    Metric{"deviation_mean_m", "Mean deviation", "m", 2, Lower,
           "Distance between estimate and truth over correct looks; mean over trials, interval by Student's t",
           meanDeviation<&M::of_correct>, [](const P& p) { return std::optional(p.deviation_mean_m); }, true},
    Metric{"deviation_max_m", "Greatest deviation", "m", 2, Lower,
           "The greatest over correct looks in a trial; median over trials", greatestDeviation<&M::of_correct>,
           [](const P& p) { return std::optional(p.deviation_max_m); }, true},
    Metric{"deviation_mean_percent", "Mean deviation", "% of range scale", 2, Lower,
           "Mean deviation over the range scale",
           [](const Summary& s) { return ofRange(s, meanDeviation<&M::of_correct>(s)); },
           [](const P& p) { return percentOfPublishedRange(p.deviation_mean_m); }},
    Metric{"deviation_max_percent", "Greatest deviation", "% of range scale", 2, Lower,
           "Greatest deviation over the range scale",
           [](const Summary& s) { return ofRange(s, greatestDeviation<&M::of_correct>(s)); },
           [](const P& p) { return percentOfPublishedRange(p.deviation_max_m); }},
    Metric{"coasted_percent", "Looks coasted", "% of opportunities", 1, Lower, "The track went on by prediction alone",
           shareOfLooks<&M::coasted>},
    Metric{"wrong_percent", "Looks at something else", "% of opportunities", 1, Lower,
           "The track took an echo that is not the target's", shareOfLooks<&M::wrong>},
    Metric{"absent_percent", "Looks without a track", "% of opportunities", 1, Lower,
           "There was no confirmed track of the target", shareOfLooks<&M::absent>},
    Metric{"coasting_mean_m", "Mean deviation, coasting", "m", 2, Lower, "Over outputs by prediction",
           meanDeviation<&M::of_coasted>},
    Metric{"coasting_max_m", "Greatest deviation, coasting", "m", 2, Lower,
           "The greatest over outputs by prediction in a trial; median over trials", greatestDeviation<&M::of_coasted>},
    Metric{"wrong_mean_m", "Mean deviation, wrong echo", "m", 2, Lower,
           "Over outputs from echoes that are not the target's", meanDeviation<&M::of_wrong>},
    Metric{"output_mean_m", "Mean deviation, all outputs", "m", 2, Lower,
           "Over all confirmed and coasting outputs of the followed track", meanDeviation<&M::of_all>, nullptr, true},
    Metric{"output_max_m", "Greatest deviation, all outputs", "m", 2, Lower,
           "The greatest over all confirmed and coasting outputs in a trial; median over trials",
           greatestDeviation<&M::of_all>, nullptr, true},
    Metric{"rmse_position_m", "RMS error of position", "m", 2, Lower, "Root mean square over correct looks",
           rms<&M::of_correct>, nullptr, true},
    Metric{"rmse_output_m", "RMS error of position, all outputs", "m", 2, Lower, "Root mean square over all outputs",
           rms<&M::of_all>},
    Metric{"report_mean_m", "Mean error of reports", "m", 2, Lower,
           "Distance between the target and where it is said to be by then, at every ping while its track lives",
           meanDeviation<&M::of_reports>, nullptr, true},
    Metric{"report_max_m", "Greatest error of reports", "m", 2, Lower,
           "The greatest in a trial; median over trials", greatestDeviation<&M::of_reports>},
    Metric{"rmse_velocity_mps", "RMS error of velocity", "m/s", 3, Lower, "Root mean square over correct looks",
           [](const Summary& s) { return s.pooled.velocity_known ? rms<&M::velocity_of_correct>(s) : Value(); },
           nullptr, true},
    Metric{
        "nees", "NEES", "ideal 2", 2, Lower,
        "Normalised estimation error squared of the position over correct looks; 2 in the mean where the covariance "
        "is honest, more where it is too small; interval by Student's t over trials, in brackets the chi-square bounds "
        "that hold for as many independent looks",
        nees<&M::consistency_of_correct>, nullptr, true, true},
    Metric{"coverage_percent", "Truth within the 95 % ellipse", "% of correct looks", 1, Higher,
           "95 where the covariance is honest; Wilson interval", coverage<&M::consistency_of_correct>, nullptr, true,
           true},
    Metric{"coverage_output_percent", "Truth within the 95 % ellipse", "% of all outputs", 1, Higher,
           "The same over all confirmed and coasting outputs", coverage<&M::consistency_of_all>},
    Metric{"ospa_m", "OSPA", "m", 2, Lower, "Order 2, cut-off 7.5 m, at the end of every sweep; mean over trials",
           [](const Summary& s) { return meanOver(s, ospaOf); }, nullptr, true},
    Metric{"gospa_m", "GOSPA", "m", 2, Lower,
           "p = 2, alpha = 2, c = 7.5 m, at the end of every sweep; root mean square, mean over trials",
           [](const Summary& s) { return meanOver(s, gospaOf); }, nullptr, true},
    Metric{"gospa_localisation_m", "GOSPA, localisation", "m", 2, Lower,
           "Part of GOSPA; the squares of the three parts add up", gospaPart<&Gospa::localisation_m2>},
    Metric{"gospa_missed_m", "GOSPA, missed targets", "m", 2, Lower, "Part of GOSPA", gospaPart<&Gospa::missed_m2>},
    Metric{"gospa_false_m", "GOSPA, false tracks", "m", 2, Lower, "Part of GOSPA", gospaPart<&Gospa::false_m2>},
    Metric{"mota_percent", "MOTA", "%", 1, Higher,
           "CLEAR MOT accuracy: 100 less misses, false positives and switches in percent of targets; pairs up to 7.5 m",
           mota},
    Metric{"motp_m", "MOTP", "m", 2, Lower, "CLEAR MOT precision: mean distance of matched pairs",
           [](const Summary& s) {
               return s.pooled.mot.matches ? Value(MetricValue{s.pooled.mot.motp_m()}) : std::nullopt;
           }},
    Metric{"mot_misses_percent", "MOT misses", "% of targets", 1, Lower, "Targets without a track",
           motShare<&ClearMot::Counts::misses>},
    Metric{"mot_false_percent", "MOT false positives", "% of targets", 1, Lower, "Tracks without a target or object",
           motShare<&ClearMot::Counts::false_positives>},
    Metric{"id_switches", "MOT identity switches", "per trial", 2, Lower, "Targets found by another track than before",
           [](const Summary& s) {
               return meanOver(s, [](const M& trial) { return std::optional<double>(trial.mot.switches); });
           }},
    Metric{"false_tracks_per_hour", "False confirmed tracks", "per hour", 2, Lower,
           "Confirmed tracks that never followed anything real; interval by the Poisson law", perHour<&M::false_tracks>,
           nullptr, true, true},
    Metric{"debris_tracks_per_hour", "Confirmed tracks of debris", "per hour", 2, Lower,
           "Confirmed tracks of something real that is no target: debris, rock, a wake", perHour<&M::debris_tracks>, nullptr,
           false, true},
    Metric{"target_switches", "Target lost to something else", "per trial", 2, Lower,
           "The followed track went astray and the operator pointed again", perTrial<&M::target_switches>},
    Metric{"renewed_picks", "Renewed picks", "per trial", 2, Lower, "The operator had to point again",
           perTrial<&M::renewed_picks>, nullptr, true},
    Metric{"confirm_s", "Time to confirm", "s", 1, Lower,
           "From the first opportunity to the first correct look; median over the trials that came to one",
           [](const Summary& s) { return medianOver(s, [](const M& trial) { return trial.confirmed_after_s; }); },
           nullptr, true},
    Metric{"unconfirmed_percent", "Trials never confirmed", "% of trials", 1, Lower, "Trials without a correct look",
           [](const Summary& s) {
               return meanOver(s, [](const M& trial) {
                   return trial.opportunities ? std::optional(trial.confirmed_after_s ? 0.0 : 100.0) : std::nullopt;
               });
           }},
    Metric{"reacquire_s", "Time to re-acquire", "s", 1, Lower,
           "Between two correct looks with others between them; median over all", reacquisition},
    Metric{"contrast_db", "Signal to clutter", "dB", 1, Higher,
           "Contrast of the target's own regions over their background; mean over trials",
           [](const Summary&
                  s) { return s.pooled.contrast_db > 0 ? Value(MetricValue{s.pooled.contrast_db}) : std::nullopt; },
           nullptr, true},
    Metric{"opportunities", "Opportunities", "per trial", 1, Higher, "Sweeps whose scanned area held the target",
           opportunities, [](const P& p) { return std::optional(static_cast<double>(p.looks)); }},
    Metric{"looks_per_s", "Looks per second", "1/s", 3, Higher,
           "Correct looks at the target over all of the time; more where the head follows it",
           looksPerSecond, nullptr, true},
    Metric{
        "processing_ms", "Processor time", "ms per ping", 3, Lower,
        "Of the pipeline alone, on the machine that made this report",
        [](const Summary&
               s) { return s.processing_ms_per_ping > 0 ? Value(MetricValue{s.processing_ms_per_ping}) : std::nullopt; },
        nullptr, true}};

constexpr std::array published{
    PublishedTrial{"S1", 243, 205, 15.6, 4.61, 3.23}, PublishedTrial{"S2", 257, 232, 9.7, 3.75, 2.44},
    PublishedTrial{"S3", 494, 435, 11.9, 4.23, 2.93}, PublishedTrial{"S4", 833, 797, 4.3, 2.34, 1.12},
    PublishedTrial{"S5", 206, 187, 9.2, 3.52, 2.31}};

}  // namespace

std::span<const PublishedTrial> publishedTrials() { return published; }

const PublishedTrial* publishedTrial(std::string_view scenario) {
    for (const PublishedTrial& trial : published)
        if (trial.scenario == scenario) return &trial;
    return nullptr;
}

std::span<const Metric> metricTable() { return metrics; }

const Metric* findMetric(std::string_view name) {
    for (const Metric& metric : metrics)
        if (metric.name == name) return &metric;
    return nullptr;
}

Result<Requirement> parseRequirement(const std::string& text) {
    const auto equals = text.rfind('=');
    if (equals == std::string::npos) return Error{"'" + text + "' is not NAME=VALUE"};
    Requirement requirement{.text = text};
    std::string name = text.substr(0, equals);
    if (const auto slash = name.rfind('/'); slash != std::string::npos) {
        requirement.scene = name.substr(0, slash);
        name.erase(0, slash + 1);
        if (const auto colon = requirement.scene.rfind(':'); colon != std::string::npos) {
            requirement.column = requirement.scene.substr(0, colon);
            requirement.scene.erase(0, colon + 1);
        }
    } else if (const auto colon = name.rfind(':'); colon != std::string::npos) {
        requirement.column = name.substr(0, colon);
        name.erase(0, colon + 1);
    }
    requirement.metric = findMetric(name);
    if (!requirement.metric) {
        std::string known;
        for (const Metric& metric : metrics) known.append(known.empty() ? "" : ", ").append(metric.name);
        return Error{"no figure is called '" + name + "'; there are " + known};
    }
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data() + equals + 1, end, requirement.limit);
    if (failure != std::errc() || stop != end || !std::isfinite(requirement.limit))
        return Error{"'" + text + "': the value has to be a number"};
    return requirement;
}

bool meets(const Requirement& requirement, const ScenarioSummary& summary) {
    const auto found = requirement.metric->of(summary);
    if (!found) return false;
    return requirement.metric->better == Metric::Better::Lower ? found->value <= requirement.limit
                                                               : found->value >= requirement.limit;
}

}  // namespace echotrail
