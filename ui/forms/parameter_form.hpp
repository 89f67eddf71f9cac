#pragma once

#include "ui/forms/parameter_filter.hpp"
#include "ui/forms/parameter_model.hpp"
#include "ui/forms/parameter_presets.hpp"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTreeView;

namespace echotrail {

/// The form grown from the descriptions of the parameters: find, change, undo, go back to defaults, keep in files and
/// presets, compare with them.
class ParameterForm : public QWidget {
    Q_OBJECT

public:
    /// The model is not owned and must outlive the form.
    explicit ParameterForm(ParameterModel& model, ParameterPresets presets = {}, QWidget* parent = nullptr);

    QTreeView& tree() { return *tree_; }
    void focusSearch();
    /// The name of the selected parameter as in files; empty where none is.
    QString selectedName() const;

public Q_SLOTS:
    void loadFile();
    void saveFile();
    void resetRow();
    void toggleFavourite();
    /// Sets what the preset says.
    void takePreset(const QString& name);
    /// Values are compared with the preset instead of the defaults; an empty name: with the defaults again.
    void compareWith(const QString& name);
    void savePreset(const QString& name);

Q_SIGNALS:
    /// A file was read or written (`ok`) or could not be: a line for the window's message strip.
    void message(const QString& text, bool ok);

private:
    QWidget* makeSearchRow();
    QWidget* makeButtons();
    void fillPresetMenu();
    void askForPresetName();
    void makeTree();
    void showRow(const QModelIndex& current);
    void showRefusal(const QString& reason);
    void openGroups();
    void updateButtons();
    QModelIndex currentParameter() const;
    void editFirst();

    ParameterModel& model_;
    ParameterPresets presets_;
    ParameterFilter filter_;
    QTreeView* tree_ = nullptr;
    QLineEdit* search_ = nullptr;
    QCheckBox* changed_only_ = nullptr;
    QCheckBox* favourites_only_ = nullptr;
    QMenu* preset_menu_ = nullptr;
    QLabel* help_ = nullptr;
    QLabel* refusal_ = nullptr;
    QPushButton* undo_ = nullptr;
    QPushButton* redo_ = nullptr;
    QPushButton* reset_ = nullptr;
    QPushButton* reset_all_ = nullptr;
};

}  // namespace echotrail
