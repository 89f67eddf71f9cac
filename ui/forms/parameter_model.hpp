#pragma once

#include "core/base/parameters.hpp"

#include <QAbstractItemModel>
#include <QUndoStack>
#include <vector>

namespace echotrail {

/// Described parameters as a tree: stages, and under each its parameters. It knows no pipeline: a change that passed
/// the limits is announced, and whoever listens applies it.
class ParameterModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { Name, Default, Value, Unit, Star, State, column_count };
    enum Role {
        Limits = Qt::UserRole,  ///< "3 … 40 dB" or the choices
        Changed,                ///< whether the value differs from the reference; of a stage: how many do
        Refusal,                ///< why the last typed value was not taken; empty when it was
        SearchText,             ///< everything a search may hit
        PlainName,              ///< as in files and on the command line
        IsParameter,            ///< false for a stage
        Choices,                ///< QStringList, only of a choice
        Kind,                   ///< ParameterKind as int
        Minimum,
        Maximum,
        Favourite,    ///< the operator wants it at hand
        ProgressRole  ///< Progress as int
    };
    /// How far a change of this session has come.
    enum class Progress { None, Sent, InForce };
    enum class ParameterKind { Stage, Flag, Whole, Real, Choice };

    explicit ParameterModel(std::vector<ParameterInfo> infos, QObject* parent = nullptr);

    const std::vector<ParameterInfo>& infos() const { return infos_; }
    const std::vector<ParameterValue>& values() const { return values_; }
    const ParameterInfo* info(const QModelIndex& index) const;  ///< null for a stage
    QModelIndex indexOf(std::size_t parameter, int column = Value) const;
    int changedCount() const;
    int sentCount() const;
    /// What changes have been sent is in force; `known` false: nothing is there to say so.
    void confirmSent(bool known = true);
    /// What values are compared with, and go back to: a preset, or the defaults where the name is empty.
    void setReference(const QString& name, std::vector<ParameterValue> values);
    void clearReference();
    const QString& referenceName() const { return reference_name_; }
    void setFavourite(const QModelIndex& index, bool on);
    QStringList favourites() const;  ///< as in files
    void setFavourites(const QStringList& names);
    QUndoStack& undoStack() { return undo_; }

    /// Takes over a whole set from outside, e.g. the command line: not announced, the undo history is emptied. What was
    /// sent and is not among them was not taken.
    void showValues(std::vector<ParameterValue> values);
    /// A change of several parameters as one step of the undo history. Values must have passed their limits.
    void change(std::vector<ParameterValue> values, const QString& title);
    void reset(const QModelIndex& index);
    void resetAll();

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Typed text (EditRole) or a check state of a flag. Refused text changes nothing but the row's Refusal.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

Q_SIGNALS:
    /// The whole set after a change that passed its limits.
    void valuesChanged(const std::vector<echotrail::ParameterValue>& values);
    void refused(const QString& reason);
    void favouritesChanged();

private:
    friend class ParameterChange;
    struct Stage {
        QString name;
        std::size_t first = 0;
        std::size_t count = 0;
    };

    void announceAll();
    void assign(const std::vector<ParameterValue>& values);
    std::size_t parameterOf(const QModelIndex& index) const;
    QVariant stageData(const Stage& stage, int column, int role) const;
    QVariant parameterData(std::size_t parameter, int column, int role) const;
    QString displayText(std::size_t parameter, int column) const;
    QString stateText(std::size_t parameter) const;
    bool isChanged(std::size_t parameter) const;
    ParameterKind kind(std::size_t parameter) const;
    void refuse(std::size_t parameter, const QString& reason);

    std::vector<ParameterInfo> infos_;
    std::vector<ParameterValue> values_;
    std::vector<QString> refusals_;
    std::vector<Progress> progress_;
    std::vector<bool> favourite_;
    std::vector<ParameterValue> reference_;
    QString reference_name_;
    std::vector<Stage> stages_;
    QUndoStack undo_;
};

/// "seed_db" becomes "Seed": words for the eye, the unit has a column of its own.
QString readableName(const ParameterInfo& info);
/// "2 … 450 m", "low, high" or nothing.
QString limitsText(const ParameterInfo& info);
/// The value as shown: true minus, grouped thousands; "on" and "off" for a flag.
QString shownValue(const ParameterValue& value);

}  // namespace echotrail
