#include "text/result_row.h"

#include <QHash>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/result_visitor.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

QString withSign(double value, const QString& shown) {
    return value > 0.0 ? QLatin1Char('+') + shown : shown;
}

/// Whether a text has a power of ten: 1e3, 10³. For every cell at every step, so without a pattern.
bool hasPower(const QString& shown) {
    return std::adjacent_find(shown.begin(), shown.end(), [](QChar before, QChar sign) {
               return (before.isDigit() && sign.toLower() == u'e') ||
                      (before == u'0' && QStringView(u"⁰¹²³⁴⁵⁶⁷⁸⁹⁻").contains(sign));
           }) != shown.end();
}

std::optional<int> decimalsOf(const QString& shown) {
    if (hasPower(shown)) {
        return std::nullopt;
    }
    const qsizetype point = shown.indexOf(QLocale().decimalPoint());
    qsizetype end = point + 1;
    while (point >= 0 && end < shown.size() && shown[end].isDigit()) {
        ++end;
    }
    return point < 0 ? 0 : static_cast<int>(end - point - 1);
}

/// What the text says, so that differences are those of the texts.
double asShown(const ResultNumber& number) {
    constexpr int digits = 6;  // of powers of ten fewer are shown
    return number.decimals ? rounded_to_decimals(number.value, *number.decimals)
                           : rounded_to_digits(number.value, digits);
}

std::optional<ShownDifference> difference(const ResultNumber& now, const ResultNumber& was) {
    using Kind = ResultNumber::Kind;
    if (now.kind != was.kind || now.unit != was.unit || now.kind == Kind::Change) {
        return std::nullopt;
    }
    double value = asShown(now) - asShown(was);
    if (now.kind == Kind::Direction) {
        value = std::remainder(value, 360.0);
    }
    return ShownDifference{
        now.decimals && was.decimals ? signedNumber(value, std::max(*now.decimals, *was.decimals))
                                     : withSign(value, trueMinus(formNumber(value, QLocale(), 3))),
        now.kind == Kind::Plain ? signedPercent(value, asShown(was)) : QString()};
}

}  // namespace

ResultCell::ResultCell(double value, QString shown, Kind kind, QString unit)
    : text(std::move(shown)) {
    if (std::isfinite(value)) {
        numbers << ResultNumber{value, kind, std::move(unit), decimalsOf(text)};
    }
}

ResultCell ResultCell::two(const QString& pattern, const ResultCell& first,
                           const ResultCell& second) {
    ResultCell cell(pattern.arg(first.text, second.text));
    cell.numbers = first.numbers + second.numbers;
    cell.pattern = pattern;
    return cell;
}

std::optional<ShownDifference> ResultCell::from(const ResultCell& reference) const {
    if (numbers.isEmpty() || numbers.size() != reference.numbers.size() ||
        pattern != reference.pattern ||
        std::equal(numbers.begin(), numbers.end(), reference.numbers.begin(),
                   [](const ResultNumber& now, const ResultNumber& was) {
                       return now.unit == was.unit && asShown(now) == asShown(was);
                   })) {
        return std::nullopt;
    }
    const auto first = difference(numbers.front(), reference.numbers.front());
    const auto second = difference(numbers.back(), reference.numbers.back());
    if (numbers.size() == 1 || !first || !second) {
        return numbers.size() == 1 ? first : std::nullopt;
    }
    const bool isPercent = numbers.back().kind == Kind::Percent;
    return ShownDifference{
        pattern.arg(first->absolute,
                    isPercent ? withUnit(second->absolute, unitText("%")) : second->absolute),
        second->percent.isEmpty() ? first->percent : pattern.arg(first->percent, second->percent)};
}

bool ResultRow::isBlank() const {
    bool hasNumber = false;
    for (qsizetype column = 1; column < size(); ++column) {
        for (const ResultNumber& number : at(column).numbers) {
            if (number.value != 0.0) {
                return false;
            }
            hasNumber = true;
        }
    }
    constexpr qsizetype nameValueUnit = 3;
    return hasNumber ? size() > nameValueUnit
                     : value(1).text.isEmpty() || value(1).text == QChar(0x2013);
}

void compareRows(ResultRows& rows, const ResultRows& reference) {
    QHash<QString, QList<const ResultRow*>> others;
    for (const ResultRow& row : reference) {
        others[row.key()] << &row;
    }
    for (ResultRow& row : rows) {
        // Of rows with one name the first is the first there.
        QList<const ResultRow*>& same = others[row.key()];
        const ResultRow was = same.isEmpty() ? ResultRow() : *same.takeFirst();
        for (qsizetype column = 1; column < row.size(); ++column) {
            row[column].fromOther = row[column].from(was.value(column));
        }
    }
}

namespace {

/// Decimals with which two digits of the larger side are shown.
int decimalsOf(const CellSpread& spread) {
    const double maximum = std::max(spread.below, spread.above);
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(maximum))), 0, 9);
}

/// So many digits that two of the larger side say something, beside this number; empty where the
/// sides are far less than its last digit.
QString spreadText(const CellSpread& spread, const ResultNumber& number) {
    const double maximum = std::max(spread.below, spread.above);
    const double minimum = std::min(spread.below, spread.above);
    const int decimals = std::min(decimalsOf(spread), number.decimals.value_or(9) + 1);
    if (maximum < 0.5 * std::pow(10.0, -decimals)) {
        return {};
    }
    const auto shown = [&](double size) {
        return maximum < 1e-9 || maximum >= 1e9         ? formNumber(size, QLocale(), 2)
               : size < 0.5 * std::pow(10.0, -decimals) ? QStringLiteral("0")
                                                        : fixedDecimals(size, decimals, QLocale());
    };
    constexpr double alike = 0.1;
    return minimum < 0.0 || maximum - minimum < alike * maximum
               ? QStringLiteral("± ") + shown(0.5 * (spread.below + spread.above))
               : QStringLiteral("+%1 −%2").arg(shown(spread.above), shown(spread.below));
}

}  // namespace

void addSpreads(ResultRows& rows, const std::vector<CellSpread>& spreads, bool areAwaited) {
    for (const CellSpread& each : spreads) {
        const ResultRow row = rows.value(each.row);
        ResultCell cell = row.value(each.column);
        const ResultNumber* number = cell.number();
        if (number == nullptr || each.column == 0 || row.key() != each.name ||
            !(std::max(each.below, each.above) > 0.0)) {
            continue;
        }
        cell.spread = areAwaited ? QStringLiteral("± …") : spreadText(each, *number);
        const int decimals = number->decimals.value_or(0);
        if (const int certain = decimalsOf(each);
            certain < decimals && cell.text == fixedDecimals(number->value, decimals, QLocale())) {
            cell.text = fixedDecimals(number->value, certain, QLocale());
        }
        rows[each.row][each.column] = cell;
    }
}

ResultCell shownCell(double si, const Unit& unit, int decimals) {
    return {shownValue(si, unit), shownDigits(si, unit, decimals), ResultCell::Kind::Plain,
            shownUnit(unit).name};
}

ResultRow shownRow(const QString& name, double si, const Unit& unit, int decimals,
                   const QString& tip) {
    return {{name, shownCell(si, unit, decimals), shownUnit(unit).name}, tip};
}

ResultRow shownRow(const ResultField& field, const std::optional<double>& si) {
    ResultRow row = shownRow(shownText(field.label), si.value_or(0.0), field.unit, field.decimals,
                             shownText(field.hint));
    if (!si) {
        row[1] = QStringLiteral("–");
    }
    return row;
}

QString signedNumber(double value, int decimals) {
    const QString shown = fixedDecimals(value, decimals, QLocale());
    const double half = 0.5 * std::pow(10.0, -decimals);
    return std::abs(value) < half ? QStringLiteral("0") : withSign(value, shown);
}

QString signedPercent(double value, double reference) {
    if (reference == 0.0 || !std::isfinite(value / reference)) {
        return value == 0.0 ? QStringLiteral("0") : QStringLiteral("–");
    }
    const double percent = 100.0 * value / std::abs(reference);
    const QString shown = std::abs(percent) < 1000.0
                              ? fixedDecimals(percent, std::abs(percent) < 99.95 ? 1 : 0, QLocale())
                          : std::abs(percent) < 1e6
                              ? fixedDecimals(rounded_to_digits(percent, 3), 0, QLocale())
                              : formNumber(percent, QLocale(), 3);
    return (std::abs(percent) < 0.05 ? QStringLiteral("0") : withSign(percent, shown)) +
           QStringLiteral("\u00A0%");
}

}  // namespace ravnoves
