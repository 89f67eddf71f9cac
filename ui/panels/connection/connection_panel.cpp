#include "ui/panels/connection/connection_panel.hpp"

#include "core/simulation/simulation_address.hpp"
#include "ui/language/language.hpp"
#include "ui/panels/connection/head_controls.hpp"
#include "ui/panels/connection/recent_links.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/label_role.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <functional>

namespace echotrail {
namespace {

/// Looks for what can be chosen each time it is opened: adapters come and go.
class AddressBox : public QComboBox {
public:
    AddressBox(std::function<void(QComboBox&)> fill, QWidget* parent) : QComboBox(parent), fill_(std::move(fill)) {
        setEditable(true);
        setCompleter(nullptr);  // it would change what is typed
        setInsertPolicy(QComboBox::NoInsert);
        setMinimumContentsLength(12);
        setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    }
    void showPopup() override {
        fill_(*this);
        QComboBox::showPopup();
    }

private:
    std::function<void(QComboBox&)> fill_;
};

/// Such a head brings its vehicle's navigation with it.
bool isSimulated(const QString& address) { return isSimulationAddress(address.trimmed().toStdString()); }

QLabel* wrapped(const char* role, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(role);
    label->setWordWrap(true);
    return label;
}

}  // namespace

QString headStateTitle(seanet::HeadState state) {
    using seanet::HeadState;
    switch (state) {
        case HeadState::NoLink:
            return ConnectionPanel::tr("no link");
        case HeadState::Waiting:
            return ConnectionPanel::tr("waiting for the head");
        case HeadState::Identifying:
            return ConnectionPanel::tr("asking what it is");
        case HeadState::Centring:
            return ConnectionPanel::tr("centring");
        case HeadState::Configuring:
            return ConnectionPanel::tr("sending settings");
        case HeadState::Polling:
            return ConnectionPanel::tr("scanning");
        case HeadState::Silent:
            return ConnectionPanel::tr("head silent");
        case HeadState::WrongDevice:
            return ConnectionPanel::tr("wrong device");
    }
    return {};
}

ConnectionPanel::ConnectionPanel(PipelineBridge& bridge, bool remember, QWidget* parent)
    : QWidget(parent), bridge_(bridge), remember_(remember) {
    column_ = new QVBoxLayout(this);
    column_->setSpacing(UiMetrics(font()).pixels(3.0));
    addLink();
    addState();
    controls_ = new HeadControls(this);
    column_->addWidget(controls_);
    column_->addStretch(1);
    connect(controls_, &HeadControls::edited, this, &ConnectionPanel::headEdited);
    connect(&bridge_, &PipelineBridge::paramsChanged, this,
            [this](const PipelineBridge::Params& params) { controls_->showSettings(params.head); });
    connect(&bridge_, &PipelineBridge::liveChanged, this, &ConnectionPanel::showLive);
    connect(&bridge_, &PipelineBridge::opened, this, &ConnectionPanel::showOpen);
    connect(&bridge_, &PipelineBridge::closed, this, &ConnectionPanel::showOpen);
    controls_->showSettings(bridge_.params().head);
    inEveryLanguage(this, [this] { nameAll(); });
}

void ConnectionPanel::nameAll() {
    const auto name = [](QLabel& label, QComboBox& box, const QString& title) {
        label.setText(title);
        box.setAccessibleName(title);
        box.setToolTip(
            tr("serial:///dev/ttyUSB0?baud=115200, tcp://HOST:PORT or udp://HOST:PORT?listen=PORT; the list has the "
               "last ones, this computer's serial ports and simulated heads"));
    };
    name(*sonar_label_, *sonar_, tr("Sonar"));
    name(*navigation_label_, *navigation_, tr("Navigation"));
    navigation_->lineEdit()->setPlaceholderText(tr("none"));
    record_->setText(tr("Record"));
    record_->setToolTip(tr("Everything is kept, from the first byte, in the folder of recordings"));
    showOpen();
    if (bridge_.isLive()) showLive(bridge_.liveState());
}

QComboBox* ConnectionPanel::addAddress(QLabel*& label) {
    label = new QLabel(this);
    label->setObjectName("dim");
    label->setMinimumWidth(UiMetrics(font()).pixels(64.0));
    auto* box = new AddressBox([this](QComboBox& each) { fill(each); }, this);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(box, 1);
    column_->addLayout(row);
    return box;
}

void ConnectionPanel::addLink() {
    sonar_ = addAddress(sonar_label_);
    navigation_ = addAddress(navigation_label_);
    sonar_->lineEdit()->setPlaceholderText("tcp://HOST:PORT");
    if (remember_) {
        sonar_->setEditText(recentLinks(LinkUse::Sonar).value(0));
        navigation_->setEditText(recentLinks(LinkUse::Navigation).value(0));
    }
    record_ = new QCheckBox(this);
    record_->setChecked(true);
    connect_ = new QPushButton(this);
    auto* row = new QHBoxLayout;
    row->addWidget(record_, 1);
    row->addWidget(connect_);
    column_->addLayout(row);
    connect(connect_, &QPushButton::clicked, this, &ConnectionPanel::toggle);
    connect(sonar_, &QComboBox::editTextChanged, navigation_,
            [this](const QString& address) { navigation_->setEnabled(!bridge_.isLive() && !isSimulated(address)); });
    for (QComboBox* box : {sonar_, navigation_})
        connect(box->lineEdit(), &QLineEdit::returnPressed, this, [this] {
            if (!bridge_.isLive()) toggle();
        });
}

void ConnectionPanel::addState() {
    state_ = wrapped("title", this);
    identity_ = wrapped("dim", this);
    advice_ = wrapped("refusal", this);
    counts_ = wrapped("dim", this);
    for (QLabel* label : {state_, identity_, advice_, counts_}) column_->addWidget(label);
}

void ConnectionPanel::fill(QComboBox& box) const {
    const QString typed = box.currentText();
    QStringList links;
    if (remember_) links = recentLinks(&box == sonar_ ? LinkUse::Sonar : LinkUse::Navigation);
    for (const QString& port : bridge_.livePorts())
        if (!links.contains(port)) links << port;
    box.clear();
    box.addItems(links);
    if (&box == sonar_) addSimulatedHeads(box);
    box.setEditText(typed);
}

void ConnectionPanel::addSimulatedHeads(QComboBox& box) const {
    if (box.count() > 0) box.insertSeparator(box.count());
    for (const SimulatedHeadChoice& head : bridge_.simulatedHeads()) {
        if (box.findText(head.address) >= 0) continue;
        box.addItem(head.address);
        box.setItemData(box.count() - 1, head.description, Qt::ToolTipRole);
    }
}

void ConnectionPanel::focusAddress() {
    sonar_->setFocus(Qt::OtherFocusReason);
    sonar_->lineEdit()->selectAll();
}

bool ConnectionPanel::records() const { return record_->isChecked(); }

void ConnectionPanel::toggle() {
    if (bridge_.isLive()) return bridge_.close();
    const QString sonar = sonar_->currentText().trimmed();
    connectTo(sonar, isSimulated(sonar) ? QString() : navigation_->currentText().trimmed(), record_->isChecked());
}

void ConnectionPanel::connectTo(const QString& sonar, const QString& navigation, bool record) {
    sonar_->setEditText(sonar);
    if (!isSimulated(sonar)) navigation_->setEditText(navigation);  // else kept for the next real head
    record_->setChecked(record);
    bridge_.openLive(sonar, navigation, record);
    if (!bridge_.isLive() || !remember_) return;
    rememberLink(LinkUse::Sonar, sonar);
    if (!navigation.isEmpty()) rememberLink(LinkUse::Navigation, navigation);
}

void ConnectionPanel::showOpen() {
    const bool live = bridge_.isLive();
    for (QWidget* field : std::initializer_list<QWidget*>{sonar_, record_}) field->setEnabled(!live);
    navigation_->setEnabled(!live && !isSimulated(sonar_->currentText()));
    connect_->setText(live ? tr("Disconnect") : tr("Connect"));
    connect_->setEnabled(live || bridge_.canGoLive());
    if (live) return;
    state_->setText(tr("not connected"));
    for (QLabel* label : {identity_, advice_, counts_}) label->hide();
    controls_->showHead({});
    Q_EMIT summaryChanged(tr("not connected"));
}

void ConnectionPanel::showLive(const LiveState& state) {
    const auto show = [](QLabel& label, const QString& text) {
        label.setText(text);
        label.setVisible(!text.isEmpty());
    };
    const QString title = headStateTitle(state.head.state);
    state_->setText(title);
    show(*identity_, QString::fromStdString(state.head.head));
    QStringList advice;
    if (state.tracker && !state.tracker->link.up && !state.tracker->link.reason.isEmpty())
        advice << tr("tracker: %1; trying again").arg(state.tracker->link.reason);
    if (!state.sonar.up && !state.sonar.reason.isEmpty()) advice << state.sonar.reason + tr("; trying again");
    if (state.navigation && !state.navigation->up && !state.navigation->reason.isEmpty())
        advice << tr("navigation: %1; trying again").arg(state.navigation->reason);
    if (state.sonar.up && !state.head.advice.empty()) advice << QString::fromStdString(state.head.advice);
    show(*advice_, advice.join('\n'));
    showCounts(state);
    controls_->showHead(state.head);
    Q_EMIT summaryChanged(title);
}

void ConnectionPanel::showCounts(const LiveState& state) {
    const seanet::HeadStatus& head = state.head;
    QStringList parts{tr("%1 pings").arg(Formatter::count(head.pings))};
    const auto add = [&parts](const QString& what, std::uint64_t number) {
        if (number > 0) parts << what.arg(Formatter::count(number));
    };
    add(tr("%1 timeouts"), head.timeouts);
    add(tr("%1 repeats"), head.retries);
    add(tr("%1 resets of the head"), head.head_resets);
    add(tr("%1 rejected"), head.rejected);
    add(tr("%1 skipped"), state.run.skipped);
    counts_->setText(parts.join(QStringLiteral(" · ")));
    counts_->setVisible(state.sonar.up || head.pings > 0);
}

}  // namespace echotrail
