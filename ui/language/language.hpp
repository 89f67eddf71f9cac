#pragma once

#include <QString>
#include <functional>

class QApplication;
class QObject;

namespace echotrail {

enum class Language { English, Chinese };

/// "en", "zh": as in settings and options. Any other name is English.
QString languageName(Language language);
Language languageFromName(const QString& name);
/// As its speakers write it, whatever the language in force.
QString languageTitle(Language language);
/// The one in force; English before there was one.
Language currentLanguage();
/// Texts made from now on are in this language, Qt's own dialogs included where Qt's translations are installed;
/// windows get a LanguageChange event for those that are there.
void applyLanguage(QApplication& app, Language language);
/// Calls `say` now, and again whenever the language has changed while `owner` lives: for texts that stay as they are.
void inEveryLanguage(QObject* owner, const std::function<void()>& say);

}  // namespace echotrail
