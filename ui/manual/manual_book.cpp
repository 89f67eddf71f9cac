#include "ui/manual/manual_book.hpp"

#include <QFile>
#include <QRegularExpression>
#include <algorithm>

namespace echotrail {
namespace {

/// In the order of the book.
constexpr const char* page_names[] = {"start",      "fan",  "status", "connection", "layers",    "chart",   "tracks",
                                      "parameters", "plan", "alerts", "beam",       "time_line", "windows", "keys"};
constexpr int longest_excerpt = 120;

QString withoutMarks(QString text) {
    static const QRegularExpression picture(R"(!\[[^\]]*\]\([^)]*\))");
    static const QRegularExpression link(R"(\[([^\]]*)\]\([^)]*\))");
    static const QRegularExpression marks("[*`#|>]+");
    return text.remove(picture).replace(link, "\\1").replace(marks, " ").simplified();
}

}  // namespace

QString ManualPage::title() const { return withoutMarks(text.section('\n', 0, 0)); }

ManualBook::ManualBook(Language language) {
    for (const char* name : page_names) {
        QFile file(QStringLiteral(":/manual/%1/%2.md").arg(languageName(language), name));
        if (file.open(QIODevice::ReadOnly)) pages_.append({name, QString::fromUtf8(file.readAll())});
    }
}

void ManualBook::add(const QString& name, const QString& text) {
    const auto found = std::find_if(pages_.begin(), pages_.end(), [&](const auto& page) { return page.name == name; });
    if (found == pages_.end())
        pages_.append({name, text});
    else
        found->text += "\n" + text;
}

const ManualPage* ManualBook::page(const QString& name) const {
    const auto found = std::find_if(pages_.begin(), pages_.end(), [&](const auto& page) { return page.name == name; });
    return found == pages_.end() ? nullptr : &*found;
}

QList<ManualHit> ManualBook::find(const QString& words, int most) const {
    const QStringList wanted = words.simplified().split(' ', Qt::SkipEmptyParts);
    QList<ManualHit> hits;
    if (wanted.isEmpty()) return hits;
    static const QRegularExpression paragraph_end("\n\\s*\n|\n(?=[|#-])");
    for (const ManualPage& page : pages_) {
        for (const QString& paragraph : page.text.split(paragraph_end)) {
            const QString plain = withoutMarks(paragraph);
            const bool all = std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
                return plain.contains(word, Qt::CaseInsensitive);
            });
            if (!all) continue;
            hits.append({page.name, page.title(), plain.left(longest_excerpt)});
            if (hits.size() == most) return hits;
        }
    }
    return hits;
}

}  // namespace echotrail
