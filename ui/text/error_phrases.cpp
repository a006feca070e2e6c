#include "text/error_phrases.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <vector>

#include "text/error_text.h"
#include "text/number_text.h"

namespace ravnoves {

namespace {

constexpr const char* context = "ravnoves::InputError";

/// A listed phrase as a pattern; its values are the groups, in their order.
struct Pattern {
    const char* phrase = nullptr;
    QRegularExpression expression;
    qsizetype literals = 0;  ///< letters beside the values
};

std::vector<Pattern> makePatterns() {
    static const QRegularExpression place(QStringLiteral("\\\\%[1-9]"));
    std::vector<Pattern> patterns;
    patterns.reserve(errorPhrases.size());
    for (const char* phrase : errorPhrases) {
        QString expression = QRegularExpression::escape(QString::fromUtf8(phrase));
        const qsizetype before = expression.size();
        expression.replace(place, QStringLiteral("(.+?)"));
        patterns.push_back({phrase,
                            QRegularExpression(QRegularExpression::anchoredPattern(expression),
                                               QRegularExpression::UseUnicodePropertiesOption),
                            before - 5 * expression.count(QStringLiteral("(.+?)"))});
    }
    // "must be less than 1; the mechanism …" also matches "must be less than %1": more words first.
    std::stable_sort(patterns.begin(), patterns.end(),
                     [](const Pattern& a, const Pattern& b) { return a.literals > b.literals; });
    return patterns;
}

/// "46.5" or "46.5 mm" with the decimal sign and the unit of the language; nothing else.
QString localNumber(const QString& text) {
    static const QRegularExpression number(
        QStringLiteral("^([-−+]?\\d+)(?:\\.(\\d+))?(e[-+]?\\d+)?( ?)(°|[^\\s\\d]\\S*)?$"),
        QRegularExpression::UseUnicodePropertiesOption);
    const QRegularExpressionMatch match = number.match(text);
    if (!match.hasMatch()) {
        return text;
    }
    QString shown = match.captured(1);
    if (!match.captured(2).isEmpty()) {
        shown += QLocale().decimalPoint() + match.captured(2);
    }
    return shown + match.captured(3) + match.captured(4) +
           unitText(match.captured(5).toStdString());
}

QString translated(const QString& text) {
    static const std::vector<Pattern> patterns = makePatterns();
    for (const Pattern& pattern : patterns) {
        const QRegularExpressionMatch match = pattern.expression.match(text);
        if (!match.hasMatch()) {
            continue;
        }
        QString shown = QCoreApplication::translate(context, pattern.phrase);
        for (int i = match.lastCapturedIndex(); i > 0; --i) {
            shown.replace(QStringLiteral("%%1").arg(i), translated(match.captured(i)));
        }
        return shown;
    }
    // A file's name or the system's own words before or after a phrase.
    const qsizetype colon = text.indexOf(QLatin1String(": "));
    if (colon >= 0) {
        return translated(text.left(colon)) + QLatin1String(": ") + translated(text.mid(colon + 2));
    }
    return localNumber(text);
}

}  // namespace

QString coreText(const std::string& text) {
    return translated(QString::fromStdString(text));
}

}  // namespace ravnoves
