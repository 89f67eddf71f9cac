#include "app/io/tracker_link.hpp"

#include <utility>

// The part of a TrackerLink that keeps recordings: what its keepers want to know is asked for, and what comes goes to
// them, on a thread of their own.
namespace echotrail {
namespace {

constexpr std::size_t most_to_fetch = 100;

}  // namespace

std::unique_ptr<RecordKeeper> TrackerLink::makeKeeper(const std::string& folder, const std::string& name) {
    auto made = std::make_unique<RecordKeeper>(folder, name);
    RecordKeeper* keeper = made.get();
    keeper->moveToThread(&records_thread_);
    // Queued, as it lives elsewhere; one that has ended meanwhile asks no more.
    const auto lives = [this, keeper] { return keeper == keeper_.get() || keeper == fetch_.get(); };
    connect(keeper, &RecordKeeper::wantsDescription, this, [=, this](const std::string& wanted) {
        if (lives()) ask(*keeper, client_.describeRecording(wanted));
    });
    connect(keeper, &RecordKeeper::wantsRows, this, [=, this](const LinkReadRows& wanted) {
        if (lives()) ask(*keeper, client_.readRows(wanted));
    });
    connect(keeper, &RecordKeeper::leftBehind, this, [this, folder](const std::string& left) { fetch(left, folder); });
    connect(keeper, &RecordKeeper::finished, this, [=, this] {
        if (!lives()) return;
        publish();
        if (keeper != fetch_.get()) return;
        endKeeper(fetch_);
        fetchNext();
    });
    return made;
}

void TrackerLink::ask(RecordKeeper& keeper, std::uint32_t request) {
    if (request != 0) asked_[request] = {&keeper, now()};
    converse();
}

void TrackerLink::endKeeper(std::unique_ptr<RecordKeeper>& keeper) {
    if (!keeper) return;
    std::erase_if(asked_, [&](const auto& asked) { return asked.second.keeper == keeper.get(); });
    const auto end = [&] {
        keeper->close();
        publish();  // how far it has come
        keeper.reset();
    };
    if (records_thread_.isRunning())
        QMetaObject::invokeMethod(keeper.get(), end, Qt::BlockingQueuedConnection);
    else
        end();
}

void TrackerLink::takeJoin() {
    for (RecordKeeper* keeper : {keeper_.get(), fetch_.get()})
        if (keeper) tellJoined(*keeper);
}

void TrackerLink::tellJoined(RecordKeeper& keeper) {
    if (!client_.status().mayReadRecordings()) return;
    QMetaObject::invokeMethod(&keeper,
                              [&keeper, tracker = client_.status().welcome.tracker.name] { keeper.linkUp(tracker); });
}

/// Before the keepers hear that what they have asked for does not come: that is no refusal.
void TrackerLink::takeLoss() {
    for (RecordKeeper* keeper : {keeper_.get(), fetch_.get()})
        if (keeper) QMetaObject::invokeMethod(keeper, [keeper] { keeper->linkDown(); });
}

/// Whether it was one about recordings.
bool TrackerLink::takeRecordEvent(const LinkEvent& event) {
    const auto keeperOf = [this](std::uint32_t request) {
        const auto asked = asked_.find(request);
        const Asked found = asked == asked_.end() ? Asked{} : asked->second;
        asked_.erase(request);
        return found;
    };
    if (const auto* recordings = std::get_if<LinkRecordings>(&event)) {
        list_request_ = 0;
        const std::scoped_lock lock(mutex_);
        published_.recordings = recordings->entries;
        published_.recordings_error.clear();
        return true;
    }
    if (const auto* recording = std::get_if<LinkRecording>(&event)) {
        if (RecordKeeper* keeper = keeperOf(recording->request).keeper)
            QMetaObject::invokeMethod(keeper, [keeper, what = *recording] { keeper->takeRecording(what); });
        return true;
    }
    if (const auto* rows = std::get_if<LinkRows>(&event)) {
        const Asked asked = keeperOf(rows->request);
        if (asked.keeper && asked.keeper == keeper_.get()) timeline_.recall(rows->rows);
        const Microseconds beyond = now() - asked.since - client_.quickestRoundTrip().value_or(Microseconds{0});
        if (RecordKeeper* keeper = asked.keeper)
            QMetaObject::invokeMethod(keeper, [keeper, beyond, what = *rows] { keeper->takeRows(what, beyond); });
        return true;
    }
    const auto* reply = std::get_if<LinkReply>(&event);
    if (!reply || reply->done) return false;
    if (RecordKeeper* keeper = keeperOf(reply->request).keeper) {
        QMetaObject::invokeMethod(keeper, [keeper, why = reply->reason] { keeper->takeRefusal(why); });
        return true;
    }
    if (reply->request != list_request_) return false;
    list_request_ = 0;
    const std::scoped_lock lock(mutex_);
    published_.recordings_error = reply->reason;
    return true;
}

void TrackerLink::listRecordings() {
    if (list_request_ == 0) list_request_ = client_.listRecordings();
    converse();
}

void TrackerLink::fetch(const std::string& name, const std::string& folder) {
    if (to_fetch_.size() >= most_to_fetch) return notice(true, "Not fetched: too many recordings wait.");
    to_fetch_.push_back({name, folder});
    if (!fetch_) fetchNext();
}

void TrackerLink::fetchNext() {
    if (to_fetch_.empty() || !records_thread_.isRunning()) return;
    const Wanted wanted = std::move(to_fetch_.front());
    to_fetch_.pop_front();
    fetch_ = makeKeeper(wanted.folder, wanted.name);
    tellJoined(*fetch_);
}

void TrackerLink::cancelFetch() {
    to_fetch_.clear();
    endKeeper(fetch_);
}

}  // namespace echotrail
