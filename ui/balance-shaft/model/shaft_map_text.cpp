#include "balance-shaft/model/shaft_map_text.h"

#include "numerics/constants.h"
#include "numerics/units.h"
#include "text/csv_format.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/result_row.h"
#include "text/shown_units.h"

namespace ravnoves::shaft_map_text {

using balance_shaft::PositionStudy;
using Criteria = ShaftMapModel::Criteria;
using Marker = ShaftMapModel::Marker;
using Position = ShaftMapModel::Position;

namespace {

QString mm(double metres, int decimals = 1) {
    return shownNumber(metres, units::mm, decimals);
}

QString newtonMetres(double moment) {
    return shownNumber(moment, units::N_m, 1);
}

QString degrees(double radians, int decimals = 1) {
    return fixedNumber(radians / degree, decimals, QLocale());
}

QString whereText(const Position& position) {
    return ShaftMapModel::tr("l %1, α %2°")
        .arg(mm(position.centre_distance(), 2), degrees(position.shaft_angle(), 2));
}

/// By the criterion, with its change.
QString valueText(const ShaftMapModel& map, const Criteria& criteria) {
    return QStringLiteral("%1 (%2)").arg(
        newtonMetres(map.byRange() ? criteria.range : criteria.rms),
        signedPercentText(map.change(criteria).value_or(0.0)));
}

}  // namespace

QString best(const ShaftMapModel& map) {
    if (!map.trouble().isEmpty()) {
        return map.trouble();
    }
    const ShaftMap* const places = map.map();
    if (places == nullptr) {
        return ShaftMapModel::tr("Computing the map…");
    }
    const Marker* best = map.best();
    if (best == nullptr || !places->best.reason.empty()) {
        return messageText(places->best.reason);
    }
    const auto doesNotFit = [&](const Marker& marker) {
        return QLatin1Char(' ') +
               ShaftMapModel::tr("%1 at %2 does not fit.")
                   .arg(valueText(map, marker.criteria), whereText(marker.position));
    };
    if (!best->isBuildable) {
        return messageText(places->buildable.reason) + doesNotFit(*best);
    }
    QString text =
        ShaftMapModel::tr(
            "Best place, the smallest box with the %1 within 1 % of its minimum: %2 at %3, box %4.")
            .arg(map.byRange() ? ShaftMapModel::tr("range") : ShaftMapModel::tr("RMS"),
                 valueText(map, best->criteria), whereText(best->position),
                 shownNumber(best->criteria.size, units::cm2, 0));
    if (balance_shaft::sign_as_shown(map.change(best->criteria).value_or(0.0)) > 0) {
        text += QLatin1Char(' ') + ShaftMapModel::tr("Worse than without a shaft.");
    }
    const PositionStudy& study = places->study;
    const auto tradeOff = [&](const Criteria& from) {
        return messageText(balance_shaft::trade_off(from, best->criteria));
    };
    text += QLatin1Char(' ') + ShaftMapModel::tr("Compared with no shaft: %1.")
                                   .arg(tradeOff({study.range_without(), study.rms_without()}));
    text += QLatin1Char(' ') +
            (map.isAtBest()
                 ? ShaftMapModel::tr("Already there, within 1 %.")
                 : ShaftMapModel::tr("From here: %1.").arg(tradeOff(study.at(map.present()))));
    for (const Marker& other : map.markers()) {
        if (other.criterion == map.criterion() && !other.isBuildable) {
            text += doesNotFit(other);
        }
    }
    return text;
}

QString place(const ShaftMapModel& map, const Position& position, int decimals) {
    QString text = placeLines(map, position, decimals).join(QStringLiteral("; "));
    if (const QString why = reason(map, position); !why.isEmpty()) {
        text += QStringLiteral(". ") + why;
    }
    return text;
}

QStringList placeLines(const ShaftMapModel& map, const Position& position, int decimals) {
    if (map.map() == nullptr) {
        return {};
    }
    const PositionStudy& study = map.map()->study;
    const Criteria criteria = study.at(position);
    const auto withChange = [&](const QString& text, double with, double without) {
        const QString value = text.arg(newtonMetres(with));
        return without > 0.0
                   ? value + QStringLiteral(" (") +
                         signedPercentText(balance_shaft::relative_change(without, with)) +
                         QLatin1Char(')')
                   : value;
    };
    return {ShaftMapModel::tr("l %1, α %2°")
                .arg(mm(position.centre_distance(), decimals),
                     degrees(position.shaft_angle(), decimals)),
            withChange(ShaftMapModel::tr("range %1"), criteria.range, study.range_without()),
            withChange(ShaftMapModel::tr("RMS %1"), criteria.rms, study.rms_without()),
            ShaftMapModel::tr("box %1").arg(shownNumber(criteria.size, units::cm2, 0))};
}

QString reason(const ShaftMapModel& map, const Position& position) {
    return map.map() != nullptr ? messageText(map.map()->study.obstacle_reason(position))
                                : QString();
}

QString fieldCsv(const ShaftMapModel& map, const CsvFormat& format) {
    const ShaftMap* const places = map.map();
    if (places == nullptr) {
        return {};
    }
    const balance_shaft::PositionMap& field = places->field;
    const ShownTitle range = shownTitle(ShaftMapModel::tr("ΔMᵤₚₛ, N·m"));
    QString text = format.line({shownTitle(ShaftMapModel::tr("x, mm")).text,
                                shownTitle(ShaftMapModel::tr("y, mm")).text, range.text,
                                shownTitle(ShaftMapModel::tr("RMS, N·m")).text,
                                ShaftMapModel::tr("feasible")});
    const auto along = [](double from, double to, std::size_t i, std::size_t count) {
        return from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
    };
    constexpr std::size_t step = 2;
    for (std::size_t row = 0; row < field.rows; row += step) {
        for (std::size_t column = 0; column < field.columns; column += step) {
            const std::size_t element = row * field.columns + column;
            const Position at{along(field.left, field.right, column, field.columns),
                              along(field.bottom, field.top, row, field.rows)};
            text += format.line({format.number(at.x / shownAs(units::mm)),
                                 format.number(at.y / shownAs(units::mm)),
                                 format.number(range.factor * field.range[element]),
                                 format.number(range.factor * field.rms[element]),
                                 QString::number(map.isBuildable(at) ? 1 : 0)});
        }
    }
    return text;
}

}  // namespace ravnoves::shaft_map_text
