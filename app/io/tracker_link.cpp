#include "app/io/tracker_link.hpp"

#include "core/runtime/link_moment.hpp"

#include <QUdpSocket>
#include <utility>

namespace echotrail {
namespace {

constexpr int tick_ms = 100;
constexpr int reopen_ms = 1'000;  // a tracker that has refused is not asked again at once
constexpr std::size_t most_notices = 50;

}  // namespace

TrackerLink::TrackerLink(const LinkAddress& address, const LinkIdentity& identity, const std::string& folder,
                         bool wants_control)
    : address_(address),
      client_(LinkClient::Options{.identity = identity, .wants_control = wants_control, .datagrams = true}),
      folder_(folder) {
    records_thread_.setObjectName("records");
}

TrackerLink::~TrackerLink() { close(); }

Microseconds TrackerLink::now() const {
    return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - started_);
}

void TrackerLink::open() {
    if (std::exchange(wanted_, true)) return;
    records_thread_.start();
    if (!folder_.empty()) keeper_ = makeKeeper(folder_, {});
    channel_ = makeChannel(address_);  // here, so that its socket belongs to the thread that works with it
    connectChannel();
    tick_ = new QTimer(this);
    connect(tick_, &QTimer::timeout, this, [this] {
        client_.tick(now());
        converse();
    });
    tick_->start(tick_ms);
    reopen_ = new QTimer(this);
    reopen_->setSingleShot(true);
    connect(reopen_, &QTimer::timeout, this, [this] {
        connectChannel();
        channel_->open();
    });
    channel_->open();
}

void TrackerLink::close() {
    wanted_ = false;
    delete std::exchange(tick_, nullptr);
    delete std::exchange(reopen_, nullptr);
    channel_.reset();
    client_.linkDown();
    closeDatagrams();
    endKeeper(keeper_);
    endKeeper(fetch_);
    records_thread_.quit();
    records_thread_.wait();
}

void TrackerLink::connectChannel() {
    connect(channel_.get(), &ByteChannel::wentUp, this, [this] {
        client_.linkUp(now());
        converse();
    });
    connect(channel_.get(), &ByteChannel::received, this, &TrackerLink::take);
    connect(channel_.get(), &ByteChannel::wentDown, this, &TrackerLink::lost);
}

void TrackerLink::lost(const QString& reason) {
    reason_ = client_.status().refusal.empty() ? reason.toStdString() : "the tracker says: " + client_.status().refusal;
    client_.linkDown();
    closeDatagrams();
    takeLoss();
    takeEvents();
    publish();
}

void TrackerLink::take(const QByteArray& bytes) {
    client_.received(now(),
                     {reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<std::size_t>(bytes.size())});
    converse();
}

/// Takes in what came, and sends what is to be said.
void TrackerLink::converse() {
    if (!channel_) return;
    takeEvents();
    sendParams();
    reportDatagrams();
    const std::string out = client_.takeOutput();
    const bool sent = out.empty() || channel_->send(QByteArray(out.data(), static_cast<int>(out.size())));
    if (client_.wantsToClose() || (!sent && channel_->isUp())) {
        const QString reason = client_.status().refusal.empty()
                                   ? sent ? tr("the tracker says nothing, or what cannot be understood")
                                          : tr("the tracker takes nothing any more")
                                   : QString();
        channel_->disconnect(this);
        channel_->close();
        lost(reason);
        reopen_->start(reopen_ms);
    }
    if (remote_.changed() && scenes_.empty()) scenes_.put(remote_.build(enhanced_));
    if (timeline_.changed() && timelines_.empty()) timelines_.put(timeline_.summary());
    publish();
}

void TrackerLink::takeEvents() {
    while (const auto event = client_.next()) {
        if (takeRecordEvent(*event)) continue;
        remote_.take(*event);
        if (std::holds_alternative<LinkBeam>(*event))
            timeline_.see(*remote_.lastPing(), remote_.sweep(), remote_.follows());
        if (std::holds_alternative<LinkWelcome>(*event)) {
            takeJoin();
            openDatagrams();
        }
        if (std::holds_alternative<LinkWelcome>(*event)) reason_.clear();
        if (std::holds_alternative<LinkSnapshot>(*event))
            for (const std::string& why : remote_.passedOver())
                notice(true, "A parameter of the tracker is not shown: " + why + ".");
        if (const auto* reply = std::get_if<LinkReply>(&*event)) takeReply(*reply);
        if (const auto* control = std::get_if<LinkControl>(&*event)) takeControl(*control);
        if (const auto* line = std::get_if<LinkLog>(&*event); line && line->weight != LinkLog::Weight::Note)
            notice(true, "The tracker says: " + line->text);
        const bool tells_parameters =
            std::holds_alternative<LinkSnapshot>(*event) || std::holds_alternative<LinkParameters>(*event);
        if (!tells_parameters || wanted_params_) continue;
        const std::scoped_lock lock(mutex_);
        echo_ = remote_.params();
    }
}

void TrackerLink::takeReply(const LinkReply& reply) {
    const bool of_parameters = reply.request == params_request_;
    if (of_parameters) params_request_ = 0;
    if (reply.done) {
        if (!of_parameters || wanted_params_) return;
        const std::scoped_lock lock(mutex_);
        echo_ = remote_.params();
        return;
    }
    notice(true, (of_parameters ? "The parameters were not changed: " : "Not done: ") + reply.reason + ".");
    if (!of_parameters) return;
    wanted_params_.reset();
    const std::scoped_lock lock(mutex_);
    echo_ = remote_.params();  // what is shown is what is in force
}

void TrackerLink::takeControl(const LinkControl& control) {
    const LinkControl before = control_.value_or(LinkControl{});
    control_ = control;
    const std::uint32_t self = client_.status().welcome.console;
    if (control.holder == self && control.asking != 0 && control.asking != before.asking)
        notice(true, control.asking_name +
                         " asks for control: give it or keep it in the menu Sonar. After 15 s without an "
                         "answer it can be taken.");
    if (control.holder == before.holder) return;
    if (control.holder == self) notice(false, "This console holds control.");
    if (before.holder == self && control.holder != 0) notice(true, control.holder_name + " holds control now.");
}

void TrackerLink::setParams(const RemoteScene::Params& params) {
    wanted_params_ = params;
    converse();
}

void TrackerLink::sendParams() {
    if (!wanted_params_ || params_request_ != 0) return;
    const auto wanted = namedValues(*wanted_params_), in_force = namedValues(remote_.params());
    std::vector<NamedValue> changed;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i] != in_force[i]) changed.push_back(wanted[i]);
    wanted_params_.reset();
    if (changed.empty()) return;
    params_request_ = client_.setParameters(changed);
    if (params_request_ != 0) return;
    notice(true, "The parameters were not changed: there is no link to the tracker.");
    const std::scoped_lock lock(mutex_);
    echo_ = remote_.params();
}

void TrackerLink::refused(std::uint32_t request, const std::string& what) {
    if (request == 0) notice(true, what + ": there is no link to the tracker.");
    converse();
}

void TrackerLink::designate(double range_m, Bearing from_bow) {
    refused(client_.designate(range_m, from_bow), "Not designated");
}
void TrackerLink::clearDesignation() { refused(client_.clearDesignation(), "The designation stays"); }
void TrackerLink::drop(int track, double range_m, Bearing from_bow) {
    refused(client_.drop(track, range_m, from_bow), "Not dropped");
}
void TrackerLink::restore(int track) { refused(client_.restore(track), "Not taken back"); }
void TrackerLink::control(ControlAction action) { refused(client_.control(action), "Not asked"); }

void TrackerLink::notice(bool problem, const std::string& text) {
    const std::scoped_lock lock(mutex_);
    if (notices_.size() >= most_notices) notices_.pop_front();
    notices_.push_back({problem, text});
}

void TrackerLink::publish() {
    const std::scoped_lock lock(mutex_);
    published_.up = client_.status().state == LinkClientStatus::State::Joined;
    published_.reason = published_.up ? std::string() : reason_;
    published_.client = client_.status();
    published_.health = remote_.health();
    published_.params = remote_.params();
    published_.last_ping = remote_.lastPing();
    if (keeper_) published_.record = keeper_->state();
    if (fetch_) published_.fetched = fetch_->state();
    tracker_offset_.reset();
    if (const auto theirs = client_.trackerTime(now())) tracker_offset_ = theirs->time_since_epoch() - now();
}

TrackerLinkState TrackerLink::state() const {
    const std::scoped_lock lock(mutex_);
    TrackerLinkState state = published_;
    const Microseconds at = now();
    if (tracker_offset_) state.tracker_time = Timestamp(at + *tracker_offset_);
    if (const auto heard = state.client.last_heard) state.age_s = std::chrono::duration<double>(at - *heard).count();
    return state;
}

std::optional<RemoteScene::Params> TrackerLink::takeParams() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(echo_, std::nullopt);
}

std::optional<TrackerNotice> TrackerLink::takeNotice() {
    const std::scoped_lock lock(mutex_);
    if (notices_.empty()) return std::nullopt;
    TrackerNotice notice = std::move(notices_.front());
    notices_.pop_front();
    return notice;
}

}  // namespace echotrail
