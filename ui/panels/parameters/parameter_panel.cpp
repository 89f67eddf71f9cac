#include "ui/panels/parameters/parameter_panel.hpp"

#include <QVBoxLayout>

namespace echotrail {

ParameterPanel::ParameterPanel(PipelineBridge& bridge, QWidget* parent)
    : QWidget(parent), bridge_(bridge), model_(describeParameters<PipelineBridge::Params>()) {
    form_ = new ParameterForm(model_, this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(form_);
    connect(&model_, &ParameterModel::valuesChanged, this, &ParameterPanel::apply);
    connect(form_, &ParameterForm::message, this, &ParameterPanel::message);
    showParams();
}

void ParameterPanel::showParams() {
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
    summarise();
}

void ParameterPanel::summarise() {
    const int changed = model_.changedCount();
    Q_EMIT summaryChanged(changed == 0 ? tr("all at their defaults") : tr("%n changed", nullptr, changed));
}

}  // namespace echotrail
