#include "bob-weights/model/bob_text.h"

#include "bob-weights/fields.h"

namespace ravnoves::bob_text {

using namespace bob_weights;

namespace {

const QString noNumber = QStringLiteral("–");

QString degreesOf(const Words& words, double angle) {
    return words.number(angle, units::degree, 1);
}

QString unbalanceOf(const Words& words, double unbalance) {
    return words.number(unbalance, units::gram_mm, 1);
}

}  // namespace

QString engineName(const Words& words, const Engine& engine) {
    switch (engine.type) {
        case EngineType::v:
            return engine.bank_angle
                       ? words.translate("BobWeights", "V-%1, %2")
                             .arg(engine.cylinders)
                             .arg(words.plain(*engine.bank_angle / degree, 1) + QStringLiteral("°"))
                       : QStringLiteral("V-%1").arg(engine.cylinders);
        case EngineType::in_line:
            return words.translate("BobWeights", "%1 in line").arg(engine.cylinders);
        case EngineType::boxer:
            return words.translate("BobWeights", "Boxer, %1").arg(engine.cylinders);
    }
    return {};
}

QString headline(const Words& words, const Input& input, const Result& result) {
    if (result.bob_weight) {
        return words.translate("BobWeights", "Bob weight %1")
            .arg(words.number(*result.bob_weight, units::gram, 1));
    }
    QStringList missing;
    for (const Field* field : missing_for_bob_weight(input)) {
        missing << words.name(*field);
    }
    return words.translate("BobWeights", "Still needed: %1")
        .arg(missing.join(QStringLiteral(", ")));
}

QString hang(const Words& words, const Engine& engine) {
    const int count = engine.crankpins();
    if (engine.pin_split != 0.0 && engine.rods_per_pin == 2) {
        return words
            .translate("BobWeights",
                       "For each of the %1 pairs of split crankpins, half of it on either.")
            .arg(count);
    }
    return words.translate("BobWeights", "On each of the %1 crankpins.").arg(count);
}

QString factor(const Words& words, const Input& input, const Result& result) {
    const auto percent = [&](double share) {
        return words.plain(100.0 * share, 2) + QStringLiteral(" %");
    };
    QString text =
        input.factor.reciprocating
            ? words.translate("BobWeights", "Factor %1 (theory: %2)")
                  .arg(percent(result.factor), percent(result.theory_factor))
            : words.translate("BobWeights", "Factor %1, by theory").arg(percent(result.factor));
    if (input.factor.overbalance != 0.0) {
        text += words
                    .translate("BobWeights", " + %1 overbalance",
                               "after the factor; negative numbers have their sign")
                    .arg(percent(input.factor.overbalance));
    }
    return text + QStringLiteral(". ") +
           words.message(factor_effect(input.engine, result.factor + input.factor.overbalance));
}

QString limits(const Words& words, const Result& result) {
    if (!result.permissible) {
        return {};
    }
    const QString first = unbalanceOf(words, (*result.permissible)[0]);
    const QString second = unbalanceOf(words, (*result.permissible)[1]);
    const QString planes =
        first == second ? words.translate("BobWeights", "%1 in each plane").arg(first)
                        : words.translate("BobWeights", "%1 in the front plane, %2 in the rear one")
                              .arg(first, second);
    return result.permissible_whole
               ? words.translate("BobWeights", "May remain: %1, of %2 for the crankshaft.")
                     .arg(planes, unbalanceOf(words, *result.permissible_whole))
               : words.translate("BobWeights", "May remain: %1.").arg(planes);
}

QString planeName(const Words& words, std::size_t plane) {
    return plane == 0 ? words.translate("BobWeights", "Front plane")
                      : words.translate("BobWeights", "Rear plane");
}

QStringList shortfalls(const Words& words, const Result& result) {
    QStringList list;
    if (result.correction) {
        for (std::size_t i = 0; i < 2; ++i) {
            const PlaneResult& plane = (*result.correction)[i];
            if (!plane.reason.empty()) {
                list << planeName(words, i) + QStringLiteral(": ") + words.message(plane.reason);
            }
        }
    }
    return list;
}

QString weighIn(const Words& words, const Result& result) {
    QStringList said;
    if (!result.crankpins.empty()) {
        QStringList pins;
        for (const double mass : result.crankpins) {
            pins << words.digits(mass, units::gram, 1);
        }
        said << words.translate("BobWeights", "Bob weights of the crankpins by themselves, %1: %2.")
                    .arg(words.unit(units::gram), pins.join(QStringLiteral("; ")));
    }
    for (const Matching& each : result.matching) {
        QStringList parts;
        for (std::size_t i = 0; i < each.take_off.size(); ++i) {
            if (each.take_off[i] && *each.take_off[i] > 0.005 * units::gram) {
                parts << words.translate("BobWeights", "%1 off no. %2")
                             .arg(words.digits(*each.take_off[i], units::gram, 2))
                             .arg(i + 1);
            }
        }
        if (!parts.isEmpty()) {
            said << words.translate("BobWeights", "%1, to match the lightest, %2: %3.")
                        .arg(words.text(workshop::part_word(*each.part->column).label),
                             words.unit(units::gram), parts.join(QStringLiteral("; ")));
        }
    }
    return said.join(QLatin1Char('\n'));
}

QString balance(const Words& words, Balance balance) {
    return words.text(balance_words[static_cast<std::size_t>(balance)].label);
}

QStringList lineHead(const Words& words) {
    return {words.translate("BobWeights", "Part"), words.translate("BobWeights", "One weighs"),
            words.translate("BobWeights", "Counts"),
            words.translate("BobWeights", "In the bob weight")};
}

QVector<QStringList> lines(const Words& words, const Result& result) {
    QVector<QStringList> rows;
    for (const Line& line : result.lines) {
        rows << QStringList{words.name(line.part->field), words.number(line.mass, units::gram, 1),
                            QStringLiteral("× ") + words.plain(line.factor, 4),
                            words.number(line.product(), units::gram, 1)};
    }
    if (result.bob_weight) {
        rows << QStringList{words.translate("BobWeights", "Bob weight"), QString(), QString(),
                            words.number(*result.bob_weight, units::gram, 1)};
    }
    return rows;
}

QStringList planeHead(const Words& words) {
    return {
        words.translate("BobWeights", "Plane"),    words.translate("BobWeights", "Unbalance"),
        words.translate("BobWeights", "Heavy at"), words.translate("BobWeights", "At the radius"),
        words.translate("BobWeights", "Remains"),  words.translate("BobWeights", "Verdict")};
}

QVector<QStringList> planes(const Words& words, const Result& result) {
    QVector<QStringList> rows;
    if (!result.correction) {
        return rows;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const PlaneResult& plane = (*result.correction)[i];
        rows << QStringList{planeName(words, i),
                            unbalanceOf(words, plane.unbalance),
                            degreesOf(words, plane.angle),
                            words.number(plane.grams_at_radius, units::gram, 2),
                            unbalanceOf(words, plane.remaining),
                            !plane.within_tolerance    ? noNumber
                            : !*plane.within_tolerance ? words.translate("BobWeights", "too much")
                            : plane.holes.empty() && plane.slugs.empty()
                                ? words.translate("BobWeights", "good as it is")
                                : words.translate("BobWeights", "good then")};
    }
    return rows;
}

QStringList holeHead(const Words& words) {
    return {words.translate("BobWeights", "Plane"),    words.translate("BobWeights", "Work"),
            words.translate("BobWeights", "Diameter"), words.translate("BobWeights", "Depth"),
            words.translate("BobWeights", "Angle"),    words.translate("BobWeights", "Takes off")};
}

QVector<QStringList> holes(const Words& words, const Result& result) {
    QVector<QStringList> rows;
    if (!result.correction) {
        return rows;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const auto add = [&](const Hole& hole, const QString& work, double sign) {
            rows << QStringList{planeName(words, i),
                                work,
                                words.number(hole.diameter, units::mm, 1),
                                words.number(hole.depth, units::mm, 1),
                                degreesOf(words, hole.angle),
                                words.number(sign * hole.mass, units::gram, 2)};
        };
        for (const Hole& hole : (*result.correction)[i].holes) {
            add(hole, words.translate("BobWeights", "drill"), 1.0);
        }
        for (const Hole& slug : (*result.correction)[i].slugs) {
            add(slug, words.translate("BobWeights", "press in a slug"), -1.0);
        }
    }
    return rows;
}

}  // namespace ravnoves::bob_text
