#pragma once

#include "sample_scene.hpp"
#include "ui/views/fan_view.hpp"
#include "ui/views/orientation.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <cmath>

namespace echotrail::test {

inline Layers onlyEchoes() {
    Layers layers;
    for (bool Layers::*layer :
         {&Layers::regions_kept, &Layers::regions_dropped, &Layers::particles, &Layers::tracks, &Layers::ellipses,
          &Layers::history, &Layers::region_of_interest, &Layers::graticule, &Layers::inset})
        layers.*layer = false;
    return layers;
}

/// The beam points aft, so that only echoes are bright ahead.
inline Scene echoScene() {
    Scene scene = bareScene();
    scene.latest.beam = Bearing::degrees(180.0);
    return scene;
}

/// A fan of 1000 x 900 pixels that counts what is designated on it.
class FanViewTest : public testing::Test {
protected:
    FanViewTest() {
        applyTheme(*qApp, Theme::Dusk);
        view_.resize(1000, 900);
        view_.setEcho({EchoMap::Grey, 0.0, 80.0, 0.0});
        view_.show();
        QObject::connect(&view_, &FanView::designated, [this](double range_m, Bearing from_bow) {
            ++designations_;
            range_ = range_m;
            bearing_ = from_bow;
        });
    }
    ~FanViewTest() override { applyFontScale(*qApp, 1.0); }

    /// The view as it is before zooming and dragging.
    FanGeometry geometry() const {
        return fitted(view_.scene()->latest.pose, upOf(*view_.scene(), view_.orientation()),
                      sectorToFit(*view_.scene()), view_.rect(), QMarginsF(44, 58, 44, 22));
    }
    /// The sea stays dark, an echo bright.
    void showOnlyBrightEchoes() {
        view_.setLayers(onlyEchoes());
        view_.setEcho({EchoMap::Grey, 10.0, 60.0, 0.0});
    }
    void click(const QPointF& place, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(&view_, Qt::LeftButton, keys, place.toPoint());
    }

    FanView view_;
    int designations_ = 0;
    double range_ = 0.0;
    Bearing bearing_;
};

}  // namespace echotrail::test
