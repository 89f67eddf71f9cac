#pragma once

#include "core/base/parameters.hpp"
#include "core/data/head_settings.hpp"
#include "core/seanet/head_session.hpp"

#include <QWidget>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;

namespace echotrail {

class ParameterSpinBox;

/// The head's settings: what it is to do, in fields, and beside it what it says it does. It changes nothing by itself:
/// what was typed is announced, and what came of it is shown again.
class HeadControls : public QWidget {
    Q_OBJECT

public:
    explicit HeadControls(QWidget* parent = nullptr);
    void showSettings(const HeadSettings& settings);
    /// What the head says; nothing while it has said nothing.
    void showHead(const seanet::HeadStatus& status);

Q_SIGNALS:
    /// `text` as typed, of the parameter called `name`; checked by the receiver, who calls showSettings() at once.
    void edited(const QString& name, const QString& text);

private:
    struct Row {
        ParameterInfo info;
        ParameterSpinBox* number = nullptr;  ///< or
        QComboBox* choice = nullptr;
        QLabel* head = nullptr;
        QLabel* mark = nullptr;
        QString shown;  ///< the value in force
    };
    /// `title` is translated when it is shown.
    void addRow(QGridLayout& grid, const char* title, const std::string& name);
    void addField(Row& row);
    void commit(std::size_t row);
    static void showValue(Row& row);

    std::vector<Row> rows_;
    HeadSettings settings_;
    seanet::HeadStatus head_;
};

}  // namespace echotrail
