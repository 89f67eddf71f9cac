#include "ui/chart/chart_store.hpp"

#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <cmath>
#include <optional>

namespace echotrail {
namespace {

constexpr auto moving_key = "chart/with_vehicle";
constexpr auto sources_key = "chart/sources";
constexpr double farthest_m = 1e6;

QJsonArray pairOf(double x, double y) { return {x, y}; }

std::optional<Eigen::Vector2d> readPair(const QJsonValue& value) {
    const QJsonArray pair = value.toArray();
    const Eigen::Vector2d point(pair.at(0).toDouble(NAN), pair.at(1).toDouble(NAN));
    if (pair.size() != 2 || !point.allFinite() || point.cwiseAbs().maxCoeff() > farthest_m) return std::nullopt;
    return point;
}

QJsonObject write(const Area& area) {
    QJsonArray corners;
    for (const Eigen::Vector2f& corner : area.corners_m)
        corners.append(pairOf(static_cast<double>(corner.x()), static_cast<double>(corner.y())));
    return {{"kind", area.kind == Area::Kind::Guard ? "guard" : "veto"},
            {"name", QString::fromStdString(area.name)},
            {"corners_m", corners}};
}

std::optional<Area> readArea(const QJsonObject& object, bool with_vehicle) {
    Area area;
    area.kind = object["kind"].toString() == "veto" ? Area::Kind::Veto : Area::Kind::Guard;
    area.name = object["name"].toString().left(AreaModel::longest_name).toStdString();
    area.with_vehicle = with_vehicle;
    const QJsonArray corners = object["corners_m"].toArray();
    if (area.name.empty() || corners.size() < 3 || corners.size() > AreaModel::most_corners) return std::nullopt;
    for (const QJsonValue& value : corners) {
        const auto corner = readPair(value);
        if (!corner) return std::nullopt;
        area.corners_m.push_back(corner->cast<float>());
    }
    return area;
}

QJsonObject write(const Mark& mark) {
    return {{"number", mark.number},
            {"text", mark.text},
            {"place_m", pairOf(mark.place_m.x(), mark.place_m.y())},
            {"time_us", static_cast<double>(mark.time.time_since_epoch().count())}};
}

std::optional<Mark> readMark(const QJsonObject& object) {
    const auto place = readPair(object["place_m"]);
    const int number = object["number"].toInt();
    if (!place || number < 1) return std::nullopt;
    const double time_us = object["time_us"].toDouble();
    return Mark{number, object["text"].toString().left(MarkModel::longest_text), *place,
                Timestamp(Microseconds(std::abs(time_us) < 1e17 ? static_cast<std::int64_t>(time_us) : 0))};
}

void readAreas(const QJsonValue& value, bool with_vehicle, QList<Area>& areas) {
    const QJsonArray items = value.toArray();
    for (const QJsonValue& item : items)
        if (auto area = readArea(item.toObject(), with_vehicle)) areas << *std::move(area);
}

QJsonDocument parsed(const QVariant& value) { return QJsonDocument::fromJson(value.toByteArray()); }

QByteArray compact(const QJsonDocument& document) { return document.toJson(QJsonDocument::Compact); }

}  // namespace

Chart loadChart(QSettings& settings, const QString& source) {
    Chart chart;
    readAreas(parsed(settings.value(moving_key)).array(), true, chart.areas);
    if (source.isEmpty()) return chart;
    const QJsonArray sources = parsed(settings.value(sources_key)).array();
    for (const QJsonValue& value : sources) {
        const QJsonObject kept = value.toObject();
        if (kept["source"].toString() != source) continue;
        readAreas(kept["areas"], false, chart.areas);
        const QJsonArray marks = kept["marks"].toArray();
        for (const QJsonValue& item : marks)
            if (auto mark = readMark(item.toObject()); mark && chart.marks.size() < MarkModel::most_marks)
                chart.marks << *std::move(mark);
    }
    return chart;
}

void saveChart(QSettings& settings, const QString& source, const Chart& chart) {
    QJsonArray moving, ground, marks;
    for (const Area& area : chart.areas) (area.with_vehicle ? moving : ground).append(write(area));
    for (const Mark& mark : chart.marks) marks.append(write(mark));
    settings.setValue(moving_key, compact(QJsonDocument(moving)));
    if (source.isEmpty()) return;
    QJsonArray sources;
    const QJsonArray before = parsed(settings.value(sources_key)).array();
    for (const QJsonValue& kept : before)
        if (kept.toObject()["source"].toString() != source) sources.append(kept);
    if (!ground.isEmpty() || !marks.isEmpty())
        sources.append(QJsonObject{{"source", source}, {"areas", ground}, {"marks", marks}});
    while (sources.size() > most_kept_sources) sources.removeFirst();
    settings.setValue(sources_key, compact(QJsonDocument(sources)));
}

}  // namespace echotrail
