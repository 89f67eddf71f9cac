#include "core/runtime/replay_runner.hpp"

#include "core/runtime/denormals.hpp"
#include "core/runtime/replay_player.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <exception>
#include <utility>

namespace echotrail {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int pings_per_slice = 16;  ///< between looks at the commands when nothing waits for a clock
constexpr auto unseen_scene_retry = std::chrono::milliseconds(10);
constexpr auto most_lag = std::chrono::milliseconds(500);        ///< then the machine is too slow for the speed
constexpr auto first_analysis_budget = std::chrono::seconds(2);  ///< a long recording plays before it is analysed

}  // namespace

/// The thread's own state. Each turn of the loop obeys the commands and then does one small piece of work.
class ReplayRunner::Loop {
public:
    Loop(ReplayRunner& owner, std::unique_ptr<PingSource> source, const Params& params, std::uint64_t seed,
         bool as_recorded)
        : owner_(owner), player_(std::move(source), params, seed, as_recorded) {}

    void run(const std::stop_token& stop) {
        while (!stop.stop_requested() && !player_.scan()) report(ReplayState::Loading, player_.scanned());
        owner_.timelines_.put(player_.timeline());
        analysis_deadline_ = Clock::now() + first_analysis_budget;
        while (!stop.stop_requested() && !player_.analyse() && Clock::now() < analysis_deadline_)
            report(ReplayState::Loading, player_.size());
        owner_.timelines_.put(player_.timeline());
        publish(true);
        while (!stop.stop_requested()) turn(stop);
    }

    void play() {
        if (player_.atEnd()) goTo(0);
        playing_ = true;
        anchor_.reset();
    }
    void pause() {
        playing_ = false;
        changed_ = true;
    }
    void cancel() {
        travelling_ = until_sweep_ = false;
        goal_ = player_.position();
        changed_ = true;
    }
    void stepPings(std::int64_t count) {
        playing_ = false;
        const auto back = static_cast<std::uint64_t>(count < 0 ? -count : 0);
        goTo(count < 0 ? goal_ - std::min(goal_, back) : goal_ + static_cast<std::uint64_t>(count));
    }
    void stepSweep(int direction) {
        playing_ = false;
        const Timeline& timeline = player_.timeline();
        goTo(direction < 0 ? timeline.sweepBefore(goal_) : timeline.sweepAfter(goal_));
        until_sweep_ = direction > 0 && goal_ == player_.size() && timeline.analysed < player_.size();
    }
    void seek(std::uint64_t position) { goTo(position); }
    void seekTime(Timestamp time) { goTo(player_.timeline().positionAt(time)); }
    void setSpeed(double factor) {
        speed_ = factor;
        anchor_.reset();
    }
    void setParams(const Params& params, std::uint64_t revision) {
        player_.setParams(params, revision);
        revision_ = revision;
        if (playing_ && !travelling_)
            mixed_ = true;
        else
            restart();
        travelling_ = travelling_ || !playing_;
    }
    void designate(double range_m, Bearing from_bow) {
        player_.designate(range_m, from_bow);
        changed_ = true;
    }
    void clearDesignation() {
        player_.clearDesignation();
        changed_ = true;
    }
    void drop(int track, double range_m, Bearing from_bow) {
        player_.drop(track, range_m, from_bow);
        changed_ = true;
    }
    void restore(int track) {
        player_.restore(track);
        changed_ = true;
    }
    void setLoop(std::optional<PingSpan> loop) { loop_ = loop; }
    void setEnhanced(bool on) {
        player_.setEnhanced(on);
        changed_ = true;
    }

private:
    /// Where the clock and the recording met, for pacing.
    struct Anchor {
        Clock::time_point clock;
        Timestamp data;
    };

    bool arrived() const { return player_.position() == goal_ && (goal_ < player_.size() || player_.atEnd()); }

    void goTo(std::uint64_t position) {
        goal_ = std::min(position, player_.size());
        until_sweep_ = false;
        const bool back = goal_ < player_.position() || (player_.atEnd() && goal_ < player_.size());
        if (back || mixed_) restart();
        travelling_ = true;
        anchor_.reset();
    }

    void restart() {
        player_.restart();
        mixed_ = false;
    }

    void turn(const std::stop_token& stop) {
        obey();
        if (travelling_) {
            travel();
        } else if (playing_) {
            playOn(stop);
        } else if (!player_.analyse()) {
            analysing_ = true;
        } else {
            if (std::exchange(analysing_, false)) owner_.timelines_.put(player_.timeline());
            publish(std::exchange(changed_, false));
            report(player_.atEnd() ? ReplayState::Ended : ReplayState::Paused, player_.size());
            wait(stop, std::nullopt);
            return;
        }
        publish(std::exchange(changed_, false));
        report(playing_          ? ReplayState::Playing
               : player_.atEnd() ? ReplayState::Ended
                                 : ReplayState::Paused,
               player_.size());
    }

    void obey() {
        std::vector<Command> commands;
        {
            const std::scoped_lock lock(owner_.mutex_);
            commands.swap(owner_.commands_);
        }
        for (const Command& command : commands) command(*this);
    }

    /// One slice of the way to the goal. Pictures on the way are not shown: they would look like play.
    void travel() {
        for (int i = 0; i < pings_per_slice && !arrived(); ++i)
            if (player_.advance() && until_sweep_ && player_.sweepJustStarted()) goal_ = player_.position();
        if (!arrived()) return;
        travelling_ = until_sweep_ = false;
        unseen_ = true;
        changed_ = !playing_;
    }

    void playOn(const std::stop_token& stop) {
        const std::uint64_t end = loop_ ? std::min(loop_->end, player_.size()) : player_.size();
        for (int i = 0; i < pings_per_slice; ++i) {
            if (loop_ && player_.position() >= end) return goTo(loop_->begin);
            if (const auto due = whenDue(); due && *due > Clock::now()) return wait(stop, due);
            if (player_.advance()) unseen_ = true;
            goal_ = player_.position();
            if (player_.atEnd()) {
                if (loop_) return goTo(loop_->begin);
                playing_ = false;
                changed_ = true;
                return;
            }
        }
    }

    /// When the next ping is due; nothing at full speed and at the end: at once.
    std::optional<Clock::time_point> whenDue() {
        if (speed_ == max_speed || player_.position() >= player_.size()) return std::nullopt;
        const Timestamp next = player_.timeOf(player_.position());
        const auto now = Clock::now();
        if (!anchor_) anchor_ = Anchor{now, next};
        const auto ahead = std::chrono::duration<double>(secondsBetween(anchor_->data, next) / speed_);
        const auto due = anchor_->clock + std::chrono::duration_cast<Clock::duration>(ahead);
        if (now - due > most_lag) anchor_ = Anchor{now, next};  // give the lost time up rather than race after it
        return due;
    }

    /// Until there is a command, or `due`. A scene nobody has taken room for yet is tried again meanwhile.
    void wait(const std::stop_token& stop, std::optional<Clock::time_point> due) {
        if (unseen_) {
            const auto retry = Clock::now() + unseen_scene_retry;
            due = due ? std::min(*due, retry) : retry;
        }
        std::unique_lock lock(owner_.mutex_);
        const auto commanded = [this] { return !owner_.commands_.empty(); };
        if (due)
            owner_.wake_.wait_until(lock, stop, *due, commanded);
        else
            owner_.wake_.wait(lock, stop, commanded);
    }

    void publish(bool must) {
        if (!must && (!unseen_ || travelling_ || !owner_.scenes_.empty())) return;
        if (auto params = player_.takeRecordedParams()) owner_.recorded_params_.put(*std::move(params));
        owner_.scenes_.put(player_.scene());
        unseen_ = false;
    }

    void report(ReplayState state, std::uint64_t total) {
        ReplayStatus status;
        status.state = state;
        status.position = player_.position();
        status.goal = travelling_ ? goal_ : player_.position();
        status.total = total;
        status.speed = speed_;
        status.revision = revision_;
        status.designated = player_.designated();
        status.analysing = analysing_;
        const std::scoped_lock lock(owner_.mutex_);
        owner_.status_ = std::move(status);
    }

    ReplayRunner& owner_;
    ReplayPlayer player_;
    std::optional<PingSpan> loop_;
    std::optional<Anchor> anchor_;
    Clock::time_point analysis_deadline_;
    std::uint64_t goal_ = 0;
    std::uint64_t revision_ = 0;
    double speed_ = 1.0;
    bool playing_ = false;
    bool travelling_ = false;   ///< to the goal, as fast as the machine can
    bool until_sweep_ = false;  ///< the goal is the next sweep, wherever it begins
    bool mixed_ = false;        ///< the parameters changed during this run
    bool analysing_ = false;
    bool unseen_ = false;   ///< pings were taken in since the last published scene
    bool changed_ = false;  ///< a scene must be published even over one that nobody took
};

ReplayRunner::ReplayRunner(std::unique_ptr<PingSource> source, const Params& params, std::uint64_t seed,
                           bool as_recorded)
    : thread_([this, params, seed, as_recorded, source = std::move(source)](const std::stop_token& stop) mutable {
          flushDenormals();
          try {
              Loop(*this, std::move(source), params, seed, as_recorded).run(stop);
          } catch (const std::exception& failure) {
              const std::scoped_lock lock(mutex_);
              status_.state = ReplayState::Failed;
              status_.error = std::string("replay stopped: ") + failure.what();
          }
      }) {}

ReplayRunner::~ReplayRunner() = default;

void ReplayRunner::post(Command command) {
    {
        const std::scoped_lock lock(mutex_);
        commands_.push_back(std::move(command));
    }
    wake_.notify_one();
}

ReplayStatus ReplayRunner::status() const {
    const std::scoped_lock lock(mutex_);
    return status_;
}

void ReplayRunner::play() {
    post([](Loop& loop) { loop.play(); });
}
void ReplayRunner::pause() {
    post([](Loop& loop) { loop.pause(); });
}
void ReplayRunner::stepPings(std::int64_t count) {
    post([=](Loop& loop) { loop.stepPings(count); });
}
void ReplayRunner::stepSweep(int direction) {
    post([=](Loop& loop) { loop.stepSweep(direction); });
}
void ReplayRunner::seek(std::uint64_t position) {
    post([=](Loop& loop) { loop.seek(position); });
}
void ReplayRunner::seekTime(Timestamp time) {
    post([=](Loop& loop) { loop.seekTime(time); });
}
void ReplayRunner::cancel() {
    post([](Loop& loop) { loop.cancel(); });
}
void ReplayRunner::setSpeed(double factor) {
    assert(factor > 0.0);
    post([=](Loop& loop) { loop.setSpeed(factor); });
}
void ReplayRunner::setParams(const Params& params, std::uint64_t revision) {
    post([=](Loop& loop) { loop.setParams(params, revision); });
}
void ReplayRunner::designate(double range_m, Bearing from_bow) {
    post([=](Loop& loop) { loop.designate(range_m, from_bow); });
}
void ReplayRunner::clearDesignation() {
    post([](Loop& loop) { loop.clearDesignation(); });
}
void ReplayRunner::drop(int track, double range_m, Bearing from_bow) {
    post([=](Loop& loop) { loop.drop(track, range_m, from_bow); });
}
void ReplayRunner::restore(int track) {
    post([=](Loop& loop) { loop.restore(track); });
}
void ReplayRunner::setEnhanced(bool on) {
    post([=](Loop& loop) { loop.setEnhanced(on); });
}
void ReplayRunner::setLoop(std::optional<PingSpan> loop) {
    post([=](Loop& runner) { runner.setLoop(loop); });
}

}  // namespace echotrail
