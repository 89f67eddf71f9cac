#include "sample_scene.hpp"
#include "ui/models/track_model.hpp"
#include "ui/panels/layers/layers_panel.hpp"
#include "ui/panels/tracks/tracks_panel.hpp"
#include "ui/style/palette.hpp"
#include "ui/views/fan_view.hpp"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTest>

namespace echotrail {
namespace {

QStringList ids(const TrackModel& model) {
    QStringList all;
    for (int row = 0; row < model.rowCount(); ++row) all << model.index(row, TrackModel::Id).data().toString();
    return all;
}

TEST(TrackModel, TheTargetComesFirstThenTheSurest) {
    TrackModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setScene(test::fullScene());
    EXPECT_EQ(ids(model), (QStringList{"T01", "T02", "T05", "T03"}));
    EXPECT_EQ(model.index(0, TrackModel::Range).data().toString(), "12.2");
    EXPECT_EQ(model.index(0, TrackModel::BearingFromBow).data().toString(), "009.5");
    EXPECT_EQ(model.index(0, TrackModel::Age).data().toString(), "1.7");
    EXPECT_EQ(model.index(3, TrackModel::State).data(Qt::ForegroundRole).value<QColor>(), currentPalette().alarm);
}

TEST(TrackModel, RowsMoveComeAndGoWithoutAReset) {
    TrackModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    int resets = 0;
    QObject::connect(&model, &QAbstractItemModel::modelReset, [&] { ++resets; });
    Scene scene = test::fullScene();
    model.setScene(scene);
    const QPersistentModelIndex kept = model.index(2, TrackModel::Id);  // T05
    scene.tracks[0].target = false;
    scene.tracks[3].target = true;
    scene.tracks.erase(scene.tracks.begin() + 1);
    scene.tracks.push_back(test::sampleTrack(9, TrackState::Confirmed, 5.0, 0.0));
    model.setScene(scene);
    EXPECT_EQ(ids(model), (QStringList{"T05", "T01", "T09", "T03"}));
    EXPECT_EQ(kept.row(), 0);
    EXPECT_EQ(kept.data().toString(), "T05");
    model.clear();
    EXPECT_EQ(model.rowCount(), 0);
    EXPECT_EQ(resets, 0);
}

TEST(TrackModel, OneLookTellsNoSpeed) {
    TrackModel model;
    Scene scene = test::fullScene();
    scene.tracks[0].looks = 1;
    model.setScene(scene);
    EXPECT_EQ(model.index(0, TrackModel::Speed).data().toString(), QString::fromUtf8("\u2014"));
}

TEST(TracksPanel, TheCardIsThatOfTheTargetUntilARowIsChosen) {
    TracksPanel panel;
    panel.resize(400, 700);
    panel.show();
    const Scene scene = test::fullScene();
    panel.setScene(scene);
    auto* table = panel.findChild<QTableView*>();
    EXPECT_EQ(table->currentIndex().row(), 0);
    std::vector<int> chosen;
    QObject::connect(&panel, &TracksPanel::trackSelected, [&](int id) { chosen.push_back(id); });
    table->selectRow(1);
    panel.setScene(scene);
    EXPECT_EQ(chosen, std::vector<int>{2});
    EXPECT_EQ(table->currentIndex().row(), 1);
}

TEST(TracksPanel, DesignatingAsksForTheSelectedTracksPlace) {
    TracksPanel panel;
    panel.show();
    panel.selectTrack(2);
    panel.setScene(test::fullScene());
    double range = 0.0;
    QObject::connect(&panel, &TracksPanel::designateRequested, [&](double range_m, Bearing) { range = range_m; });
    for (QPushButton* button : panel.findChildren<QPushButton*>())
        if (button->text() == "Designate") button->click();
    EXPECT_NEAR(range, std::hypot(16.0, 5.0), 1e-9);
}

TEST(LayersPanel, CheckBoxesAndTheFanAgreeBothWays) {
    FanView fan;
    LayersPanel panel(fan);
    panel.show();
    for (QCheckBox* box : panel.findChildren<QCheckBox*>())
        if (box->text() == "Particles") box->click();
    EXPECT_FALSE(fan.layers().particles);
    Layers layers = fan.layers();
    layers.particles = true;
    fan.setLayers(layers);
    for (QCheckBox* box : panel.findChildren<QCheckBox*>())
        if (box->text() == "Particles") {
            EXPECT_TRUE(box->isChecked());
        }
}

TEST(LayersPanel, BlackPushesWhiteBeforeIt) {
    FanView fan;
    LayersPanel panel(fan);
    for (QSlider* slider : panel.findChildren<QSlider*>())
        if (slider->accessibleName() == "Black at") slider->setValue(70);
    EXPECT_EQ(fan.echo().black_db, 70.0);
    EXPECT_EQ(fan.echo().white_db, 75.0);
}

TEST(LayersPanel, NorthUpIsGreyAndSaysWhyWithoutAHeading) {
    FanView fan;
    LayersPanel panel(fan);
    panel.show();
    Scene scene = test::bareScene();
    QPushButton* north_up = nullptr;
    for (QPushButton* button : panel.findChildren<QPushButton*>())
        if (button->text() == "North up") north_up = button;
    ASSERT_NE(north_up, nullptr);
    panel.setScene(scene);
    EXPECT_FALSE(north_up->isEnabled());
    scene.latest.pose.heading = Bearing::degrees(20.0);
    scene.navigation_known = true;
    panel.setScene(scene);
    EXPECT_TRUE(north_up->isEnabled());
}

}  // namespace
}  // namespace echotrail
