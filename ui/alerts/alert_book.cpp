#include "ui/alerts/alert_book.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace echotrail {
namespace {

constexpr double recent_s = 600.0;

const Situation* find(const std::vector<Situation>& situations, const QString& key) {
    const auto found =
        std::find_if(situations.begin(), situations.end(), [&](const Situation& each) { return each.key == key; });
    return found == situations.end() ? nullptr : &*found;
}

/// Where an alert stands in the list; the lower, the higher up.
auto place(const Alert& alert) {
    const int group = alert.isNew() ? 0 : alert.isOpen() ? 1 : 2;
    const int urgency = group == 2 ? 0 : static_cast<int>(alert.priority);
    return std::tuple(group, urgency, -alert.raised.time_since_epoch().count(), -alert.id);
}

}  // namespace

Alert* AlertBook::openOf(const QString& key) {
    const auto found = std::find_if(alerts_.begin(), alerts_.end(),
                                    [&](const Alert& alert) { return alert.isOpen() && alert.situation.key == key; });
    return found == alerts_.end() ? nullptr : &*found;
}

bool AlertBook::hasLasted(std::vector<Waiting>& waiting, const Situation& situation, Timestamp now) {
    if (situation.delay_s <= 0.0) return true;
    auto found =
        std::find_if(waiting.begin(), waiting.end(), [&](const Waiting& each) { return each.key == situation.key; });
    if (found == waiting.end()) found = waiting.insert(waiting.end(), {situation.key, now});
    return secondsBetween(found->since, now) >= situation.delay_s;
}

void AlertBook::update(const std::vector<Situation>& situations, Timestamp now) {
    std::erase_if(coming_, [&](const Waiting& each) { return !find(situations, each.key); });
    std::erase_if(going_, [&](const Waiting& each) { return find(situations, each.key) != nullptr; });
    for (const Situation& situation : situations) {
        Alert* alert = openOf(situation.key);
        if (!alert) {
            if (hasLasted(coming_, situation, now)) raise(situation, false, now);
            continue;
        }
        alert->situation = situation;
        alert->ended.reset();
        if (situation.priority >= alert->priority) continue;
        alert->priority = situation.priority;
        alert->acknowledged.reset();  // what was acknowledged was less than this
        note(AlertChange::What::Escalated, *alert, now);
    }
    endWhatIsOver(situations, now);
    escalate(now);
    arrange();
}

void AlertBook::raise(const Situation& situation, bool passing, Timestamp now) {
    std::erase_if(coming_, [&](const Waiting& each) { return each.key == situation.key; });
    alerts_.push_back({next_id_++, situation, situation.priority, now, {}, {}, passing});
    note(AlertChange::What::Raised, alerts_.back(), now);
}

void AlertBook::happened(const Situation& situation, Timestamp now) {
    if (Alert* alert = openOf(situation.key))
        alert->situation = situation;
    else
        raise(situation, true, now);
    arrange();
}

void AlertBook::endWhatIsOver(const std::vector<Situation>& situations, Timestamp now) {
    for (Alert& alert : alerts_) {
        if (alert.passing || alert.ended || find(situations, alert.situation.key)) continue;
        if (!hasLasted(going_, alert.situation, now)) continue;
        alert.ended = now;
        std::erase_if(going_, [&](const Waiting& each) { return each.key == alert.situation.key; });
        note(AlertChange::What::Ended, alert, now);
    }
}

void AlertBook::escalate(Timestamp now) {
    for (Alert& alert : alerts_) {
        if (alert.priority != AlertPriority::Warning || !alert.isNew() || alert.ended) continue;
        if (secondsBetween(alert.raised, now) < escalation_s) continue;
        alert.priority = AlertPriority::Alarm;
        note(AlertChange::What::Escalated, alert, now);
    }
}

void AlertBook::acknowledge(int id, Timestamp now) {
    const auto found =
        std::find_if(alerts_.begin(), alerts_.end(), [id](const Alert& alert) { return alert.id == id; });
    if (found == alerts_.end() || !found->isNew()) return;
    found->acknowledged = now;
    note(AlertChange::What::Acknowledged, *found, now);
    if (found->passing) {
        found->ended = now;
        note(AlertChange::What::Ended, *found, now);
    }
    arrange();
}

void AlertBook::reword() {
    for (Alert& alert : alerts_) {
        Situation& situation = alert.situation;
        if (!situation.words) continue;
        const AlertWords words = situation.words();
        situation.title = words.title;
        situation.cause = words.cause;
    }
}

void AlertBook::clear() {
    alerts_.clear();
    coming_.clear();
    going_.clear();
}

void AlertBook::note(AlertChange::What what, const Alert& alert, Timestamp now) {
    changes_.push_back({what, alert, now});
}

std::vector<AlertChange> AlertBook::takeChanges() { return std::exchange(changes_, {}); }

void AlertBook::arrange() {
    std::stable_sort(alerts_.begin(), alerts_.end(),
                     [](const Alert& a, const Alert& b) { return place(a) < place(b); });
    while (alerts_.size() > most_alerts && !alerts_.back().isOpen()) alerts_.pop_back();
}

const Alert* AlertBook::mostUrgent() const {
    return alerts_.empty() || !alerts_.front().isNew() ? nullptr : &alerts_.front();
}

int AlertBook::recent(Timestamp now) const {
    return static_cast<int>(std::count_if(alerts_.begin(), alerts_.end(), [now](const Alert& alert) {
        return secondsBetween(alert.raised, now) <= recent_s;
    }));
}

}  // namespace echotrail
