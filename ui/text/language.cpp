#include "text/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

namespace ravnoves {

namespace {

QString installed = QStringLiteral("en");
bool isForced = false;  ///< it was asked for by its code, whatever the settings say

/// Loads a translation; the application owns it.
void install(const QString& file, const QString& folder) {
    auto* translator = new QTranslator(QCoreApplication::instance());
    if (translator->load(file, folder)) {
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator;
    }
}

/// A translator that goes takes its texts along.
void removeAll() {
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(
        QString(), Qt::FindDirectChildrenOnly));
}

const QString settingsKey = QStringLiteral("view/language");

QString chosenLanguage() {
    return QSettings().value(settingsKey).toString();
}

}  // namespace

std::vector<Language> availableLanguages() {
    std::vector<Language> languages{{QStringLiteral("en"), QStringLiteral("English")}};
    const QStringList files =
        QDir(QStringLiteral(":/i18n")).entryList({QStringLiteral("ravnoves_*.qm")});
    for (const QString& file : files) {
        const QString code = file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
        if (code != QLatin1String("en")) {
            QString name = QLocale(code).nativeLanguageName();
            if (!name.isEmpty()) {
                name[0] = name[0].toUpper();
            }
            languages.push_back({code, name});
        }
    }
    return languages;
}

void installLanguage(const QString& code) {
    removeAll();
    isForced = !code.isEmpty();
    QString wanted = code;
    if (wanted.isEmpty()) {
        wanted = chosenLanguage();
    }
    if (wanted.isEmpty()) {
        wanted = QLocale::system().name().section(QLatin1Char('_'), 0, 0);
    }
    installed = QStringLiteral("en");
    for (const Language& language : availableLanguages()) {
        if (language.code == wanted) {
            installed = wanted;
        }
    }
    // Numbers are written as the language's readers expect, whatever the desktop's: a comma that
    // may divide thousands is none of decimals elsewhere in the same language.
    QLocale locale(installed);
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(locale);
    if (installed == QLatin1String("en")) {
        return;
    }
    install(QStringLiteral("ravnoves_") + installed, QStringLiteral(":/i18n"));
    install(QStringLiteral("extra_") + installed, QStringLiteral(":/i18n"));
    // Qt's own texts (standard buttons, file dialogs).
    install(QStringLiteral("qtbase_") + installed,
            QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

QString currentLanguage() {
    return installed;
}

QString wantedLanguage() {
    return isForced ? installed : chosenLanguage();
}

void setChosenLanguage(const QString& code) {
    if (code.isEmpty()) {
        QSettings().remove(settingsKey);
    } else {
        QSettings().setValue(settingsKey, code);
    }
}

QString timeText(const QDateTime& time) {
    return time.toLocalTime().toString(QLocale().language() == QLocale::Russian
                                           ? QStringLiteral("dd.MM.yyyy HH:mm")
                                           : QStringLiteral("yyyy-MM-dd HH:mm"));
}

}  // namespace ravnoves
