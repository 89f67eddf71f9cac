#include "ui/forms/parameter_form.hpp"

#include "ui/forms/parameter_delegate.hpp"
#include "ui/forms/parameter_set.hpp"

#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

namespace echotrail {
namespace {

// Qt's own dialog: the desktop's would not follow the night palette.
constexpr auto own_dialog = QFileDialog::DontUseNativeDialog;

QString fileFilter() { return ParameterForm::tr("Parameter sets (*.toml)"); }

}  // namespace

ParameterForm::ParameterForm(ParameterModel& model, ParameterPresets presets, QWidget* parent)
    : QWidget(parent), model_(model), presets_(std::move(presets)) {
    filter_.setSourceModel(&model_);
    makeTree();
    help_ = new QLabel(this);
    help_->setObjectName("dim");
    help_->setWordWrap(true);
    help_->setMinimumHeight(3 * fontMetrics().lineSpacing());
    help_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    refusal_ = new QLabel(this);
    refusal_->setObjectName("refusal");
    refusal_->setWordWrap(true);
    refusal_->hide();

    auto* layout = new QVBoxLayout(this);
    const int gap = fontMetrics().height() / 3;
    layout->setContentsMargins(gap, gap, gap, gap);
    layout->setSpacing(gap);
    layout->addWidget(makeSearchRow());
    layout->addWidget(tree_, 1);
    layout->addWidget(refusal_);
    layout->addWidget(help_);
    layout->addWidget(makeButtons());

    connect(&model_, &ParameterModel::refused, this, &ParameterForm::showRefusal);
    connect(&model_, &ParameterModel::valuesChanged, this, [this] { showRefusal({}); });
    connect(&model_, &QAbstractItemModel::dataChanged, this, [this] {
        showRow(tree_->currentIndex());
        updateButtons();
    });
    updateButtons();
    showRow({});
}

void ParameterForm::makeTree() {
    tree_ = new QTreeView(this);
    tree_->setModel(&filter_);
    auto* delegate = new ParameterDelegate(tree_);
    tree_->setItemDelegate(delegate);
    connect(delegate, &ParameterDelegate::favouriteToggled, this, [this](const QModelIndex& row) {
        const QModelIndex source = filter_.mapToSource(row);
        model_.setFavourite(source, !source.data(ParameterModel::Favourite).toBool());
    });
    tree_->setAccessibleName(tr("Parameters"));
    tree_->setUniformRowHeights(false);
    tree_->setIndentation(0);
    tree_->setRootIsDecorated(false);
    tree_->setAllColumnsShowFocus(true);
    tree_->setEditTriggers(QAbstractItemView::CurrentChanged | QAbstractItemView::SelectedClicked |
                           QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
    tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tree_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    QHeaderView* header = tree_->header();
    header->setSectionsMovable(false);
    header->setStretchLastSection(false);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(ParameterModel::Name, QHeaderView::Stretch);
    const QFontMetrics metrics(font());
    header->resizeSection(ParameterModel::Default, metrics.horizontalAdvance("Default 00"));
    header->resizeSection(ParameterModel::Value, metrics.horizontalAdvance("00 000.000 +-"));
    tree_->setColumnHidden(ParameterModel::Unit, true);  // the limits under the name say it; names need the room
    const int state = std::max(metrics.horizontalAdvance("✕ " + ParameterModel::tr("refused")),
                               metrics.horizontalAdvance("✓ " + ParameterModel::tr("in force")));
    header->resizeSection(ParameterModel::State, state + metrics.height());
    header->resizeSection(ParameterModel::Star, metrics.height() * 3 / 2);
    connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
        showRow(current);
        // Whichever cell was hit, the value is what one edits.
        const QModelIndex value = current.siblingAtColumn(ParameterModel::Value);
        if (current.isValid() && current != value && value.flags().testFlag(Qt::ItemIsEditable))
            QMetaObject::invokeMethod(
                tree_, [this, value] { tree_->setCurrentIndex(value); }, Qt::QueuedConnection);
    });
    connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        if (!index.data(ParameterModel::IsParameter).toBool())
            tree_->setExpanded(index.siblingAtColumn(0), !tree_->isExpanded(index.siblingAtColumn(0)));
    });
    openGroups();
}

QWidget* ParameterForm::makeSearchRow() {
    auto* row = new QWidget(this);
    search_ = new QLineEdit(row);
    search_->setPlaceholderText(tr("Find  Ctrl+F"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Find a parameter"));
    changed_only_ = new QCheckBox(tr("Changed"), row);
    changed_only_->setToolTip(tr("Only what differs from the default, or from the preset that is compared with"));
    favourites_only_ = new QCheckBox(tr("Favourites"), row);
    favourites_only_->setToolTip(tr("Only what is starred; a click on the star, or Ctrl+B, stars a parameter"));
    auto* preset = new QToolButton(row);
    preset->setText(tr("Preset"));
    preset->setPopupMode(QToolButton::InstantPopup);
    // Room for the sign that there is a menu, which the style does not keep.
    preset->setMinimumWidth(preset->fontMetrics().horizontalAdvance(preset->text()) + 2 * fontMetrics().height());
    preset_menu_ = new QMenu(preset);
    connect(preset_menu_, &QMenu::aboutToShow, this, &ParameterForm::fillPresetMenu);
    fillPresetMenu();
    preset->setMenu(preset_menu_);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins({});
    layout->addWidget(search_, 1);
    layout->addWidget(changed_only_);
    layout->addWidget(favourites_only_);
    layout->addWidget(preset);
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& words) {
        filter_.setSearch(words);
        openGroups();
    });
    connect(search_, &QLineEdit::returnPressed, this, &ParameterForm::editFirst);
    auto* down = new QShortcut(QKeySequence(Qt::Key_Down), search_);
    down->setContext(Qt::WidgetShortcut);
    connect(down, &QShortcut::activated, this, &ParameterForm::editFirst);
    connect(changed_only_, &QCheckBox::toggled, this, [this](bool on) {
        filter_.setChangedOnly(on);
        openGroups();
    });
    connect(favourites_only_, &QCheckBox::toggled, this, [this](bool on) {
        filter_.setFavouritesOnly(on);
        openGroups();
    });
    return row;
}

/// From the search to the value of the first parameter that was found.
void ParameterForm::editFirst() {
    const QModelIndex value = filter_.index(0, ParameterModel::Value, filter_.index(0, 0));
    if (!value.isValid()) return;
    tree_->setFocus(Qt::ShortcutFocusReason);
    if (tree_->currentIndex() == value)
        tree_->edit(value);
    else
        tree_->setCurrentIndex(value);
}

QWidget* ParameterForm::makeButtons() {
    auto* row = new QWidget(this);
    undo_ = new QPushButton(tr("Undo"), row);
    redo_ = new QPushButton(tr("Redo"), row);
    reset_ = new QPushButton(tr("Default"), row);
    reset_all_ = new QPushButton(tr("All defaults"), row);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins({});
    for (QPushButton* button : {undo_, redo_, reset_, reset_all_}) layout->addWidget(button);
    layout->addStretch(1);
    connect(undo_, &QPushButton::clicked, &model_.undoStack(), &QUndoStack::undo);
    connect(redo_, &QPushButton::clicked, &model_.undoStack(), &QUndoStack::redo);
    connect(reset_, &QPushButton::clicked, this, &ParameterForm::resetRow);
    connect(reset_all_, &QPushButton::clicked, &model_, &ParameterModel::resetAll);
    connect(&model_.undoStack(), &QUndoStack::indexChanged, this, &ParameterForm::updateButtons);
    return row;
}

void ParameterForm::openGroups() {
    tree_->expandAll();
    for (int row = 0; row < filter_.rowCount(); ++row) tree_->setFirstColumnSpanned(row, {}, true);
}

QModelIndex ParameterForm::currentParameter() const {
    const QModelIndex current = filter_.mapToSource(tree_->currentIndex());
    return model_.info(current) ? current : QModelIndex();
}

void ParameterForm::showRow(const QModelIndex& current) {
    const ParameterInfo* info = model_.info(filter_.mapToSource(current));
    updateButtons();
    if (!info) {
        help_->setText(tr("Select a parameter to read what it does. Enter takes a value, Esc leaves it as it was."));
        return;
    }
    const QString effect = info->effect == Effect::NextPing ? tr("ping") : tr("sweep");
    help_->setText(QStringLiteral("<b>%1</b> — %2. ")
                       .arg(QString::fromStdString(info->name), QString::fromStdString(info->help).toHtmlEscaped()) +
                   tr("Default %1 %2. Takes effect at the next %3.")
                       .arg(shownValue(info->default_value), QString::fromStdString(info->unit), effect));
}

void ParameterForm::showRefusal(const QString& reason) {
    refusal_->setText(reason.isEmpty() ? QString() : tr("Refused: %1.").arg(reason));
    refusal_->setVisible(!reason.isEmpty());
}

void ParameterForm::updateButtons() {
    if (!undo_) return;
    const QUndoStack& stack = model_.undoStack();
    undo_->setEnabled(stack.canUndo());
    undo_->setToolTip(stack.canUndo() ? tr("Undo: %1 (Ctrl+Z)").arg(stack.undoText()) : tr("Nothing to undo"));
    redo_->setEnabled(stack.canRedo());
    redo_->setToolTip(stack.canRedo() ? tr("Redo: %1 (Ctrl+Shift+Z)").arg(stack.redoText()) : tr("Nothing to redo"));
    const bool compares = !model_.referenceName().isEmpty();
    reset_->setText(compares ? tr("Take over") : tr("Default"));
    reset_->setToolTip(compares ? tr("Sets the selected parameter as in %1").arg(model_.referenceName())
                                : tr("Sets the selected parameter back to its default"));
    reset_all_->setText(compares ? tr("Take all") : tr("All defaults"));
    const QModelIndex row = currentParameter();
    reset_->setEnabled(row.isValid() && row.data(ParameterModel::Changed).toBool());
    reset_all_->setEnabled(model_.changedCount() > 0);
}

void ParameterForm::focusSearch() {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

void ParameterForm::resetRow() { model_.reset(currentParameter()); }

QString ParameterForm::selectedName() const {
    const ParameterInfo* info = model_.info(currentParameter());
    return info ? QString::fromStdString(info->name) : QString();
}

void ParameterForm::toggleFavourite() {
    const QModelIndex row = currentParameter();
    model_.setFavourite(row, !row.data(ParameterModel::Favourite).toBool());
}

void ParameterForm::loadFile() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Load a parameter set"), {}, fileFilter(), nullptr, own_dialog);
    if (path.isEmpty()) return;
    auto values = readParameterSet(path, model_.infos(), model_.values());
    if (!values) {
        Q_EMIT message(tr("Nothing was loaded. %1. Correct the file and load it again.")
                           .arg(QString::fromStdString(values.error())),
                       false);
        return;
    }
    model_.change(std::move(*values), tr("load of %1").arg(QFileInfo(path).fileName()));
    Q_EMIT message(tr("Parameters loaded from %1; Ctrl+Z takes them back.").arg(QFileInfo(path).fileName()), true);
}

void ParameterForm::saveFile() {
    QString path =
        QFileDialog::getSaveFileName(this, tr("Save the parameter set"), {}, fileFilter(), nullptr, own_dialog);
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += ".toml";
    const auto written = writeParameterSet(path, model_.infos(), model_.values());
    Q_EMIT message(written ? tr("Parameters saved to %1.").arg(path)
                           : tr("%1. Choose another place.").arg(QString::fromStdString(written.error())),
                   written.has_value());
}

}  // namespace echotrail
