#pragma once

#include "ui/bridge/pipeline_bridge.hpp"
#include "ui/forms/parameter_form.hpp"

#include <QWidget>

namespace echotrail {

/// The parameters of the running pipeline: a change in the form becomes one whole, validated value for the runner.
class ParameterPanel : public QWidget {
    Q_OBJECT

public:
    /// The bridge is not owned and must outlive the panel.
    explicit ParameterPanel(PipelineBridge& bridge, QWidget* parent = nullptr);

    ParameterForm& form() { return *form_; }
    ParameterModel& model() { return model_; }
    /// Shows what the bridge was given from elsewhere, e.g. the command line.
    void showParams();
    /// As if `text` had been typed into the field of the parameter called `name`.
    void enter(const QString& name, const QString& text);
    /// Favourites are kept in the settings from now on.
    void rememberFavourites();

Q_SIGNALS:
    void message(const QString& text, bool ok);
    /// "3 changed", for the dock's title.
    void summaryChanged(const QString& summary);

private:
    void apply(const std::vector<ParameterValue>& values);
    void makeForm();
    void summarise();
    /// Tells the form once what was sent is in force.
    void followSent();

    PipelineBridge& bridge_;
    ParameterModel model_;
    ParameterForm* form_ = nullptr;
};

}  // namespace echotrail
