#include "ui/panels/connection/head_controls.hpp"

#include "ui/forms/parameter_spin_box.hpp"
#include "ui/language/language.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/label_role.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <array>
#include <cmath>

namespace echotrail {
namespace {

constexpr auto unheard = "sound_speed";  ///< a head neither takes nor tells it

QString plainText(const ParameterValue& value) { return QString::fromStdString(ParameterInfo::toText(value)); }

/// A head counts in units of its own, so its figures are rounded for reading.
QString headText(const ParameterInfo& info, ParameterValue value) {
    if (double* number = std::get_if<double>(&value)) *number = std::round(*number * 100.0) / 100.0;
    if (info.unit.empty()) return plainText(value);
    return plainText(value) + (info.unit == "deg" ? QStringLiteral("°") : " " + QString::fromStdString(info.unit));
}

}  // namespace

HeadControls::HeadControls(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->setVerticalSpacing(UiMetrics(font()).pixels(2.0));
    grid->setColumnStretch(1, 1);
    const std::array heads{QT_TR_NOOP("Setting"), QT_TR_NOOP("Command"), QT_TR_NOOP("Head says")};
    for (int column = 0; column < static_cast<int>(heads.size()); ++column) {
        auto* head = new QLabel(this);
        head->setObjectName("dim");
        inEveryLanguage(head, [head, words = heads[static_cast<std::size_t>(column)]] { head->setText(tr(words)); });
        grid->addWidget(head, 0, column, column == 2 ? Qt::AlignRight : Qt::AlignLeft);
    }
    addRow(*grid, QT_TR_NOOP("Range"), "range_m");
    addRow(*grid, QT_TR_NOOP("Sector"), "sector_width_deg");
    addRow(*grid, QT_TR_NOOP("Centre"), "sector_centre_deg");
    addRow(*grid, QT_TR_NOOP("Step"), "step_deg");
    addRow(*grid, QT_TR_NOOP("Gain"), "gain_percent");
    addRow(*grid, QT_TR_NOOP("Channel"), "channel");
    addRow(*grid, QT_TR_NOOP("Bits"), "bits");
    addRow(*grid, QT_TR_NOOP("Sound, m/s"), unheard);
    showSettings({});
    inEveryLanguage(this, [this] { showHead(head_); });
}

void HeadControls::addRow(QGridLayout& grid, const char* title, const std::string& name) {
    static const auto infos = describeParameters<HeadSettings>();
    const auto info = std::find_if(infos.begin(), infos.end(), [&](const auto& each) { return each.name == name; });
    Q_ASSERT(info != infos.end());
    Row row{.info = *info, .head = new QLabel(this), .mark = new QLabel(this)};
    addField(row);
    row.mark->setMinimumWidth(fontMetrics().height());
    const int line = static_cast<int>(rows_.size()) + 1;
    auto* label = new QLabel(this);
    label->setToolTip(QString::fromStdString(info->help));
    QWidget* field = row.number ? static_cast<QWidget*>(row.number) : row.choice;
    inEveryLanguage(label, [label, field, title] {
        label->setText(tr(title));
        field->setAccessibleName(tr(title));
    });
    grid.addWidget(label, line, 0);
    grid.addWidget(field, line, 1);
    grid.addWidget(row.head, line, 2, Qt::AlignRight);
    grid.addWidget(row.mark, line, 3);
    rows_.push_back(std::move(row));
}

void HeadControls::addField(Row& row) {
    const std::size_t place = rows_.size();
    const auto done = [this, place] { commit(place); };
    QStringList choices;
    for (const std::string& choice : row.info.choices) choices << QString::fromStdString(choice);
    if (row.info.name == "bits") choices = QStringList{"4", "8"};  // a head knows no others
    if (choices.isEmpty()) {
        row.number = new ParameterSpinBox(row.info.minimum, row.info.maximum, false, this);
        row.number->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        row.number->setMinimumWidth(UiMetrics(font()).pixels(58.0));
        row.number->setToolTip(QString("%1 … %2 %3")
                                   .arg(row.info.minimum)
                                   .arg(row.info.maximum)
                                   .arg(QString::fromStdString(row.info.unit)));
        connect(row.number, &QAbstractSpinBox::editingFinished, this, done);
        connect(row.number, &ParameterSpinBox::stepped, this, done);
    } else {
        row.choice = new QComboBox(this);
        row.choice->addItems(choices);
        row.choice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        row.choice->setMinimumWidth(UiMetrics(font()).pixels(58.0));
        connect(row.choice, &QComboBox::activated, this, done);
    }
}

void HeadControls::commit(std::size_t place) {
    Row& row = rows_[place];
    const QString typed = row.number ? row.number->typedText() : row.choice->currentText();
    if (typed != row.shown) Q_EMIT edited(QString::fromStdString(row.info.name), typed);
    showValue(row);  // the old one again where the new one was refused
}

void HeadControls::showValue(Row& row) {
    if (row.number) {
        if (row.number->typedText() != row.shown) row.number->setTypedText(row.shown);
    } else {
        const QSignalBlocker quiet(row.choice);
        row.choice->setCurrentIndex(row.choice->findText(row.shown));
    }
}

void HeadControls::showSettings(const HeadSettings& settings) {
    settings_ = settings;
    for (Row& row : rows_) {
        const QString text = plainText(parameter(settings, row.info.name).value());
        if (text == row.shown) continue;  // what is being typed stays
        row.shown = text;
        showValue(row);
    }
}

void HeadControls::showHead(const seanet::HeadStatus& status) {
    head_ = status;
    for (Row& row : rows_) {
        if (!status.confirmed || row.info.name == unheard) {
            row.head->setText(row.info.name == unheard && status.confirmed ? tr("used here") : Formatter::unknown());
            row.mark->setText(status.confirmed ? QString() : QStringLiteral("–"));
            setLabelRole(*row.head, "dim");
            setLabelRole(*row.mark, "dim");
            continue;
        }
        const QString says = headText(row.info, parameter(*status.confirmed, row.info.name).value());
        // The session knows what a head rounds: without a difference all is as commanded.
        const bool same =
            status.difference.empty() || says == headText(row.info, parameter(settings_, row.info.name).value());
        row.head->setText(says);
        row.mark->setText(same ? QStringLiteral("✓") : QStringLiteral("…"));
        row.mark->setToolTip(same ? tr("The head does as commanded") : tr("Sent; the head has not confirmed it"));
        setLabelRole(*row.head, same ? "dim" : "staged");
        setLabelRole(*row.mark, same ? "good" : "staged");
    }
}

}  // namespace echotrail
