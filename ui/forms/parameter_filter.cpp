#include "ui/forms/parameter_filter.hpp"

#include "ui/forms/parameter_model.hpp"

#include <algorithm>

namespace echotrail {

ParameterFilter::ParameterFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setRecursiveFilteringEnabled(true);
}

void ParameterFilter::setSearch(const QString& words) {
    words_ = words.split(' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

void ParameterFilter::setChangedOnly(bool on) {
    changed_only_ = on;
    invalidateFilter();
}

void ParameterFilter::setFavouritesOnly(bool on) {
    favourites_only_ = on;
    invalidateFilter();
}

bool ParameterFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    if (!index.data(ParameterModel::IsParameter).toBool()) return false;  // a stage shows when something in it does
    // What was refused stays in sight: hiding it would hide the reason.
    if (changed_only_ && !index.data(ParameterModel::Changed).toBool() &&
        index.data(ParameterModel::Refusal).toString().isEmpty())
        return false;
    if (favourites_only_ && !index.data(ParameterModel::Favourite).toBool()) return false;
    const QString text = index.data(ParameterModel::SearchText).toString();
    return std::all_of(words_.begin(), words_.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace echotrail
