#include "sample_scene.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/chart/chart_store.hpp"
#include "ui/chart/guard_watch.hpp"
#include "ui/chart/mark_model.hpp"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSettings>
#include <QTemporaryDir>

namespace echotrail {
namespace {

using Tester = QAbstractItemModelTester;
constexpr auto fatal = Tester::FailureReportingMode::Fatal;

const Area box{Area::Kind::Guard, "", false, {{10.0F, 0.0F}, {14.0F, 0.0F}, {14.0F, 4.0F}, {10.0F, 4.0F}}};

TEST(MarkModel, SettingRenamingAndDeletingCanBeUndone) {
    QUndoStack undo;
    MarkModel model(undo);
    const Tester tester(&model, fatal);
    EXPECT_EQ(model.add({3.0, 4.0}, test::scene_time), 1);
    EXPECT_EQ(model.add({6.0, 8.0}, test::scene_time), 2);
    EXPECT_TRUE(model.setData(model.index(0, MarkModel::Text), "  net? "));
    EXPECT_EQ(model.marks()[0].label(), "M1 net?");
    model.remove(0);
    ASSERT_EQ(model.rowCount(), 1);
    undo.undo();
    EXPECT_EQ(model.marks()[0].label(), "M1 net?");
    undo.undo();
    EXPECT_EQ(model.marks()[0].label(), "M1");
    undo.undo();
    EXPECT_EQ(model.rowCount(), 1);
    undo.redo();
    EXPECT_EQ(model.add({0.0, 0.0}, test::scene_time), 3) << "a number is never given twice";
}

TEST(MarkModel, ShowsWhereAMarkLiesFromTheVehicle) {
    QUndoStack undo;
    MarkModel model(undo);
    model.add({0.0, 12.0}, test::scene_time);
    model.setVehicle({0.0, 2.0, Bearing::degrees(30.0)}, true);
    EXPECT_EQ(model.index(0, MarkModel::Range).data().toString(), "10.0 m");
    EXPECT_EQ(model.index(0, MarkModel::BearingTo).data().toString(), QString("090.0") + QChar(0xb0) + "T");
    model.setVehicle({0.0, 2.0, Bearing::degrees(30.0)}, false);
    EXPECT_EQ(model.index(0, MarkModel::BearingTo).data().toString(), QString("060.0") + QChar(0xb0) + "R");
}

TEST(AreaModel, NamesDrawsMovesAndUndoes) {
    QUndoStack undo;
    AreaModel model(undo);
    const Tester tester(&model, fatal);
    EXPECT_TRUE(model.add(box));
    EXPECT_TRUE(model.add(box));
    EXPECT_EQ(model.areas()[1].name, "Guard 2");
    EXPECT_FALSE(model.add({Area::Kind::Veto, "", false, {{0.0F, 0.0F}, {1.0F, 0.0F}}}));
    model.setCorner(0, 2, {20.0F, 6.0F});
    EXPECT_EQ(model.areas()[0].corners_m[2].x(), 20.0F);
    undo.undo();
    EXPECT_EQ(model.areas()[0].corners_m[2].x(), 14.0F);
    model.rename(0, "  quay ");
    model.remove(1);
    EXPECT_EQ(model.rowCount(), 1);
    EXPECT_EQ(model.areas()[0].name, "quay");
}

TEST(AreaModel, FixedToTheVehicleItStaysWhereItIsAtThatMoment) {
    QUndoStack undo;
    AreaModel model(undo);
    model.add(box);
    const Pose vehicle{5.0, -3.0, Bearing::degrees(70.0)};
    model.setWithVehicle(0, true, vehicle);
    EXPECT_TRUE(model.areas()[0].with_vehicle);
    EXPECT_TRUE(holds(model.areas()[0], {12.0F, 2.0F}, vehicle));
    EXPECT_FALSE(holds(model.areas()[0], {12.0F, 2.0F}, {50.0, -3.0, Bearing::degrees(70.0)}));
}

class Guards : public testing::Test {
protected:
    Guards() {
        areas_.add(box);
        QObject::connect(&watch_, &GuardWatch::guardZoneEntered,
                         [this](int id, const QString& zone) { told_ << QString("%1 in %2").arg(id).arg(zone); });
        QObject::connect(&watch_, &GuardWatch::guardZoneLeft,
                         [this](int id, const QString& zone) { told_ << QString("%1 out of %2").arg(id).arg(zone); });
    }
    void show(TrackState state, double north) {
        Scene scene = test::bareScene();
        scene.position = ++position_;
        scene.tracks = {test::sampleTrack(1, state, north, 2.0)};
        watch_.setScene(scene);
    }
    QUndoStack undo_;
    AreaModel areas_{undo_};
    GuardWatch watch_{areas_};
    QStringList told_;
    std::uint64_t position_ = 10;
};

TEST_F(Guards, AConfirmedTrackIsToldOfOncePerVisit) {
    show(TrackState::Confirmed, 16.0);
    show(TrackState::Confirmed, 13.0);
    show(TrackState::Confirmed, 12.0);
    show(TrackState::Coasting, 11.0);
    EXPECT_EQ(told_, QStringList{"1 in Guard 1"});
    show(TrackState::Confirmed, 9.0);
    show(TrackState::Confirmed, 11.0);
    EXPECT_EQ(told_, (QStringList{"1 in Guard 1", "1 out of Guard 1", "1 in Guard 1"}));
}

TEST_F(Guards, WhatIsTentativeOrOnlyExpectedDoesNotComeIn) {
    show(TrackState::Tentative, 12.0);
    show(TrackState::Coasting, 12.0);
    show(TrackState::Lost, 12.0);
    EXPECT_TRUE(told_.isEmpty());
}

TEST_F(Guards, AVetoAreaGuardsNothing) {
    Area veto = box;
    veto.kind = Area::Kind::Veto;
    areas_.replace({veto});
    show(TrackState::Confirmed, 12.0);
    EXPECT_TRUE(told_.isEmpty());
}

TEST_F(Guards, InAVetoAreaAZoneStaysSilent) {
    Area veto = box;
    veto.kind = Area::Kind::Veto;
    veto.corners_m = {{11.0F, 1.0F}, {13.0F, 1.0F}, {13.0F, 3.0F}, {11.0F, 3.0F}};
    areas_.add(veto);
    show(TrackState::Confirmed, 12.0);
    EXPECT_TRUE(told_.isEmpty());
    show(TrackState::Confirmed, 13.5);
    EXPECT_EQ(told_, QStringList{"1 in Guard 1"});
}

TEST_F(Guards, AfterAJumpBackAVisitIsToldAgain) {
    show(TrackState::Confirmed, 12.0);
    position_ = 1;
    show(TrackState::Confirmed, 12.0);
    EXPECT_EQ(told_.size(), 2);
}

class ChartStore : public testing::Test {
protected:
    QTemporaryDir folder_;
    QSettings settings_{folder_.filePath("chart.ini"), QSettings::IniFormat};
};

TEST_F(ChartStore, WhatLiesOnTheGroundComesBackWithItsRecordingOnly) {
    Area moving = box;
    moving.name = "ahead";
    moving.with_vehicle = true;
    Area ground = box;
    ground.name = "quay";
    ground.kind = Area::Kind::Veto;
    const Mark mark{4, "net?", {1.5, -2.5}, test::scene_time};
    saveChart(settings_, "one.V4LOG", {{mark}, {moving, ground}});
    const Chart again = loadChart(settings_, "one.V4LOG");
    EXPECT_EQ(again.marks, QList<Mark>{mark});
    EXPECT_EQ(again.areas, (QList<Area>{moving, ground}));
    EXPECT_EQ(loadChart(settings_, "two.V4LOG").areas, QList<Area>{moving});
    EXPECT_TRUE(loadChart(settings_, "two.V4LOG").marks.isEmpty());
    EXPECT_EQ(loadChart(settings_, "").areas, QList<Area>{moving});
}

TEST_F(ChartStore, DamagedSettingsGiveWhatIsStillGood) {
    settings_.setValue("chart/with_vehicle",
                       R"([{"name":"a","kind":"guard","corners_m":[[0,0],[1,0],["x",1]]},
                           {"name":"b","kind":"guard","corners_m":[[0,0],[1,0]]},
                           {"name":"c","kind":"guard","corners_m":[[0,0],[1,0],[1e300,1]]},
                           {"name":"d","kind":"guard","corners_m":[[0,0],[1,0],[1,1]]}, 7])");
    settings_.setValue("chart/sources", "[{\"source\":\"s\",\"marks\":[{\"number\":0,\"place_m\":[1,1]},{}]");
    const Chart chart = loadChart(settings_, "s");
    ASSERT_EQ(chart.areas.size(), 1);
    EXPECT_EQ(chart.areas[0].name, "d");
    EXPECT_TRUE(chart.marks.isEmpty());
}

TEST_F(ChartStore, TheOldestRecordingsAreForgotten) {
    const Mark mark{1, "", {1.0, 1.0}, {}};
    for (int i = 0; i <= most_kept_sources; ++i) saveChart(settings_, QString::number(i), {{mark}, {}});
    EXPECT_TRUE(loadChart(settings_, "0").marks.isEmpty());
    EXPECT_EQ(loadChart(settings_, QString::number(most_kept_sources)).marks.size(), 1);
}

}  // namespace
}  // namespace echotrail
