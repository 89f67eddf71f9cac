#include "app/io/tracker_service.hpp"

#include "app/io/link_health.hpp"
#include "core/runtime/link_moment.hpp"

#include <QSysInfo>
#include <QTimer>

namespace echotrail {
namespace {

constexpr std::size_t longest_mailbox = 400;  // some 20 s of pings
constexpr int health_ms = 1'000;

std::vector<std::uint8_t> bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace

TrackerService::TrackerService(const LiveRunner::Params& params, LiveRunner& runner, HeadLink& head,
                               const std::string& program, RecordingShelf shelf)
    : runner_(runner), head_(head), params_(params), shelf_(std::move(shelf)) {
    thread_.setObjectName("consoles");
    server_ = std::make_unique<ConsoleServer>(
        LinkIdentity{QSysInfo::machineHostName().toStdString(), program}, namedValues(params),
        [this] { return runner_.now(); }, [this](const LinkRequest& request) { return answer(request); });
    server_->serveRecordings([this](const LinkRecordRequest& request) { return shelf_.answer(request); });
    server_->moveToThread(&thread_);
    connect(server_.get(), &ConsoleServer::noted, this, &TrackerService::noted);
}

TrackerService::~TrackerService() { stop(); }

Result<LinkAddress> TrackerService::start(const LinkAddress& address, bool datagrams) {
    thread_.start();
    Result<LinkAddress> real = Error{"the consoles' thread does not run"};
    QMetaObject::invokeMethod(
        server_.get(),
        [&] {
            if (datagrams) server_->serveDatagrams();
            real = server_->listen(address);
            if (!real) return;
            health_ = std::make_unique<QTimer>();
            connect(health_.get(), &QTimer::timeout, server_.get(), [this] {
                server_->publish(linkHealth(head_.state(), runner_.status(), runner_.now()));
                server_->flush();
            });
            health_->start(health_ms);
            server_->publish(linkHealth(head_.state(), runner_.status(), runner_.now()));
        },
        Qt::BlockingQueuedConnection);
    const std::scoped_lock lock(mutex_);
    stopped_ = !real;
    return real;
}

void TrackerService::stop() {
    {
        const std::scoped_lock lock(mutex_);
        stopped_ = true;
        mailbox_.clear();
    }
    if (!thread_.isRunning()) return;
    QMetaObject::invokeMethod(
        server_.get(),
        [this] {
            counts_ = {server_->counts(), server_->turnedAway(), server_->datagramsRefused(), missed_};
            health_.reset();
            server_.reset();
        },
        Qt::BlockingQueuedConnection);
    thread_.quit();
    thread_.wait();
}

void TrackerService::take(const Ping& ping, const Update& update, const ScanningSonarPipeline& pipeline) {
    {
        const std::scoped_lock lock(mutex_);
        if (stopped_) return;
    }
    if (!first_ping_ && !ping.motor_lost_sync) first_ping_ = ping.time;
    LinkMoment moment = linkMoment(ping, update, pipeline, first_ping_.value_or(ping.time), runner_.navigationKnown());
    if (last_ping_ == ping.time) moment.beam.reset();  // the run's end closes what was open; there was no ping
    last_ping_ = ping.time;
    const std::scoped_lock lock(mutex_);
    if (stopped_) return;
    if (mailbox_.size() >= longest_mailbox) {
        mailbox_.pop_front();
        ++missed_;
        gap_ = true;
    }
    mailbox_.push_back(std::move(moment));
    if (mailbox_.size() == 1)
        QMetaObject::invokeMethod(
            server_.get(), [this] { drain(); }, Qt::QueuedConnection);
}

void TrackerService::drain() {
    std::deque<LinkMoment> moments;
    bool gap = false;
    {
        const std::scoped_lock lock(mutex_);
        moments.swap(mailbox_);
        gap = std::exchange(gap_, false);
    }
    for (LinkMoment& moment : moments) {
        if (gap && moment.beam) moment.beam->update.broke_off = true;
        gap = gap && !moment.beam;
        server_->publish(std::move(moment));
    }
    server_->flush();
}

void TrackerService::say(LinkLog::Weight weight, const std::string& text) {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return;
    const LinkLog line{runner_.now(), weight, text};
    QMetaObject::invokeMethod(
        server_.get(),
        [this, line] {
            server_->publish(line);
            server_->flush();
        },
        Qt::QueuedConnection);
}

TrackerService::Answer TrackerService::answer(const LinkRequest& request) {
    if (const auto* wanted = std::get_if<LinkSetParameters>(&request.content)) return setParameters(*wanted);
    if (const auto* pick = std::get_if<LinkDesignate>(&request.content))
        runner_.designate(pick->range_m, pick->from_bow);
    if (std::holds_alternative<LinkClearDesignation>(request.content)) runner_.clearDesignation();
    if (const auto* drop = std::get_if<LinkDrop>(&request.content))
        runner_.drop(drop->track, drop->range_m, drop->from_bow);
    if (const auto* back = std::get_if<LinkRestore>(&request.content)) runner_.restore(back->track);
    if (const auto* remark = std::get_if<LinkAnnotate>(&request.content)) {
        runner_.post(EventKind::Annotation, bytesOf(request.name + ": " + remark->text));
        server_->publish(LinkLog{runner_.now(), LinkLog::Weight::Note, request.name + ": " + remark->text});
    }
    return Answer(std::nullopt);
}

TrackerService::Answer TrackerService::setParameters(const LinkSetParameters& wanted) {
    if (auto set = setNamedValues(params_, wanted.values); !set) return Error{set.error()};
    runner_.setParams(params_);
    QMetaObject::invokeMethod(&head_, [this, settings = params_.head] { head_.setSettings(settings); });
    return Answer(namedValues(params_));
}

}  // namespace echotrail
