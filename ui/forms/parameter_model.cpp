#include "ui/forms/parameter_model.hpp"

#include <QUndoCommand>
#include <algorithm>
#include <cmath>
#include <utility>

namespace echotrail {

/// One step of the history. It holds whole sets: a few hundred numbers, and nothing can get out of step.
class ParameterChange : public QUndoCommand {
public:
    ParameterChange(ParameterModel& model, std::vector<ParameterValue> after, const QString& title)
        : QUndoCommand(title), model_(model), before_(model.values()), after_(std::move(after)) {}
    void undo() override { model_.assign(before_); }
    void redo() override { model_.assign(after_); }

private:
    ParameterModel& model_;
    std::vector<ParameterValue> before_;
    std::vector<ParameterValue> after_;
};

namespace {

constexpr quintptr stage_id = 0;  // of a parameter: 1 + the number of its stage

QString text(const std::string& plain) { return QString::fromStdString(plain); }

}  // namespace

QString readableName(const ParameterInfo& info) {
    QStringList words = text(info.name).split('_');
    static const std::vector<std::pair<QString, std::string>> suffixes{
        {"m", "m"},   {"db", "dB"}, {"deg", "deg"}, {"s", "s"},       {"ms", "ms"},         {"percent", "%"},
        {"hz", "Hz"}, {"m2", "m²"}, {"mps", "m/s"}, {"mps2", "m/s²"}, {"pixels", "pixels"}, {"percent", "% of range"}};
    for (const auto& [word, unit] : suffixes) {
        if (words.size() < 2 || words.back() != word || info.unit != unit) continue;
        words.removeLast();
        break;
    }
    QString name = words.join(' ');
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

QString shownValue(const ParameterValue& value) {
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag ? ParameterModel::tr("on") : ParameterModel::tr("off");
    QString shown = text(ParameterInfo::toText(value));
    if (std::holds_alternative<std::string>(value)) return shown;
    shown.replace('-', QChar(0x2212));
    const auto digits = shown.indexOf('.') < 0 ? shown.size() : shown.indexOf('.');
    if (shown.contains('e')) return shown;
    for (auto at = digits - 3; at > 0 && shown[at - 1].isDigit(); at -= 3)
        if (digits > 4) shown.insert(at, QChar(0x202F));
    return shown;
}

QString limitsText(const ParameterInfo& info) {
    if (!info.choices.empty()) {
        QStringList choices;
        for (const std::string& choice : info.choices) choices << text(choice);
        return choices.join(", ");
    }
    if (std::holds_alternative<bool>(info.default_value)) return {};
    const QString unit = info.unit == "deg" ? QStringLiteral("°") : text(info.unit);
    return shownValue(info.minimum) + QStringLiteral(" … ") + shownValue(info.maximum) + (unit.isEmpty() ? "" : " ") +
           unit;
}

ParameterModel::ParameterModel(std::vector<ParameterInfo> infos, QObject* parent)
    : QAbstractItemModel(parent),
      infos_(std::move(infos)),
      refusals_(infos_.size()),
      progress_(infos_.size()),
      favourite_(infos_.size()) {
    for (std::size_t i = 0; i < infos_.size(); ++i) {
        values_.push_back(infos_[i].default_value);
        const QString group = text(infos_[i].group);
        if (stages_.empty() || stages_.back().name != group) stages_.push_back({group, i, 0});
        ++stages_.back().count;
    }
    reference_ = values_;
}

QModelIndex ParameterModel::indexOf(std::size_t parameter, int column) const {
    for (std::size_t stage = 0; stage < stages_.size(); ++stage)
        if (parameter < stages_[stage].first + stages_[stage].count)
            return createIndex(static_cast<int>(parameter - stages_[stage].first), column, stage + 1);
    return {};
}

std::size_t ParameterModel::parameterOf(const QModelIndex& index) const {
    return stages_[index.internalId() - 1].first + static_cast<std::size_t>(index.row());
}

const ParameterInfo* ParameterModel::info(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == stage_id) return nullptr;
    return &infos_[parameterOf(index)];
}

int ParameterModel::changedCount() const {
    int count = 0;
    for (std::size_t i = 0; i < infos_.size(); ++i) count += isChanged(i) ? 1 : 0;
    return count;
}

void ParameterModel::showValues(std::vector<ParameterValue> values) {
    Q_ASSERT(values.size() == infos_.size());
    undo_.clear();
    for (std::size_t i = 0; i < infos_.size(); ++i) {
        const bool taken = progress_[i] != Progress::Sent || values[i] == values_[i];
        refusals_[i] = taken ? QString() : tr("%1 was not taken by the tracker").arg(shownValue(values_[i]));
        progress_[i] = taken && progress_[i] == Progress::Sent ? Progress::InForce : Progress::None;
    }
    values_ = std::move(values);
    announceAll();
}

void ParameterModel::announceAll() {
    for (int stage = 0; stage < rowCount(); ++stage) {
        const QModelIndex parent = index(stage, 0);
        Q_EMIT dataChanged(index(0, 0, parent), index(rowCount(parent) - 1, column_count - 1, parent));
        Q_EMIT dataChanged(parent, index(stage, column_count - 1));
    }
}

void ParameterModel::change(std::vector<ParameterValue> values, const QString& title) {
    if (values == values_) return;
    undo_.push(new ParameterChange(*this, std::move(values), title));
}

void ParameterModel::assign(const std::vector<ParameterValue>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values_[i] == values[i] && refusals_[i].isEmpty()) continue;
        values_[i] = values[i];
        refusals_[i].clear();
        progress_[i] = Progress::Sent;
        const QModelIndex stage = indexOf(i).parent();
        Q_EMIT dataChanged(indexOf(i, 0), indexOf(i, column_count - 1));
        Q_EMIT dataChanged(stage, stage.siblingAtColumn(column_count - 1));
    }
    Q_EMIT valuesChanged(values_);
}

void ParameterModel::reset(const QModelIndex& index) {
    if (!info(index)) return;
    auto values = values_;
    values[parameterOf(index)] = reference_[parameterOf(index)];
    const QString name = readableName(*info(index));
    change(std::move(values), reference_name_.isEmpty() ? tr("%1 to its default").arg(name)
                                                        : tr("%1 as in %2").arg(name, reference_name_));
}

void ParameterModel::resetAll() {
    change(reference_,
           reference_name_.isEmpty() ? tr("all to their defaults") : tr("all as in %1").arg(reference_name_));
}

void ParameterModel::setReference(const QString& name, std::vector<ParameterValue> values) {
    Q_ASSERT(values.size() == infos_.size());
    reference_ = std::move(values);
    reference_name_ = name;
    Q_EMIT headerDataChanged(Qt::Horizontal, Default, Default);
    announceAll();
}

void ParameterModel::clearReference() {
    std::vector<ParameterValue> defaults;
    for (const ParameterInfo& info : infos_) defaults.push_back(info.default_value);
    setReference({}, std::move(defaults));
}

int ParameterModel::sentCount() const {
    return static_cast<int>(std::count(progress_.begin(), progress_.end(), Progress::Sent));
}

void ParameterModel::confirmSent(bool known) {
    for (std::size_t i = 0; i < infos_.size(); ++i) {
        if (progress_[i] != Progress::Sent) continue;
        progress_[i] = known ? Progress::InForce : Progress::None;
        Q_EMIT dataChanged(indexOf(i, 0), indexOf(i, column_count - 1));
    }
}

void ParameterModel::setFavourite(const QModelIndex& index, bool on) {
    if (!info(index)) return;
    favourite_[parameterOf(index)] = on;
    Q_EMIT dataChanged(index.siblingAtColumn(0), index.siblingAtColumn(column_count - 1));
    Q_EMIT favouritesChanged();
}

QStringList ParameterModel::favourites() const {
    QStringList names;
    for (std::size_t i = 0; i < infos_.size(); ++i)
        if (favourite_[i]) names << text(infos_[i].name);
    return names;
}

void ParameterModel::setFavourites(const QStringList& names) {
    for (std::size_t i = 0; i < infos_.size(); ++i) favourite_[i] = names.contains(text(infos_[i].name));
    announceAll();
}

QModelIndex ParameterModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : stage_id);
}

QModelIndex ParameterModel::parent(const QModelIndex& child) const {
    if (!child.isValid() || child.internalId() == stage_id) return {};
    return createIndex(static_cast<int>(child.internalId() - 1), 0, stage_id);
}

int ParameterModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return static_cast<int>(stages_.size());
    if (parent.internalId() != stage_id || parent.column() != 0) return 0;
    return static_cast<int>(stages_[static_cast<std::size_t>(parent.row())].count);
}

int ParameterModel::columnCount(const QModelIndex&) const { return column_count; }

ParameterModel::ParameterKind ParameterModel::kind(std::size_t parameter) const {
    const ParameterInfo& info = infos_[parameter];
    if (!info.choices.empty()) return ParameterKind::Choice;
    if (std::holds_alternative<bool>(info.default_value)) return ParameterKind::Flag;
    return std::holds_alternative<int>(info.default_value) ? ParameterKind::Whole : ParameterKind::Real;
}

bool ParameterModel::isChanged(std::size_t parameter) const { return values_[parameter] != reference_[parameter]; }

QVariant ParameterModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    if (index.internalId() == stage_id)
        return stageData(stages_[static_cast<std::size_t>(index.row())], index.column(), role);
    return parameterData(parameterOf(index), index.column(), role);
}

QVariant ParameterModel::stageData(const Stage& stage, int column, int role) const {
    if (role == IsParameter) return false;
    if (role == Kind) return static_cast<int>(ParameterKind::Stage);
    int changed = 0;
    for (std::size_t i = stage.first; i < stage.first + stage.count; ++i) changed += isChanged(i) ? 1 : 0;
    if (role == Changed) return changed;
    if (column != Name) return {};
    if (role == Qt::DisplayRole || role == Qt::AccessibleTextRole) return stage.name;
    return {};
}

QVariant ParameterModel::parameterData(std::size_t parameter, int column, int role) const {
    const ParameterInfo& info = infos_[parameter];
    switch (role) {
        case Qt::DisplayRole:
            return displayText(parameter, column);
        case Qt::EditRole:
            return text(ParameterInfo::toText(values_[parameter]));
        case Qt::CheckStateRole:
            if (column != Value || kind(parameter) != ParameterKind::Flag) return {};
            return std::get<bool>(values_[parameter]) ? Qt::Checked : Qt::Unchecked;
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(column == Value || column == Default ? Qt::AlignRight | Qt::AlignVCenter
                                                                            : Qt::AlignLeft | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return QStringLiteral("<p><b>%1</b><br>%2</p><p>%3</p>")
                .arg(text(info.name), text(info.help).toHtmlEscaped(),
                     tr("Default %1 %2. Takes effect at the next %3.")
                         .arg(shownValue(info.default_value), text(info.unit),
                              info.effect == Effect::NextPing ? tr("ping") : tr("sweep")));
        case Limits:
            return limitsText(info);
        case Changed:
            return isChanged(parameter);
        case Refusal:
            return refusals_[parameter];
        case Qt::AccessibleTextRole:
            if (column == Star) return favourite_[parameter] ? tr("favourite") : tr("no favourite");
            return displayText(parameter, column);
        case SearchText:
            return text(info.name + " " + info.group + " " + info.help) + " " + readableName(info);
        case PlainName:
            return text(info.name);
        case IsParameter:
            return true;
        case Kind:
            return static_cast<int>(kind(parameter));
        case Favourite:
            return static_cast<bool>(favourite_[parameter]);
        case ProgressRole:
            return static_cast<int>(progress_[parameter]);
        case Minimum:
            return info.minimum;
        case Maximum:
            return info.maximum;
        case Choices: {
            QStringList choices;
            for (const std::string& choice : info.choices) choices << text(choice);
            return choices;
        }
        default:
            return {};
    }
}

QString ParameterModel::displayText(std::size_t parameter, int column) const {
    const ParameterInfo& info = infos_[parameter];
    switch (column) {
        case Name:
            return readableName(info);
        case Default:
            return shownValue(reference_[parameter]);
        case Value:
            return shownValue(values_[parameter]);
        case Unit:
            return info.unit == "deg" ? QStringLiteral("°") : text(info.unit);
        case State:
            return stateText(parameter);
        default:
            return {};
    }
}

QString ParameterModel::stateText(std::size_t parameter) const {
    if (!refusals_[parameter].isEmpty()) return QStringLiteral("✕ ") + tr("refused");
    if (progress_[parameter] == Progress::Sent) return QStringLiteral("… ") + tr("sent");
    if (progress_[parameter] == Progress::InForce) return QStringLiteral("✓ ") + tr("in force");
    return isChanged(parameter) ? tr("changed") : QString();
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(section == Value || section == Default ? Qt::AlignRight | Qt::AlignVCenter
                                                                          : Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    const QString reference = reference_name_.isEmpty() ? tr("Default") : reference_name_;
    const QStringList titles{tr("Name"), reference, tr("Value"), tr("Unit"), QString(), tr("State")};
    return titles.value(section);
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.internalId() == stage_id || index.column() != Value) return flags;
    return flags | (kind(parameterOf(index)) == ParameterKind::Flag ? Qt::ItemIsUserCheckable : Qt::ItemIsEditable);
}

bool ParameterModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!info(index) || index.column() != Value) return false;
    const std::size_t parameter = parameterOf(index);
    const ParameterInfo& described = infos_[parameter];
    QString typed = value.toString().trimmed();
    if (role == Qt::CheckStateRole)
        typed = value.toInt() == Qt::Checked ? QStringLiteral("true") : QStringLiteral("false");
    else if (role != Qt::EditRole)
        return false;
    if (described.choices.empty()) {  // as people type numbers
        typed.replace(QChar(0x2212), '-').remove(QChar(0x202F)).remove(' ');
        if (typed.count(',') == 1 && !typed.contains('.')) typed.replace(',', '.');
    }
    const auto read = described.fromText(typed.toStdString());
    if (!read) {
        refuse(parameter, text(read.error()));
        return false;
    }
    if (*read == values_[parameter]) {
        refuse(parameter, {});
        return true;
    }
    auto values = values_;
    values[parameter] = *read;
    change(std::move(values), tr("%1 to %2").arg(readableName(described), shownValue(*read)));
    return true;
}

void ParameterModel::refuse(std::size_t parameter, const QString& reason) {
    if (refusals_[parameter] == reason && reason.isEmpty()) return;
    refusals_[parameter] = reason;
    Q_EMIT dataChanged(indexOf(parameter, 0), indexOf(parameter, column_count - 1));
    if (!reason.isEmpty()) Q_EMIT refused(reason);
}

}  // namespace echotrail
