#include "core/runtime/replay_player.hpp"

#include "core/imaging/local_enhancement.hpp"
#include "core/runtime/processor_time.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace echotrail {
namespace {

// How much is done before the owner may change its mind: some milliseconds' worth each.
constexpr int pings_read_per_slice = 2000;
constexpr int pings_analysed_per_slice = 64;

}  // namespace

ReplayPlayer::ReplayPlayer(std::unique_ptr<PingSource> source, const Params& params, std::uint64_t seed,
                           bool as_recorded)
    : source_(std::move(source)), params_(params), seed_(seed), as_recorded_(as_recorded) {
    source_->rewind();
    restart();
}

bool ReplayPlayer::scan() {
    if (timeline_.ping_times) return true;
    for (int i = 0; i < pings_read_per_slice; ++i) {
        const auto ping = read();
        if (!ping) {
            timeline_.gaps = findGaps(scanned_times_);
            timeline_.ping_times = std::make_shared<const std::vector<Timestamp>>(scanned_times_);
            counts_ = source_->counts();
            return true;
        }
        scanned_times_.push_back(ping->time);
    }
    return false;
}

std::optional<Ping> ReplayPlayer::read() {
    auto ping = source_->next();
    if (ping) ++source_index_;
    return ping;
}

Ping ReplayPlayer::readKnown() {
    auto ping = read();
    if (!ping) throw std::runtime_error("the recording has become shorter since it was opened");
    return std::move(*ping);
}

bool ReplayPlayer::windTo(std::uint64_t index) {
    if (source_index_ > index) {
        source_->rewind();
        source_index_ = 0;
    }
    for (int i = 0; i < pings_read_per_slice && source_index_ < index; ++i) {
        readKnown();
        source_->takeControls();  // they were of pings that have been passed
    }
    return source_index_ == index;
}

bool ReplayPlayer::analyse() {
    if (timeline_.revision == revision_ && timeline_.analysed == size()) return true;
    if (!analysis_) {
        analysis_.emplace();
        analysis_->pipeline = std::make_unique<ScanningSonarPipeline>(params_, seed_);
        analysis_->pipeline->setFanPainting(false);
        analysis_->timeline = timeline_;
        analysis_->timeline.sweep_starts.clear();
        analysis_->timeline.confirmed.clear();
        analysis_->timeline.analysed = 0;
        analysis_->timeline.revision = revision_;
    }
    Timeline& found = analysis_->timeline;
    if (!windTo(found.analysed)) return false;
    for (int i = 0; i < pings_analysed_per_slice && found.analysed < size(); ++i) {
        const Ping ping = readKnown();
        applyRecorded(*analysis_->pipeline);
        const Update& update = analysis_->pipeline->process(ping, source_->navigation());
        // Tracks change when they were looked at; asking after every ping would copy every particle every time.
        if (!update.looks.empty()) analysis_->followed = anyFollowed(analysis_->pipeline->tracks());
        extendTimeline(found, found.analysed, update.sweep_ended, analysis_->followed);
    }
    if (found.analysed < size()) return false;
    timeline_ = std::move(found);
    analysis_.reset();
    return true;
}

bool ReplayPlayer::advance() {
    if (at_end_) return false;
    if (position_ == size()) {
        latest_ = pipeline_->finish();
        builder_->addFinal(latest_);
        at_end_ = true;
        return true;
    }
    if (!windTo(position_)) return false;
    ping_ = readKnown();
    applyRecorded(*pipeline_);
    const double before = processorSeconds();
    latest_ = pipeline_->process(ping_, source_->navigation());
    builder_->add(ping_, latest_, processorSeconds() - before, *pipeline_);
    ++position_;
    applyWishesHere();
    return true;
}

void ReplayPlayer::restart() {
    pipeline_ = std::make_unique<ScanningSonarPipeline>(params_, seed_);
    builder_.emplace();
    ping_ = {};
    latest_ = {};
    position_ = 0;
    at_end_ = false;
    params_told_ = false;
    applyWishesHere();
}

void ReplayPlayer::setParams(const Params& params, std::uint64_t revision) {
    params_ = params;
    revision_ = revision;
    as_recorded_ = false;
    analysis_.reset();
    pipeline_->setParams(params);
}

void ReplayPlayer::designate(double range_m, Bearing from_bow) {
    remember({.kind = RunControl::Kind::Designation, .range_m = range_m, .from_bow = from_bow});
}

void ReplayPlayer::clearDesignation() { remember({.kind = RunControl::Kind::ClearDesignation}); }

void ReplayPlayer::drop(int track, double range_m, Bearing from_bow) {
    remember({.kind = RunControl::Kind::Drop, .range_m = range_m, .from_bow = from_bow, .track = track});
}

void ReplayPlayer::restore(int track) { remember({.kind = RunControl::Kind::Restore, .track = track}); }

void ReplayPlayer::remember(const RunControl& control) {
    // A new wish replaces those made further on in an earlier run: they would surprise the operator now.
    std::erase_if(wishes_, [&](const Wish& old) {
        return old.position > position_ ||
               (old.position == position_ && old.control.kind == control.kind && old.control.track == control.track);
    });
    wishes_.push_back({position_, control});
    pipeline_->command(control);
}

/// What the operator did in the run that was recorded. Parameters only until the operator of the replay sets some.
void ReplayPlayer::applyRecorded(ScanningSonarPipeline& pipeline) {
    for (const RunControl& control : source_->takeControls()) {
        if (control.kind != RunControl::Kind::Parameters) {
            pipeline.command(control);
            continue;
        }
        Params params;
        if (!as_recorded_ || !applyRecordedParameters(params, control.parameters)) continue;
        pipeline.setParams(params);
        if (&pipeline == pipeline_.get()) params_told_ = false;
    }
}

std::optional<ReplayPlayer::Params> ReplayPlayer::takeRecordedParams() {
    if (!as_recorded_ || std::exchange(params_told_, true)) return std::nullopt;
    return pipeline_->params();
}

void ReplayPlayer::applyWishesHere() {
    for (const Wish& wish : wishes_)
        if (wish.position == position_) pipeline_->command(wish.control);
}

bool ReplayPlayer::designated() const {
    bool wanted = false;
    for (const Wish& wish : wishes_) {
        if (wish.position > position_) continue;
        if (wish.control.kind == RunControl::Kind::Designation) wanted = true;
        if (wish.control.kind == RunControl::Kind::ClearDesignation) wanted = false;
    }
    return wanted;
}

Scene ReplayPlayer::scene() const {
    Scene scene = builder_->build(*pipeline_, ping_, latest_);
    scene.position = position_;
    scene.counts = counts_;
    scene.navigation_known = !source_->navigation().empty();
    scene.at_end = at_end_;
    if (enhanced_) scene.enhanced = enhanceLocally(scene.fan, pipeline_->params().enhancement);
    return scene;
}

}  // namespace echotrail
