#include "text/key_words.h"

#include <QCoreApplication>

#include "case-file/key_units.h"

namespace ravnoves {

Unit takeUnit(QString& key) {
    const KeyUnit found = unit_of_key(key.toStdString());
    key.chop(static_cast<qsizetype>(found.length));
    return found.unit;
}

QString keyInWords(const std::string& key) {
    QString words = QString::fromStdString(key == "csv" ? "file" : key);
    takeUnit(words);
    words.replace(QLatin1Char('_'), QLatin1Char(' '));
    return QCoreApplication::translate("Keys", words.toUtf8().constData());
}

QString caseText(const std::string& text) {
    constexpr std::size_t digits = 64;
    constexpr qsizetype enough = 12;
    const bool isSum =
        text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
    const QString all = QString::fromStdString(text);
    return isSum ? all.left(enough) + QChar(0x2026) : all;
}

}  // namespace ravnoves
