#pragma once

#include "core/runtime/scene.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"

#include <QWidget>

class QPushButton;
class QTableView;
class QVBoxLayout;

namespace echotrail {

/// The lists of marks and of areas, to rename (Enter or a double click), delete, and fix to vehicle or ground.
class ChartPanel : public QWidget {
    Q_OBJECT

public:
    ChartPanel(MarkModel& marks, AreaModel& areas, QWidget* parent = nullptr);
    void setScene(const Scene& scene);
    /// Begins to edit the text of a mark.
    void editMark(int number);

Q_SIGNALS:
    void markRequested();
    void areaRequested(echotrail::Area::Kind kind);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QTableView* addTable(QAbstractItemModel& model, QVBoxLayout& column);
    QPushButton* addButton(QLayout& row);
    void nameAll();
    void addMarks(QVBoxLayout& column);
    void addAreas(QVBoxLayout& column);
    void sizeRows();
    void showButtons();
    int currentRow(const QTableView& table) const;

    MarkModel& marks_;
    AreaModel& areas_;
    Pose vehicle_;
    QTableView* mark_table_ = nullptr;
    QTableView* area_table_ = nullptr;
    QPushButton* set_mark_ = nullptr;
    QPushButton* guard_ = nullptr;
    QPushButton* veto_ = nullptr;
    QPushButton* delete_mark_ = nullptr;
    QPushButton* delete_area_ = nullptr;
    QPushButton* frame_ = nullptr;
};

}  // namespace echotrail
