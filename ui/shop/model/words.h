#pragma once

#include <QDate>
#include <QLocale>
#include <QString>
#include <memory>

#include "case-file/field.h"
#include "text/message_text.h"
#include "text/result_row.h"

class QTranslator;

namespace ravnoves {

/// The words and numbers of one language: the program's own, or another, so that a Russian job card
/// can be printed from an English page and the other way round.
class Words {
  public:
    /// The language of the program.
    Words() = default;
    /// A language of its own, "en" or one that has a translation (:/i18n/ravnoves_CODE.qm).
    explicit Words(const QString& code);

    /// The text in the language; named as lupdate knows it.
    QString translate(const char* context, const char* text, const char* comment = nullptr) const;

    QString text(const Text& text) const { return translate(core_texts, text.english); }
    /// A message of core, with the numbers and units of the language.
    QString message(const Message& message) const;
    /// A field's label without the & of its mnemonic: "Crank radius r".
    QString name(const Field& field) const { return text(field.label).remove(QLatin1Char('&')); }
    /// A unit of core, or the one that the user wants in its place; empty for pure numbers.
    QString unit(Unit unit) const;

    /// The program's language may change meanwhile.
    QLocale locale() const { return own_ ? locale_ : QLocale(); }
    /// Fixed decimals, decimal sign of the language, a true minus.
    QString number(double value, int decimals) const;
    /// With its unit: "2.79 g".
    QString number(double si, Unit unit, int decimals) const;
    /// The same without it.
    QString digits(double si, Unit unit, int decimals) const;
    /// Both for a table: the number alone, or with its unit.
    ResultCell cell(double si, Unit unit, int decimals) const;
    ResultCell cellWithUnit(double si, Unit unit, int decimals) const;
    /// A day of ISO 8601 as the language writes it, "31.05.2024" or "2024-05-31"; other texts are
    /// unchanged.
    QString day(const QString& iso) const;
    /// As many of the decimals as the number has: "2.79", "40".
    QString plain(double value, int decimals = 4) const;
    QString plain(double si, Unit unit, int decimals) const;
    /// The same with its unit.
    QString plainWithUnit(double si, Unit unit, int decimals) const;
    /// The same in the unit that a field is shown in.
    QString plainWithUnit(double si, const Field& field, int decimals) const;

  private:
    bool own_ = false;  // a language of its own, not the program's
    std::shared_ptr<const QTranslator> translator_;
    QLocale locale_;
};

/// Reads a day as people type it: 2024-05-31, 31.05.2024, 31.5.24. Else invalid.
QDate readDay(const QString& text);

}  // namespace ravnoves
