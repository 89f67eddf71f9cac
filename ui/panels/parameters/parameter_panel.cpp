#include "ui/panels/parameters/parameter_panel.hpp"

#include "core/pipelines/presets.hpp"
#include "ui/language/language.hpp"

#include <QSettings>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace echotrail {
namespace {

constexpr auto favourites_setting = "favourite_parameters";

ParameterPresets allPresets() {
    std::vector<ParameterPresets::BuiltIn> built_in;
    for (const Preset& preset : presets())
        built_in.push_back({QString::fromUtf8(preset.name.data(), static_cast<qsizetype>(preset.name.size())),
                            std::string(preset.toml)});
    return {std::move(built_in),
            QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/echotrail/presets"};
}

}  // namespace

ParameterPanel::ParameterPanel(PipelineBridge& bridge, QWidget* parent)
    : QWidget(parent), bridge_(bridge), model_(describeParameters<PipelineBridge::Params>()) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    connect(&model_, &ParameterModel::valuesChanged, this, &ParameterPanel::apply);
    connect(&model_, &QAbstractItemModel::headerDataChanged, this, &ParameterPanel::summarise);
    inEveryLanguage(this, [this] { makeForm(); });
    connect(&bridge_, &PipelineBridge::statusChanged, this, &ParameterPanel::followSent);
    connect(&bridge_, &PipelineBridge::liveChanged, this, &ParameterPanel::followSent);
    showParams();
}

/// The model keeps all that matters; a form in another language is another form.
void ParameterPanel::makeForm() {
    delete form_;
    form_ = new ParameterForm(model_, allPresets(), this);
    layout()->addWidget(form_);
    connect(form_, &ParameterForm::message, this, &ParameterPanel::message);
    summarise();
}

void ParameterPanel::showParams() {
    if (!bridge_.isTracker()) model_.confirmSent(false);  // another source's: nobody refused them
    model_.showValues(parameterValues(bridge_.params()));
    summarise();
}

void ParameterPanel::enter(const QString& name, const QString& text) {
    const auto& infos = model_.infos();
    for (std::size_t i = 0; i < infos.size(); ++i)
        if (infos[i].name == name.toStdString()) model_.setData(model_.indexOf(i), text);
}

void ParameterPanel::apply(const std::vector<ParameterValue>& values) {
    PipelineBridge::Params params = bridge_.params();
    const auto& infos = model_.infos();
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const auto set = setParameter(params, infos[i].name, values[i]);
        Q_ASSERT_X(set.has_value(), "ParameterPanel", "the model lets only checked values through");
        if (!set) return Q_EMIT message(QString::fromStdString(set.error()), false);
    }
    bridge_.setParams(params);
    followSent();
    summarise();
}

void ParameterPanel::followSent() {
    if (model_.sentCount() == 0) return;
    if (!bridge_.isOpen()) return model_.confirmSent(false);
    if (bridge_.paramsInForce()) model_.confirmSent();
}

void ParameterPanel::rememberFavourites() {
    model_.setFavourites(QSettings().value(favourites_setting).toStringList());
    connect(&model_, &ParameterModel::favouritesChanged, this,
            [this] { QSettings().setValue(favourites_setting, model_.favourites()); });
}

void ParameterPanel::summarise() {
    const int changed = model_.changedCount();
    if (!model_.referenceName().isEmpty())
        return Q_EMIT summaryChanged(tr("%1 unlike %2").arg(changed).arg(model_.referenceName()));
    Q_EMIT summaryChanged(changed == 0 ? tr("all at their defaults") : tr("%n changed", nullptr, changed));
}

}  // namespace echotrail
