#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

namespace ravnoves {

struct Language {
    QString code;     ///< "en", "ru"
    QString ownName;  ///< as its speakers call it
};

/// English and every language with a translation in the program (:/i18n/ravnoves_CODE.qm).
std::vector<Language> availableLanguages();

/// Installs the translation and the number format of a language, in place of the previous ones. An
/// empty code is the language the user chose, else the desktop's where there is a translation, else
/// English.
void installLanguage(const QString& code = {});
/// The code that installLanguage() settled on.
QString currentLanguage();
/// The code that it was asked for, else the user's choice; empty: the desktop's.
QString wantedLanguage();
/// The user's choice, remembered for the next start; empty: the desktop's.
void setChosenLanguage(const QString& code);

/// When something was, as the program writes its dates: 2026-11-26 07:18, in Russian 26.11.2026
/// 07:18.
QString timeText(const QDateTime& time);

}  // namespace ravnoves
