#include "ui/panels/chart/chart_panel.hpp"

#include "ui/language/language.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

namespace echotrail {

ChartPanel::ChartPanel(MarkModel& marks, AreaModel& areas, QWidget* parent)
    : QWidget(parent), marks_(marks), areas_(areas) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(UiMetrics(font()).pixels(4.0));
    addMarks(*column);
    addAreas(*column);
    sizeRows();
    inEveryLanguage(this, [this] { nameAll(); });
    connect(&marks_, &MarkModel::modelReset, this, &ChartPanel::showButtons);
    connect(&areas_, &AreaModel::modelReset, this, &ChartPanel::showButtons);
}

void ChartPanel::nameAll() {
    const auto name = [](QPushButton& button, const QString& text, const QString& tip) {
        button.setText(text);
        button.setToolTip(tip);
        button.setStatusTip(tip);
    };
    name(*set_mark_, tr("Mark"), tr("Mark the place under the cursor, else the target (M)"));
    name(*delete_mark_, tr("Delete"), tr("Delete the selected mark; Ctrl+Z brings it back"));
    name(*guard_, tr("Guard zone…"), tr("Draw a guard zone on the fan: click its corners, Enter closes it (G)"));
    name(*veto_, tr("Veto area…"),
         tr("Draw an area in which guard zones stay silent: click its corners, Enter closes it (V)"));
    name(*frame_, {}, tr("Whether the selected area moves with the vehicle or stays"));
    name(*delete_area_, tr("Delete"), tr("Delete the selected area; Ctrl+Z brings it back"));
    mark_table_->setAccessibleName(tr("Marks"));
    area_table_->setAccessibleName(tr("Areas"));
    for (QTableView* table : {mark_table_, area_table_}) table->horizontalHeader()->reset();  // sizes of its titles
    showButtons();
}

QTableView* ChartPanel::addTable(QAbstractItemModel& model, QVBoxLayout& column) {
    auto* table = new QTableView(this);
    table->setModel(&model);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setTabKeyNavigation(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->installEventFilter(this);
    column.addWidget(table, 1);
    connect(table->selectionModel(), &QItemSelectionModel::currentChanged, this, &ChartPanel::showButtons);
    return table;
}

QPushButton* ChartPanel::addButton(QLayout& row) {
    auto* button = new QPushButton(this);
    row.addWidget(button);
    return button;
}

void ChartPanel::addMarks(QVBoxLayout& column) {
    mark_table_ = addTable(marks_, column);
    mark_table_->horizontalHeader()->setSectionResizeMode(MarkModel::Text, QHeaderView::Stretch);
    mark_table_->setColumnHidden(MarkModel::Time, true);
    auto* row = new QHBoxLayout;
    set_mark_ = addButton(*row);
    delete_mark_ = addButton(*row);
    row->addStretch(1);
    column.addLayout(row);
    connect(set_mark_, &QPushButton::clicked, this, &ChartPanel::markRequested);
    connect(delete_mark_, &QPushButton::clicked, this, [this] { marks_.remove(currentRow(*mark_table_)); });
}

void ChartPanel::addAreas(QVBoxLayout& column) {
    area_table_ = addTable(areas_, column);
    area_table_->horizontalHeader()->setSectionResizeMode(AreaModel::Name, QHeaderView::Stretch);
    auto* draw = new QHBoxLayout;
    guard_ = addButton(*draw);
    veto_ = addButton(*draw);
    draw->addStretch(1);
    column.addLayout(draw);
    auto* change = new QHBoxLayout;
    frame_ = addButton(*change);
    delete_area_ = addButton(*change);
    change->addStretch(1);
    column.addLayout(change);
    connect(guard_, &QPushButton::clicked, this, [this] { Q_EMIT areaRequested(Area::Kind::Guard); });
    connect(veto_, &QPushButton::clicked, this, [this] { Q_EMIT areaRequested(Area::Kind::Veto); });
    connect(delete_area_, &QPushButton::clicked, this, [this] { areas_.remove(currentRow(*area_table_)); });
    connect(frame_, &QPushButton::clicked, this, [this] {
        const int row = currentRow(*area_table_);
        if (row >= 0) areas_.setWithVehicle(row, !areas_.areas()[row].with_vehicle, vehicle_);
    });
}

void ChartPanel::setScene(const Scene& scene) {
    vehicle_ = scene.latest.pose;
    marks_.setVehicle(vehicle_, scene.navigation_known);
}

void ChartPanel::editMark(int number) {
    const auto& marks = marks_.marks();
    const auto found =
        std::find_if(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.number == number; });
    if (found == marks.end()) return;
    const QModelIndex text = marks_.index(static_cast<int>(found - marks.begin()), MarkModel::Text);
    mark_table_->setCurrentIndex(text);
    mark_table_->edit(text);
}

int ChartPanel::currentRow(const QTableView& table) const {
    return table.currentIndex().isValid() ? table.currentIndex().row() : -1;
}

void ChartPanel::showButtons() {
    delete_mark_->setEnabled(currentRow(*mark_table_) >= 0);
    const int area = currentRow(*area_table_);
    delete_area_->setEnabled(area >= 0);
    frame_->setEnabled(area >= 0);
    const bool moves = area >= 0 && area < areas_.areas().size() && areas_.areas()[area].with_vehicle;
    frame_->setText(moves || area < 0 ? tr("Fix to ground") : tr("Fix to vehicle"));
}

void ChartPanel::sizeRows() {
    for (QTableView* table : {mark_table_, area_table_})
        table->verticalHeader()->setDefaultSectionSize(UiMetrics(font()).pixels(24.0));
}

bool ChartPanel::eventFilter(QObject* watched, QEvent* event) {
    // Enter edits what the row is called; the table itself would want F2, which follows the vehicle.
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        auto* table = static_cast<QTableView*>(watched);
        if ((key == Qt::Key_Return || key == Qt::Key_Enter) && currentRow(*table) >= 0) {
            const int column = table == mark_table_ ? int{MarkModel::Text} : int{AreaModel::Name};
            table->edit(table->currentIndex().siblingAtColumn(column));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ChartPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) sizeRows();
    QWidget::changeEvent(event);
}

}  // namespace echotrail
