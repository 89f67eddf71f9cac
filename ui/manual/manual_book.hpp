#pragma once

#include "ui/language/language.hpp"

#include <QList>
#include <QString>

namespace echotrail {

/// A page of the manual, in Markdown; its first line is its title.
struct ManualPage {
    QString name;  ///< as docks are called: "tracks", "parameters", …
    QString text;

    QString title() const;
};

/// Where words were found.
struct ManualHit {
    QString page;
    QString title;
    QString excerpt;  ///< the paragraph's beginning, without marks
};

/// The manual in one language: pages written by hand (resources/manual), and what the program adds about itself.
class ManualBook {
public:
    explicit ManualBook(Language language);
    /// To the end of the page of this name, or as a new page, whose first line is then its title.
    void add(const QString& name, const QString& text);
    const QList<ManualPage>& pages() const { return pages_; }
    const ManualPage* page(const QString& name) const;
    /// Paragraphs that hold all of the words, whatever their case; at most `most` of them.
    QList<ManualHit> find(const QString& words, int most = 30) const;

private:
    QList<ManualPage> pages_;
};

}  // namespace echotrail
