#include "v8-plugs/model/words.h"

#include <QCoreApplication>
#include <QTranslator>

#include "text/number_text.h"

namespace ravnoves {

Words::Words() = default;

Words::Words(const QString& code) : own_(true), locale_(code) {
    locale_.setNumberOptions(QLocale::OmitGroupSeparator);
    auto translator = std::make_unique<QTranslator>();
    if (translator->load(QStringLiteral(":/i18n/ravnoves_%1.qm").arg(code))) {
        translator_ = std::move(translator);
    }
}

Words::~Words() = default;
Words::Words(Words&&) noexcept = default;
Words& Words::operator=(Words&&) noexcept = default;

QString Words::translate(const char* context, const char* text, const char* comment) const {
    if (!own_) {
        return QCoreApplication::translate(context, text, comment);
    }
    const QString found = translator_ ? translator_->translate(context, text, comment) : QString();
    return found.isEmpty() ? QString::fromUtf8(text) : found;
}

QString Words::number(double value, int decimals) const {
    return fixedNumber(value, decimals, locale_);
}

QString Words::plain(double value, int decimals) const {
    QString text = number(value, decimals);
    const QString point = locale_.decimalPoint();
    if (text.contains(point)) {
        while (text.endsWith(QLatin1Char('0'))) {
            text.chop(1);
        }
        if (text.endsWith(point)) {
            text.chop(point.size());
        }
    }
    return text;
}

}  // namespace ravnoves
