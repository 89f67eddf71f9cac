#include "ui/forms/parameter_form.hpp"

#include <QCheckBox>
#include <QInputDialog>
#include <QMenu>

namespace echotrail {

void ParameterForm::fillPresetMenu() {
    preset_menu_->clear();
    auto* compare = new QMenu(tr("&Compare with"), preset_menu_);
    const auto list = [&](const QStringList& names) {
        for (const QString& name : names) {
            preset_menu_->addAction(name, this, [this, name] { takePreset(name); })
                ->setStatusTip(tr("Sets all parameters as in this preset; Ctrl+Z takes them back"));
            QAction* each = compare->addAction(name, this, [this, name] { compareWith(name); });
            each->setStatusTip(tr("Shows only what differs, beside what is set"));
            each->setCheckable(true);
            each->setChecked(name == model_.referenceName());
        }
    };
    QAction* defaults = compare->addAction(tr("the defaults"), this, [this] { compareWith({}); });
    defaults->setStatusTip(tr("Shows only what differs, beside what is set"));
    defaults->setCheckable(true);
    defaults->setChecked(model_.referenceName().isEmpty());
    list(presets_.builtIn());
    preset_menu_->addSeparator();
    list(presets_.own());
    preset_menu_->addSeparator();
    preset_menu_->addMenu(compare);
    preset_menu_->addAction(tr("&Keep as preset…"), this, &ParameterForm::askForPresetName)
        ->setStatusTip(tr("All parameters under a name of your own"));
    preset_menu_->addSeparator();
    preset_menu_->addAction(tr("&Load from a file…"), this, &ParameterForm::loadFile)
        ->setStatusTip(tr("All parameters of a TOML file, in one step that can be undone"));
    preset_menu_->addAction(tr("&Save to a file…"), this, &ParameterForm::saveFile)
        ->setStatusTip(tr("All parameters as a TOML file that echotrail reads, too"));
}

void ParameterForm::askForPresetName() {
    bool chosen = false;
    const QString name = QInputDialog::getText(this, tr("Keep as preset"), tr("Name; one of yours is replaced"),
                                               QLineEdit::Normal, {}, &chosen)
                             .trimmed();
    if (chosen) savePreset(name);
}

void ParameterForm::savePreset(const QString& name) {
    const auto saved = presets_.save(name, model_.infos(), model_.values());
    Q_EMIT message(saved ? tr("All parameters are kept as preset “%1”.").arg(name)
                         : tr("Not kept: %1.").arg(QString::fromStdString(saved.error())),
                   saved.has_value());
}

void ParameterForm::takePreset(const QString& name) {
    auto values = presets_.read(name, model_.infos(), model_.values());
    if (!values) {
        Q_EMIT message(tr("Preset “%1” was not taken. %2.").arg(name, QString::fromStdString(values.error())), false);
        return;
    }
    model_.change(std::move(*values), tr("preset %1").arg(name));
    Q_EMIT message(tr("Preset “%1” is set; Ctrl+Z takes it back.").arg(name), true);
}

void ParameterForm::compareWith(const QString& name) {
    model_.clearReference();
    if (!name.isEmpty()) {
        // What the preset does not mention is compared with the defaults, which are the reference now.
        std::vector<ParameterValue> defaults;
        for (const ParameterInfo& info : model_.infos()) defaults.push_back(info.default_value);
        auto values = presets_.read(name, model_.infos(), std::move(defaults));
        if (!values) {
            Q_EMIT message(tr("“%1” cannot be compared with. %2.").arg(name, QString::fromStdString(values.error())),
                           false);
            return;
        }
        model_.setReference(name, std::move(*values));
        changed_only_->setChecked(true);
    }
    updateButtons();
}

}  // namespace echotrail
