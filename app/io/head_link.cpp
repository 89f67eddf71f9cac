#include "app/io/head_link.hpp"

#include "core/runtime/prompt_thread.hpp"

#include <algorithm>

namespace echotrail {
namespace {

std::vector<std::uint8_t> bytesOf(const QByteArray& bytes) { return {bytes.begin(), bytes.end()}; }
std::vector<std::uint8_t> textBytes(std::string_view text) { return {text.begin(), text.end()}; }

std::uint32_t timeOfDayMs() {
    using namespace std::chrono;
    const auto now = system_clock::now();
    return static_cast<std::uint32_t>(duration_cast<milliseconds>(now - floor<days>(now)).count());
}

void goDown(LinkState& link, const QString& reason) {
    link.up = false;
    link.reason = reason.toStdString();
}

void goUp(LinkState& link) {
    link.up = true;
    link.reason.clear();
}

}  // namespace

std::string headStateText(seanet::HeadState state) {
    using seanet::HeadState;
    switch (state) {
        case HeadState::NoLink:
            return "no link";
        case HeadState::Waiting:
            return "waiting for the head";
        case HeadState::Identifying:
            return "asking what it is";
        case HeadState::Centring:
            return "centring";
        case HeadState::Configuring:
            return "sending parameters";
        case HeadState::Polling:
            return "scanning";
        case HeadState::Silent:
            return "head silent";
        case HeadState::WrongDevice:
            return "wrong device";
    }
    return {};
}

HeadLink::HeadLink(const LiveAddresses& addresses, const HeadSettings& settings, LiveRunner& runner)
    : addresses_(addresses), runner_(runner), settings_(settings), session_(settings) {
    if (addresses_.hasNavigation()) {
        current_.navigation.emplace();
        // Said first of all, so that pings wait for poses from the first one on.
        runner_.post(EventKind::NavigationLink, textBytes("down"));
    }
    deadline_.setSingleShot(true);
    deadline_.setTimerType(Qt::PreciseTimer);
    connect(&deadline_, &QTimer::timeout, this, [this] {
        session_.tick(now());
        converse();
    });
    publish();
}

HeadLink::~HeadLink() = default;

void HeadLink::open() {
    close();
    becomePrompt();  // what comes has its time stamped, and the head waits for its next command
    // Made here, so that their sockets belong to the thread that works with them.
    LiveChannels made = makeChannels(addresses_);
    sonar_ = std::move(made.sonar);
    navigation_ = std::move(made.navigation);
    connectSonar();
    if (navigation_) {
        connectNavigation();
        navigation_->open();
    }
    sonar_->open();
}

void HeadLink::close() {
    deadline_.stop();
    for (auto* channel : {&sonar_, &navigation_}) {
        if (!*channel) continue;
        (*channel)->disconnect(this);
        (*channel)->close();
        channel->reset();
    }
    // Not posted as a broken link: a frame that our own end cuts is no loss, and a new beginning posts that it is up.
    session_.linkDown(now());
    while (session_.takeOutput()) {
    }  // there is no one left to say it to
    current_.sonar.up = false;
    if (current_.navigation) current_.navigation->up = false;
    publish();
}

void HeadLink::setSettings(const HeadSettings& settings) {
    settings_ = settings;
    follows_ = false;
    aim();
    converse();
}

/// Tells the session what the head is to scan. What the runner wants was chosen at the last ping: where the operator
/// has set another sector since, it is heeded only within that one.
void HeadLink::aim() {
    const auto wanted = runner_.sector();
    const bool follows = wanted && contains(scanSector(settings_), *wanted);
    follows_ |= follows;
    session_.setSettings(now(), follows ? withSector(settings_, *wanted) : settings_);
}

void HeadLink::connectSonar() {
    connect(sonar_.get(), &ByteChannel::wentUp, this, [this] {
        goUp(current_.sonar);
        runner_.post(EventKind::SonarLink, textBytes("up"));
        session_.linkUp(now(), timeOfDayMs());
        Q_EMIT noted("sonar " + QString::fromStdString(addresses_.sonarText()) + ": connected");
        converse();
    });
    connect(sonar_.get(), &ByteChannel::wentDown, this, [this](const QString& reason) {
        goDown(current_.sonar, reason);
        runner_.post(EventKind::SonarLink, textBytes("down"));
        session_.linkDown(now());
        Q_EMIT noted("sonar: " + reason);
        converse();
    });
    connect(sonar_.get(), &ByteChannel::received, this, [this](const QByteArray& bytes) {
        const auto payload = bytesOf(bytes);
        runner_.post(EventKind::SonarBytes, payload);
        current_.sonar.last_bytes = std::chrono::steady_clock::now();
        aim();
        session_.received(now(), payload);
        converse();
    });
}

void HeadLink::connectNavigation() {
    connect(navigation_.get(), &ByteChannel::wentUp, this, [this] {
        goUp(*current_.navigation);
        runner_.post(EventKind::NavigationLink, textBytes("up"));
        Q_EMIT noted("navigation " + QString::fromStdString(addresses_.navigationText()) + ": connected");
        publish();
    });
    connect(navigation_.get(), &ByteChannel::wentDown, this, [this](const QString& reason) {
        goDown(*current_.navigation, reason);
        runner_.post(EventKind::NavigationLink, textBytes("down"));
        Q_EMIT noted("navigation: " + reason);
        publish();
    });
    connect(navigation_.get(), &ByteChannel::received, this, [this](const QByteArray& bytes) {
        runner_.post(EventKind::NavigationBytes, bytesOf(bytes));
        current_.navigation->last_bytes = std::chrono::steady_clock::now();
        if (current_.sonar.up) {  // a ping that waited for these poses may have told where to look next
            aim();
            converse();
        }
        publish();
    });
}

/// Sends what the session wants to say, and comes back when it wants to be called.
void HeadLink::converse() {
    while (const auto frame = session_.takeOutput()) {
        if (!sonar_) continue;
        runner_.post(EventKind::SentBytes, *frame);
        sonar_->send(QByteArray(reinterpret_cast<const char*>(frame->data()), static_cast<int>(frame->size())));
    }
    if (const auto at = session_.deadline())
        deadline_.start(
            std::max(std::chrono::ceil<std::chrono::milliseconds>(*at - now()), std::chrono::milliseconds(0)));
    else
        deadline_.stop();
    noteHead(session_.status());
    publish();
}

void HeadLink::noteHead(const seanet::HeadStatus& status) {
    const auto told = [this](const std::string& text) { Q_EMIT noted("head: " + QString::fromStdString(text)); };
    if (current_.head.state != status.state)
        told(headStateText(status.state) + (status.head.empty() ? "" : " (" + status.head + ")"));
    // Where it follows the target it is told something new every second or so: that it lags behind is no news.
    if (!follows_ && current_.head.difference != status.difference && !status.difference.empty())
        told("not as commanded: " + status.difference);
    if (current_.head.advice != status.advice && !status.advice.empty()) told(status.advice);
}

void HeadLink::publish() {
    current_.head = session_.status();
    if (sonar_) current_.sonar.counts = sonar_->counts();
    if (navigation_) current_.navigation->counts = navigation_->counts();
    const std::scoped_lock lock(mutex_);
    published_ = current_;
}

HeadLinkState HeadLink::state() const {
    const std::scoped_lock lock(mutex_);
    return published_;
}

Microseconds HeadLink::now() const {
    return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - started_);
}

}  // namespace echotrail
