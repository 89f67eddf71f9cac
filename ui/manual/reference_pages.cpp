#include "ui/manual/reference_pages.hpp"

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "ui/manual/manual_view.hpp"

#include <QAction>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

namespace echotrail {
namespace {

QString plain(const std::string& text) { return QString::fromStdString(text); }

/// What would be a mark in a table of Markdown.
QString cell(QString text) { return text.replace('|', "\\|").replace('*', "\\*").replace('<', "&lt;").simplified(); }

QString titleOf(const QAction& action) {
    static const QRegularExpression chinese_mnemonic(R"(\(&.\))");
    return action.text().remove(chinese_mnemonic).remove('&').remove(QChar(0x2026));
}

QString limitsOf(const ParameterInfo& info) {
    if (std::holds_alternative<bool>(info.default_value)) return ManualView::tr("on or off");
    QStringList choices;
    for (const std::string& choice : info.choices) choices << plain(choice);
    if (!choices.isEmpty()) return choices.join(", ");
    return plain(ParameterInfo::toText(info.minimum) + " … " + ParameterInfo::toText(info.maximum) + " " + info.unit)
        .trimmed();
}

void addMenu(const QMenu& menu, const QString& path, QString& rows) {
    for (const QAction* action : menu.actions()) {
        if (action->isSeparator() || action->text().isEmpty()) continue;
        if (action->menu() && action->menu()->actions().isEmpty()) continue;  // filled when it is opened
        const QString title = path.isEmpty() ? titleOf(*action) : path + " → " + titleOf(*action);
        if (action->menu()) {
            addMenu(*action->menu(), title, rows);
            continue;
        }
        QStringList keys;
        for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
        const QString tip = action->statusTip();
        rows += QStringLiteral("| %1 | %2 |\n")
                    .arg(keys.isEmpty() ? QString() : "**" + cell(keys.join("  ")) + "**",
                         cell(tip.isEmpty() ? title : title + ": " + tip));
    }
}

}  // namespace

QString parameterReference() {
    QString text = "\n## " + ManualView::tr("Every parameter") + "\n";
    QString group;
    for (const ParameterInfo& info : describeParameters<ScanningSonarPipeline::Params>()) {
        if (plain(info.group) != group) {
            group = plain(info.group);
            text += "\n### " + group + "\n\n";
        }
        const QString value = plain(ParameterInfo::toText(info.default_value));
        text += "- **" + plain(info.name) + "** — " + cell(plain(info.help)) + ". " +
                ManualView::tr("Limits: %1. Default: %2.").arg(cell(limitsOf(info)), value) + " " +
                (info.effect == Effect::NextPing ? ManualView::tr("From the next ping.")
                                                 : ManualView::tr("From the next sweep.")) +
                "\n";
    }
    return text;
}

QString keyReference(const QMenuBar& menus) {
    const QString head = "\n\n| " + ManualView::tr("Key") + " | " + ManualView::tr("What it does") + " |\n|:--|:--|\n";
    QString text;
    for (const QAction* title : menus.actions()) {
        if (!title->menu()) continue;
        QString rows;
        addMenu(*title->menu(), {}, rows);
        text += "\n## " + titleOf(*title) + head + rows;
    }
    return text;
}

QString aboutPage(const QString& version, const std::vector<LibraryNotice>& libraries) {
    QString text = "# " + ManualView::tr("About Echotrail") + "\n\n**Echotrail** " + version + " — " +
                   ManualView::tr("operator console and tracker for a mechanically scanned sonar.") + "\n\n" +
                   ManualView::tr("Licence: GPL-3.0-or-later. You may use, study, change and share it; it comes "
                                  "without any warranty.") +
                   " [" + ManualView::tr("The whole licence") + "](manual:licence)\n\n## " +
                   ManualView::tr("It stands on") + "\n\n";
    const QStringList heads{ManualView::tr("Library"), ManualView::tr("Version"), ManualView::tr("Licence"),
                            ManualView::tr("For")};
    text += "| " + heads.join(" | ") + " |\n|:--|:--|:--|:--|\n";
    for (const LibraryNotice& library : libraries)
        text += QStringLiteral("| %1 | %2 | %3 | %4 |\n")
                    .arg(cell(library.name), cell(library.version), cell(library.licence), cell(library.purpose));
    return text;
}

QString licencePage() {
    QFile file(":/manual/licence.txt");
    if (!file.open(QIODevice::ReadOnly)) return {};
    // As it stands: every line a line of code, in Markdown's way.
    QString text = "# GPL-3.0\n\n";
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) text += "    " + line + "\n";
    return text;
}

}  // namespace echotrail
