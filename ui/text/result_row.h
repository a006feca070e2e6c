#pragma once

#include <QStringList>
#include <QVector>
#include <optional>
#include <utility>
#include <vector>

#include "numerics/units.h"

namespace ravnoves {

struct ResultField;

/// A number of a result, as a table shows it.
struct ResultNumber {
    /// Directions go round at 360°; a change says itself how far two results are apart.
    enum class Kind { Plain, Percent, Direction, Change };

    double value = 0.0;  ///< in the unit shown, with all its digits
    Kind kind = Kind::Plain;
    QString unit = {};                 ///< that is shown, where it may be another one
    std::optional<int> decimals = {};  ///< that are shown; none with a power of ten
};

/// The difference of a shown value from a reference, in its own decimals.
struct ShownDifference {
    QString absolute;  ///< with its sign
    QString percent;   ///< of the reference; empty where it says nothing: of percents, directions
};

/// A cell of a table of results: words, or a number or two. Differences and ± are of the numbers,
/// whatever the text.
struct ResultCell {
    using Kind = ResultNumber::Kind;

    ResultCell() = default;
    ResultCell(QString words) : text(std::move(words)) {}
    /// @param shown  the number as text, with its suffix
    ResultCell(double value, QString shown, Kind kind = Kind::Plain, QString unit = {});
    /// Two numbers by a pattern: "%1 × %2".
    static ResultCell two(const QString& pattern, const ResultCell& first,
                          const ResultCell& second);

    operator const QString&() const { return text; }
    /// The only number; null without one or with two.
    const ResultNumber* number() const { return numbers.size() == 1 ? &numbers.front() : nullptr; }
    /// Empty without a reference or a difference.
    std::optional<ShownDifference> from(const ResultCell& reference) const;
    friend bool operator==(const ResultCell& a, const ResultCell& b) { return a.text == b.text; }
    friend bool operator==(const ResultCell& a, const QString& b) { return a.text == b; }

    QString text;
    QVector<ResultNumber> numbers;
    QString pattern;  ///< of two
    bool isSmallerBetter =
        false;            ///< of several designs the one with the smallest number is the best
    bool isBest = false;  ///< it is that one
    std::optional<ShownDifference> fromOther = {};  ///< difference from another design
    QString spread = {};  ///< "± 0.2", "+0.1 −0.3" where its sides differ

    /// With a star where it is the best.
    QString marked() const { return isBest ? QStringLiteral("★ ") + text : text; }
};

/// A row of such a table, its name first.
struct ResultRow : QVector<ResultCell> {
    using QVector<ResultCell>::QVector;
    ResultRow(QVector<ResultCell> cells, QString meaning)
        : QVector<ResultCell>(std::move(cells)), tip(std::move(meaning)) {}

    QStringList texts() const { return {begin(), end()}; }
    /// By which another table has the same row.
    QString key() const { return name.isEmpty() ? value(0).text : name; }
    /// It says nothing: it has no number, or nothing but 0 in several columns.
    bool isBlank() const;

    QString tip;   ///< what the result is, with its formula
    QString name;  ///< its key(); empty: the text of the first cell
};
using ResultRows = QVector<ResultRow>;

/// A heading, and what its column is.
struct ResultColumn {
    ResultColumn(QString title, QString meaning = {})
        : heading(std::move(title)), tip(std::move(meaning)) {}

    friend bool operator==(const ResultColumn&, const ResultColumn&) = default;

    QString heading;
    QString tip;
};
using ResultColumns = QVector<ResultColumn>;

/// A table of results, as page, report, comparison and clipboard show it.
struct Results {
    ResultColumns columns;
    ResultRows rows = {};
};

/// Of a quantity, in the unit shown: `decimals`, unless the user has chosen digits.
ResultCell shownCell(double si, const Unit& unit, int decimals);
/// A row of the columns name, value, unit.
ResultRow shownRow(const QString& name, double si, const Unit& unit, int decimals,
                   const QString& tip = {});

/// The same by what core says of the result; a dash where there is no number.
ResultRow shownRow(const ResultField& field, const std::optional<double>& si);

/// What scatter of the inputs makes of a cell of a table.
struct CellSpread {
    int row = 0;
    int column = 0;
    QString name;        ///< key of the row, which is elsewhere where that is another
    double below = 0.0;  ///< from 5 % to the number, in the unit of the cell
    double above = 0.0;  ///< from the number to 95 %
};

/// Gives cells their differences from other results, row by row's key.
void compareRows(ResultRows& rows, const ResultRows& reference);
/// Gives numbers their ±; an uncertain number has no digits beyond it.
/// @param areAwaited  the numbers are others now: "± …" is in their places
void addSpreads(ResultRows& rows, const std::vector<CellSpread>& spreads, bool areAwaited = false);

/// A difference with a sign, "0" for none.
QString signedNumber(double value, int decimals);
QString signedPercent(double value, double reference);

}  // namespace ravnoves
