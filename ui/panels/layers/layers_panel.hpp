#pragma once

#include "core/runtime/scene.hpp"
#include "ui/views/fan_settings.hpp"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace echotrail {

class FanView;

/// What the fan shows and how: its layers with their number, its orientation, and how echo levels become colours.
class LayersPanel : public QWidget {
    Q_OBJECT

public:
    explicit LayersPanel(FanView& fan, QWidget* parent = nullptr);
    void setScene(const Scene& scene);

private:
    struct LayerRow {
        bool Layers::*layer;
        QCheckBox* box;
        QLabel* count;
    };
    struct Level {
        QSlider* slider;
        QLabel* value;
    };

    void addLayerRows();
    void addOrientation();
    void addEcho();
    Level addLevel(const QString& name, int least, int most);
    void readFan();
    void writeEcho(bool black_moved);

    FanView& fan_;
    QVBoxLayout* column_ = nullptr;
    QList<LayerRow> layers_;
    QPushButton* head_up_ = nullptr;
    QPushButton* north_up_ = nullptr;
    QPushButton* course_up_ = nullptr;
    QLabel* orientation_note_ = nullptr;
    QComboBox* map_ = nullptr;
    Level black_{};
    Level white_{};
    Level fade_{};
    bool reading_ = false;  ///< controls are being set from the fan
};

}  // namespace echotrail
