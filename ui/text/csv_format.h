#pragma once

#include <QChar>
#include <QLocale>
#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <string>

namespace ravnoves {

/// How spreadsheets of a language read CSV: those with a decimal comma take the semicolon between
/// the columns.
struct CsvFormat {
    explicit CsvFormat(const QLocale& locale = QLocale())
        : point(locale.decimalPoint()),
          separator(point == QLatin1String(",") ? QLatin1Char(';') : QLatin1Char(',')) {}

    /// A number with more digits than any input has, and without those that are rounding.
    QString number(double value) const {
        constexpr int digits = 10;
        return QString::number(value, 'g', digits).replace(QLatin1Char('.'), point);
    }

    /// The bytes of a file: spreadsheets know UTF-8 by its byte-order mark.
    static std::string file(const QString& text) { return "\xEF\xBB\xBF" + text.toStdString(); }

    /// A number of the screen as spreadsheets know it: −3.2·10⁻⁷ as -3.2e-7.
    static QString plainNumber(QString text) {
        static const QRegularExpression power(
            QStringLiteral("^((?:< )?\u2212?)(?:([0-9.,]+)\u00B7)?10([⁻⁰¹²³⁴-⁹]+)"));
        if (const auto found = power.match(text); found.hasMatch()) {
            const QString factor = found.captured(2);
            QString exponent = found.captured(3).normalized(QString::NormalizationForm_KC);
            exponent.replace(QChar(0x2212), QLatin1Char('-'));
            text.replace(0, found.capturedLength(),
                         found.captured(1) + (factor.isEmpty() ? QStringLiteral("1") : factor) +
                             QLatin1Char('e') + exponent);
        }
        if (text.size() > 1 && text.front() == QChar(0x2212) && text[1].isDigit()) {
            text[0] = QLatin1Char('-');
        }
        static const QRegularExpression exponent(QStringLiteral("^(-?[0-9.,]+e)\u2212([0-9]+)$"));
        text.replace(exponent, QStringLiteral("\\1-\\2"));
        return text;
    }

    /// A text or a number as on the screen.
    QString field(const QString& shown) const {
        QString text = plainNumber(shown);
        if (text.contains(separator) || text.contains(QLatin1Char('"'))) {
            text.replace(QLatin1Char('"'), QLatin1String("\"\""));
            return QLatin1Char('"') + text + QLatin1Char('"');
        }
        return text;
    }

    /// A line of such cells.
    QString line(const QStringList& shown) const {
        QStringList cells;
        for (const QString& each : shown) {
            cells << field(each);
        }
        return cells.join(separator) + QLatin1Char('\n');
    }

    QString point;
    QChar separator;
};

}  // namespace ravnoves
