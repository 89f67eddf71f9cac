#pragma once

#include <QSortFilterProxyModel>

namespace echotrail {

/// Shows the parameters that contain every word of a search and, if wanted, only those that
/// differ from their reference, or that are favourites.
class ParameterFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit ParameterFilter(QObject* parent = nullptr);
    void setSearch(const QString& words);
    void setChangedOnly(bool on);
    void setFavouritesOnly(bool on);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QStringList words_;
    bool changed_only_ = false;
    bool favourites_only_ = false;
};

}  // namespace echotrail
