#pragma once

#include <QString>
#include <vector>

class QMenuBar;

namespace echotrail {

/// A library that the program uses.
struct LibraryNotice {
    QString name, version, licence, purpose;
};

// What the program says about itself in the manual, in Markdown: it cannot be out of date.

/// Every parameter by its group: unit, limits, default, help.
QString parameterReference();
/// Every entry of the menus with its key and what it does.
QString keyReference(const QMenuBar& menus);
/// Page "about": versions and licences.
QString aboutPage(const QString& version, const std::vector<LibraryNotice>& libraries);
/// Page "licence": the whole text.
QString licencePage();

}  // namespace echotrail
