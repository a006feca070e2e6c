#include "text/typed_number.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>

#include <muParser.h>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "numerics/units.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

/// A unit that may be typed in the place of another of its quantity.
struct TypedUnit {
    enum Quantity {
        Mass,
        Length,
        Unbalance,
        Speed,
        Angle,
        Torque,
        Force,
        Density,
        Pressure,
        Stiffness
    } quantity;
    Unit unit;
    const char16_t* spellings;  ///< lower case, without dots
};

// Of unbalances; shown nowhere.
constexpr Unit gramCentimetre{"g·cm", 1e-5};
constexpr Unit gramMetre{"g·m", 1e-3};
constexpr Unit kilogramCentimetre{"kg·cm", 1e-2};
// Of densities, as tables of materials give them; shown nowhere.
constexpr Unit gramPerCentimetre3{"g/cm³", 1e3};

constexpr std::array typedUnits{
    // The last of masses: a scale that is a keyboard, while the Russian layout is on: "568ю5п".
    TypedUnit{TypedUnit::Mass, units::gram, u"g г gr гр п"},
    TypedUnit{TypedUnit::Mass, units::kg, u"kg кг лп"},
    TypedUnit{TypedUnit::Mass, units::milligram, u"mg мг"},
    TypedUnit{TypedUnit::Mass, units::ounce, u"oz унц щя"},
    TypedUnit{TypedUnit::Mass, units::pound, u"lb фунт lbs фунтов ди"},
    TypedUnit{TypedUnit::Length, units::mm, u"mm мм"},
    TypedUnit{TypedUnit::Length, units::centimetre, u"cm см"},
    TypedUnit{TypedUnit::Length, units::metre, u"m м"},
    TypedUnit{TypedUnit::Length, units::micrometre, u"um мкм"},
    TypedUnit{TypedUnit::Length, units::inch, u"in \""},
    TypedUnit{TypedUnit::Length, units::mil, u"mil мил"},
    TypedUnit{TypedUnit::Length, units::foot, u"ft фут"},
    TypedUnit{TypedUnit::Unbalance, units::gram_mm, u"gmm гмм"},
    TypedUnit{TypedUnit::Unbalance, gramCentimetre, u"gcm гсм"},
    TypedUnit{TypedUnit::Unbalance, gramMetre, u"gm гм kgmm кгмм"},
    TypedUnit{TypedUnit::Unbalance, kilogramCentimetre, u"kgcm кгсм"},
    TypedUnit{TypedUnit::Unbalance, units::kg_m, u"kgm кгм"},
    TypedUnit{TypedUnit::Unbalance, units::gram_inch, u"gin гдюйм"},
    TypedUnit{TypedUnit::Unbalance, units::ounce_inch, u"ozin унцдюйм"},
    TypedUnit{TypedUnit::Speed, units::rpm, u"rpm об/мин"},
    TypedUnit{TypedUnit::Speed, units::rad_per_s, u"rad/s рад/с"},
    TypedUnit{TypedUnit::Angle, units::degree, u"deg град"},
    TypedUnit{TypedUnit::Angle, units::radian, u"rad рад"},
    TypedUnit{TypedUnit::Torque, units::N_m, u"nm нм"},
    TypedUnit{TypedUnit::Torque, units::lb_ft, u"lbft фунтфут"},
    TypedUnit{TypedUnit::Force, units::newton, u"n н"},
    TypedUnit{TypedUnit::Force, units::kN, u"kn кн"},
    TypedUnit{TypedUnit::Force, units::pound_force, u"lbf фунтс"},
    TypedUnit{TypedUnit::Pressure, units::bar, u"bar бар"},
    TypedUnit{TypedUnit::Pressure, units::mbar, u"mbar мбар"},
    TypedUnit{TypedUnit::Pressure, units::pascal, u"pa па"},
    TypedUnit{TypedUnit::Pressure, units::kPa, u"kpa кпа"},
    TypedUnit{TypedUnit::Pressure, units::MPa, u"mpa мпа"},
    TypedUnit{TypedUnit::Pressure, units::psi, u"psi"},
    TypedUnit{TypedUnit::Stiffness, units::N_per_m, u"n/m н/м"},
    TypedUnit{TypedUnit::Stiffness, units::kN_per_m, u"kn/m кн/м n/mm н/мм"},
    TypedUnit{TypedUnit::Stiffness, units::lbf_per_inch, u"lbf/in фунтс/дюйм"},
    TypedUnit{TypedUnit::Density, units::kg_m3, u"kg/m³ кг/м³"},
    TypedUnit{TypedUnit::Density, gramPerCentimetre3, u"g/cm³ г/см³ g/cc кг/дм³ t/m³ т/м³"}};

const TypedUnit* typedUnit(const QString& word) {
    QString small = word.toLower();
    for (const char16_t between :
         {u'·', u'⋅', u'∙', u'•', u'×', u'.', u'-', u'*', u' ', u'\u00A0', u'\u202F'}) {
        small.remove(QChar(between));
    }
    const auto found = std::find_if(typedUnits.begin(), typedUnits.end(), [&](const auto& each) {
        return QStringView(each.spellings).split(u' ').contains(small) ||
               word == unitText(each.unit.name);
    });
    return found == typedUnits.end() ? nullptr : &*found;
}

/// The number and what is behind it.
std::pair<QString, QString> split(const QString& whole) {
    // The exponent of "17 g/cm3" is no end of the number.
    static const QRegularExpression cubed(QStringLiteral("(/\\s*\\w?[mмMМ])\\^?3$"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    const QString text = QString(whole).replace(cubed, QStringLiteral("\\1³"));
    qsizetype end = text.size();
    while (end > 0 && !(text[end - 1] >= QLatin1Char('0') && text[end - 1] <= QLatin1Char('9')) &&
           !QStringView(u",.)").contains(text[end - 1])) {
        --end;
    }
    // "унц." ends in the sign that a number may end in.
    if (end == text.size() && end > 1 && text[end - 1] == QLatin1Char('.') &&
        text[end - 2].isLetter()) {
        const auto [number, word] = split(text.chopped(1));
        return {number, word};
    }
    QString number = text.left(end).trimmed();
    number.replace(QChar(u'ю'), QLatin1Char('.')).replace(QChar(u'б'), QLatin1Char(','));
    static const QRegularExpression thousands(
        QStringLiteral("^[-+\u2212]?[0-9]{1,3}([ \u00A0\u2009\u202F][0-9]{3})+([.,][0-9]*)?$"));
    if (thousands.match(number).hasMatch()) {  // "1 250"
        static const QRegularExpression blanks(QStringLiteral("[ \u00A0\u2009\u202F]"));
        number.remove(blanks);
    }
    return {number, text.mid(end).trimmed()};
}

/// A number that stands alone; where its comma may divide thousands, both meanings as text.
TypedNumber alone(const QString& text) {
    const auto number = readFormNumber(text);
    const QLocale locale;
    if (!number || locale.decimalPoint() != QLatin1String(".") ||
        !may_have_thousands(text.toStdString())) {
        return {number, {}};
    }
    const auto whole = readFormNumber(QString(text).remove(QLatin1Char(',')));
    constexpr int digits = 15;
    return {std::nullopt, QCoreApplication::translate("ravnoves::NumberField",
                                                      "“%1” may be %2 or %3: enter one of them.")
                              .arg(text, shownFormNumber(whole.value_or(0.0), locale, digits),
                                   shownFormNumber(*number, locale, digits))};
}

/// The same, or numbers with + − * / and brackets between them.
TypedNumber computed(QString text) {
    if (TypedNumber number = alone(text); number.value || !number.trouble.isEmpty()) {
        return number;
    }
    text.replace(QChar(u'\u2212'), QLatin1Char('-'));
    text.replace(QChar(u'×'), QLatin1Char('*')).replace(QChar(u'÷'), QLatin1Char('/'));
    static const QRegularExpression formula(QStringLiteral("^[-+*/() \\x{A0}0-9.,eE]+$"));
    if (!formula.match(text).hasMatch()) {
        return {};
    }
    static const QRegularExpression numbers(QStringLiteral("[0-9.,]+(?:[eE][-+]?[0-9]+)?"));
    QString plain;
    qsizetype from = 0;
    for (auto each = numbers.globalMatch(text); each.hasNext();) {
        const auto match = each.next();
        const TypedNumber number = alone(match.captured());
        if (!number.value) {
            return number;
        }
        constexpr int exact = 17;
        plain += text.mid(from, match.capturedStart() - from) +
                 QString::number(*number.value, 'g', exact);
        from = match.capturedEnd();
    }
    plain += text.mid(from);
    mu::Parser parser;
    parser.SetExpr(plain.replace(QChar::Nbsp, QLatin1Char(' ')).toStdString());
    try {
        constexpr int digits = 15;  // 0.1 + 0.2 is 0.3
        const double value = parser.Eval();
        return {
            std::isfinite(value) ? std::optional(rounded_to_digits(value, digits)) : std::nullopt,
            {}};
    } catch (const mu::Parser::exception_type&) {
        return {};
    }
}

/// A number with the unit behind it, in `unit`.
TypedNumber inUnit(const TypedNumber& typedNumber, const QString& word, const QString& unit) {
    const auto& number = typedNumber.value;
    if (word.isEmpty() || word == unit || !number) {
        return typedNumber;
    }
    const TypedUnit* typed = typedUnit(word);
    if (typed == nullptr) {
        return {};
    }
    const TypedUnit* own = typedUnit(unit);
    if (own == nullptr || own->quantity != typed->quantity) {
        return {std::nullopt,
                unit.isEmpty()
                    ? QCoreApplication::translate("ravnoves::NumberField",
                                                  "“%1” is a unit, but this value has no unit.")
                          .arg(word)
                    : QCoreApplication::translate("ravnoves::NumberField",
                                                  "“%1” is not a unit of this value (%2).")
                          .arg(word, unit)};
    }
    constexpr int precision = 15;  // 568.5 g are 0.5685 kg, not 0.56850000000000001
    return typed->unit.to_si == own->unit.to_si
               ? typedNumber
               : TypedNumber{
                     rounded_to_digits(*number * (typed->unit.to_si / own->unit.to_si), precision),
                     {}};
}

}  // namespace

TypedNumber readTypedNumber(const QString& text, const QString& unit) {
    const auto [digits, word] = split(text.trimmed());
    return inUnit(alone(digits), word, unit);
}

TypedNumber readTypedFormula(const QString& text, const QString& unit) {
    const auto [formula, word] = split(text.trimmed());
    return inUnit(computed(formula), word, unit);
}

QString notANumberText(const QString& text) {
    constexpr qsizetype longest = 40;
    const QString shown = text.simplified();
    return QCoreApplication::translate("ravnoves::NumberField", "“%1” is not a number.")
        .arg(shown.size() > longest ? shown.left(longest) + QChar(0x2026) : shown);
}

bool isTypedNumber(const QString& text) {
    const auto [digits, word] = split(text.trimmed());
    return readFormNumber(digits) && (word.isEmpty() || typedUnit(word) != nullptr);
}

bool isMassUnit(const QString& unit) {
    const TypedUnit* typed = typedUnit(unit);
    return typed != nullptr && typed->quantity == TypedUnit::Mass;
}

namespace {

/// A decimal comma whose fraction ends in 0 is hardly one: "8,10" is 8 and 10, or 8.1.
/// @param isUsual  only then
void rejectEitherNumbers(const QString& word, const Message& where, bool isUsual) {
    static const QRegularExpression either(QStringLiteral("^([-−+]?\\d+)[,б](\\d+)(?!\\d)"));
    const auto match = either.match(word);
    if (!match.hasMatch() || (isUsual && !match.captured(2).endsWith(QLatin1Char('0')))) {
        return;
    }
    static const QRegularExpression leading(QStringLiteral("^0+(?=\\d)"));
    static const QRegularExpression trailing(QStringLiteral("0+$"));
    const QString whole = match.captured(1);
    const QString fraction = match.captured(2).remove(trailing);
    const QString two = whole + QStringLiteral("; ") + match.captured(2).remove(leading);
    const QString one = fraction.isEmpty() ? whole : whole + QLatin1Char('.') + fraction;
    throw InputError(where,
                     {Text::tr("must be two numbers or one: enter %1 or %2"),
                      quoted_list({two.toStdString()}), quoted_list({one.toStdString()})},
                     quoted_list({word.toStdString()}));
}

}  // namespace

std::vector<double> readNumberList(const QString& typed, const Field& field, const Message& where,
                                   bool (*isUsual)(double si)) {
    static const QRegularExpression between(QStringLiteral("\\s*;\\s*|,\\s+|\\s+"));
    constexpr int exact = 9;  // what is shown and read again is the same
    const ShownUnit shown = shownUnit(field);
    std::vector<double> values;
    QStringList words;
    for (const QString& word : typed.split(between, Qt::SkipEmptyParts)) {
        if (!words.isEmpty() && typedUnit(word) != nullptr) {  // "12 mm" is one number
            words.last() += word;
        } else {
            words << word;
        }
    }
    for (const QString& word : std::as_const(words)) {
        auto [value, trouble] = readTypedNumber(word, shown.name);
        rejectEitherNumbers(
            word, where,
            isUsual == nullptr || !value || isUsual(*value / shown.factor * field.unit));
        if (!trouble.isEmpty()) {
            throw InputError(where, trouble.toStdString());
        }
        if (!value) {
            throw InputError(where,
                             Text::tr("must be numbers with blanks or semicolons between them"),
                             quoted_list({word.toStdString()}));
        }
        if (shown.factor != 1.0) {
            value = rounded_to_digits(*value / shown.factor, exact);
        }
        check_range(field, *value, where, field.unit);
        values.push_back(*value);
    }
    return values;
}

QString numberListText(const std::vector<double>& values, const Field& field) {
    const double factor = shownUnit(field).factor;
    QStringList list;
    for (const double value : values) {
        list << formNumber(value * factor, QLocale(), factor == 1.0 ? 10 : 6);
    }
    return list.join(QStringLiteral("; "));
}

}  // namespace ravnoves
