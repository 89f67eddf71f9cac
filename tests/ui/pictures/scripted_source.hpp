#pragma once

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/runtime/run_timeline.hpp"
#include "core/runtime/scene_builder.hpp"
#include "core/simulation/simulated_source.hpp"
#include "ui/bridge/live_source.hpp"

#include <functional>
#include <optional>
#include <utility>

namespace echotrail::test {

/// A scenario that passes for a head: it goes on when it is told to, not with the clock.
class ScriptedHead {
public:
    explicit ScriptedHead(std::string_view scenario);
    void designate(double range_m, Bearing from_bow) { pipeline_.designate(range_m, from_bow); }
    /// Takes in the pings up to so many seconds from the first.
    void goTo(double seconds);
    /// Of the last ping.
    Timestamp now() const { return ping_.time; }
    Scene scene() const;
    /// As a head in good health has it: recorded, with a heading.
    LiveState state() const;
    Timeline timeline() { return timeline_.summary(); }

private:
    std::unique_ptr<SimulatedSource> source_;
    ScanningSonarPipeline pipeline_;
    SceneBuilder builder_;
    RunTimeline timeline_;
    bool follows_ = false;
    Update latest_;
    Ping ping_;
    std::uint64_t pings_ = 0;
    std::uint64_t sweeps_ = 0;
};

/// What the window holds of it: scenes and states as the script lays them out.
class ScriptedSource : public LiveSource {
public:
    struct Script {
        std::optional<Scene> scene;
        std::optional<Timeline> timeline;
        LiveState state;
    };
    explicit ScriptedSource(Script& script) : script_(script) {}
    void start() override {}
    std::optional<Scene> takeScene() override { return std::exchange(script_.scene, std::nullopt); }
    std::optional<Timeline> takeTimeline() override { return std::exchange(script_.timeline, std::nullopt); }
    LiveState state() const override { return script_.state; }
    void setParams(const LiveRunner::Params&) override {}
    void designate(double, Bearing) override {}
    void clearDesignation() override {}
    void drop(int, double, Bearing) override {}
    void restore(int) override {}
    void setEnhanced(bool) override {}

private:
    Script& script_;
};

}  // namespace echotrail::test
