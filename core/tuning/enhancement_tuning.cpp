#include "core/tuning/enhancement_tuning.hpp"

#include "core/imaging/filters.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/tuning/enhancement_objective.hpp"

namespace echotrail {
namespace {

constexpr double guarded_least_b = 0.05;

std::vector<Bounds> boundsOf(EnhancementObjective objective) {
    return {
        {0.0, 1.5}, {objective == EnhancementObjective::Guarded ? guarded_least_b : 0.01, 0.5}, {0.0, 1.0}, {0.5, 1.5}};
}

LocalEnhancementParams paramsAt(const SwarmPoint& point) {
    LocalEnhancementParams params;
    params.enhance_a = point[0];
    params.enhance_b = point[1];
    params.enhance_c = point[2];
    params.enhance_k = point[3];
    return params;
}

double valueOf(const FanImage& plain, const FanImage& enhanced, EnhancementObjective objective) {
    return objective == EnhancementObjective::Published ? publishedObjective(enhanced)
                                                        : guardedObjective(plain, enhanced);
}

/// What the beam passed over since `since`, cut out.
FanImage sweepOf(const FanImage& fan, std::int32_t since_ms) {
    FanImage sweep = fan.clone();
    const cv::Mat older = sweep.beam_time_ms < since_ms;
    sweep.levels.setTo(0, older);
    sweep.beam_time_ms.setTo(FanImage::never_scanned, older);
    int top = sweep.levels.rows, bottom = -1, left = sweep.levels.cols, right = -1;
    for (int row = 0; row < sweep.levels.rows; ++row)
        for (int column = 0; column < sweep.levels.cols; ++column) {
            if (sweep.beam_time_ms.at<std::int32_t>(row, column) == FanImage::never_scanned) continue;
            top = std::min(top, row);
            bottom = std::max(bottom, row);
            left = std::min(left, column);
            right = std::max(right, column);
        }
    if (bottom < top) return {};
    const cv::Rect box(left, top, right - left + 1, bottom - top + 1);
    return {sweep.levels(box).clone(), sweep.beam_time_ms(box).clone(), fan.pixel_m, fan.northOf(top),
            fan.eastOf(left)};
}

}  // namespace

std::string_view toText(EnhancementObjective objective) {
    return objective == EnhancementObjective::Published ? "published" : "guarded";
}

std::vector<FanImage> sweepPictures(PingSource& source, int count) {
    std::vector<FanImage> pictures;
    const ScanningSonarPipeline::Params params;
    ScanningSonarPipeline pipeline(params, 0);
    const Timestamp start = source.info().start;
    const double whole_s = secondsBetween(start, source.info().end);
    Timestamp sweep_begun = start;
    source.rewind();
    FanImage before;  // as it stood before the ping that began the next sweep
    while (static_cast<int>(pictures.size()) < count) {
        const auto ping = source.next();
        if (!ping) break;
        const double due_s = whole_s * static_cast<double>(pictures.size() + 1) / (count + 1);
        const bool wanted = secondsBetween(start, ping->time) >= due_s;
        if (wanted) before = pipeline.fan().clone();
        const bool ended = pipeline.process(*ping, source.navigation()).sweep_ended;
        if (!ended) continue;
        const double begun_ms = 1e3 * secondsBetween(start, sweep_begun);
        sweep_begun = ping->time;
        if (!wanted || before.empty()) continue;
        FanImage sweep = sweepOf(before, static_cast<std::int32_t>(begun_ms));
        smoothGaussian(sweep.levels, params.regions.smoothing);
        if (!sweep.empty()) pictures.push_back(std::move(sweep));
    }
    return pictures;
}

TunedEnhancement tuneEnhancement(const std::vector<FanImage>& pictures, EnhancementObjective objective,
                                 std::uint64_t seed, const std::function<void(double)>& tell,
                                 const std::function<bool()>& cancelled) {
    const LocalEnhancementParams card;
    const SwarmParams swarm;
    TunedEnhancement tuned;
    if (pictures.empty()) return tuned;
    const auto mean = [&](const auto& enhanced) {
        double sum = 0;
        for (const FanImage& picture : pictures) sum += valueOf(picture, enhanced(picture), objective);
        return sum / static_cast<double>(pictures.size());
    };
    int done = 0;
    const auto evaluate = [&](std::span<const SwarmPoint> points, std::span<double> values) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const LocalEnhancementParams params = paramsAt(points[i]);
            values[i] = mean([&](const FanImage& picture) { return enhanceLocally(picture, params); });
            if (tell) tell(static_cast<double>(++done) / (swarm.particles * swarm.iterations));
        }
    };
    const SwarmResult found =
        maximise(evaluate, boundsOf(objective), {card.enhance_a, card.enhance_b, card.enhance_c, card.enhance_k}, seed,
                 swarm, cancelled);
    tuned.params = paramsAt(found.best);
    tuned.value = found.value;
    tuned.evaluations = found.evaluations;
    tuned.plain_value = mean([](const FanImage& picture) { return picture; });
    return tuned;
}

}  // namespace echotrail
