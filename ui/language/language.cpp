#include "ui/language/language.hpp"

#include <QApplication>
#include <QLibraryInfo>
#include <QTranslator>

namespace echotrail {
namespace {

Language current_language = Language::English;

/// Changes its name with the language: a signal that is there already.
QObject& notifier() {
    static QObject of_language;
    return of_language;
}

/// Owned by the application, so that they end with it.
struct Translators {
    QTranslator* own;
    QTranslator* qt;
};

Translators& translators(QApplication& app) {
    static Translators all{};
    static QApplication* of = nullptr;
    if (of != &app) all = {new QTranslator(&app), new QTranslator(&app)};
    of = &app;
    return all;
}

}  // namespace

QString languageName(Language language) { return language == Language::Chinese ? "zh" : "en"; }

Language languageFromName(const QString& name) { return name == "zh" ? Language::Chinese : Language::English; }

QString languageTitle(Language language) {
    return language == Language::Chinese ? QStringLiteral("中文") : QStringLiteral("English");
}

Language currentLanguage() { return current_language; }

void applyLanguage(QApplication& app, Language language) {
    if (language == current_language) return;
    current_language = language;
    const Translators& all = translators(app);
    QCoreApplication::removeTranslator(all.own);
    QCoreApplication::removeTranslator(all.qt);
    if (language == Language::Chinese) {  // English is what the source says
        if (all.qt->load("qtbase_zh_CN", QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            QCoreApplication::installTranslator(all.qt);
        if (all.own->load(":/translations/echotrail_zh.qm")) QCoreApplication::installTranslator(all.own);
    }
    notifier().setObjectName(languageName(language));
}

void inEveryLanguage(QObject* owner, const std::function<void()>& say) {
    say();
    QObject::connect(&notifier(), &QObject::objectNameChanged, owner, say);
}

}  // namespace echotrail
