#pragma once

#include "core/runtime/scene.hpp"
#include "ui/chart/area_model.hpp"

#include <QObject>
#include <set>
#include <utility>

namespace echotrail {

/// Tells when a confirmed track comes into a guard zone, once per visit. A track that coasts or is tentative does not
/// come in, but one that was seen inside stays in until it is seen outside, is lost, or its zone goes. In a veto area
/// no zone sees anything. Order: scenes in time order; after a jump back all visits begin anew.
class GuardWatch : public QObject {
    Q_OBJECT

public:
    explicit GuardWatch(const AreaModel& areas, QObject* parent = nullptr) : QObject(parent), areas_(areas) {}

    void setScene(const Scene& scene);
    void clear() { inside_.clear(); }
    bool isInside(int track, const QString& zone) const { return inside_.contains({track, zone}); }

Q_SIGNALS:
    void guardZoneEntered(int trackId, const QString& zoneName);
    void guardZoneLeft(int trackId, const QString& zoneName);

private:
    using Visits = std::set<std::pair<int, QString>>;

    const AreaModel& areas_;
    Visits inside_;
    std::uint64_t position_ = 0;
};

}  // namespace echotrail
