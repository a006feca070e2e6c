#include <QCoreApplication>
#include <algorithm>

#include "plot/model/plot_data.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

/// Its words.
struct PlotSentence {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::PlotSentence)
};

QString PlotData::sentence() const {
    const auto number = [this](const PlotScale& scale, double value) {
        return scale.readout(value, locale);
    };
    const auto measured = [&](const PlotScale& scale, double value) {
        return withUnit(number(scale, value), unitOfTitle(scale.spec.title));
    };
    const auto nameOf = [](const PlotScale& scale) {
        const QString& title = scale.spec.title;
        return unitOfTitle(title) == title ? QString() : title.section(QLatin1Char(','), 0, 0);
    };
    const QString axis = nameOf(x);
    QStringList sentences{PlotSentence::tr("Over %1 from %2 to %3.")
                              .arg(axis.isEmpty() ? QStringLiteral("x") : axis, number(x, x.low),
                                   measured(x, x.high))};
    QStringList shown;
    for (const PlotCurve& curve : curves) {
        if (!curve.shown || curve.y.empty()) {
            continue;
        }
        const auto [minimum, maximum] = std::minmax_element(curve.y.begin(), curve.y.end());
        const auto at = [&](auto place) {
            return measured(x, curve.x[static_cast<std::size_t>(place - curve.y.begin())]);
        };
        const QString low = number(left, *minimum);
        const QString high = measured(left, *maximum);
        const QString name = curve.style.name.isEmpty() ? nameOf(left) : curve.style.name;
        shown << (name.isEmpty() ? QString() : name + QStringLiteral(": ")) +
                     (curve.y.size() == 1 ? PlotSentence::tr("%1 at %2").arg(high, at(maximum))
                      : low == number(left, *maximum)
                          ? PlotSentence::tr("constant, %1").arg(high)
                          : PlotSentence::tr("from %1 at %2 to %3 at %4")
                                .arg(low, at(minimum), high, at(maximum)));
    }
    if (!shown.isEmpty()) {
        sentences << shown.join(QStringLiteral("; ")) + QLatin1Char('.');
    } else if (image.isNull()) {
        sentences << PlotSentence::tr("No data.");
    }
    QStringList marked;
    for (const plot::Mark& mark : marks) {
        if (!mark.text.isEmpty()) {
            marked << QString(mark.text).replace(QLatin1Char('\n'), QStringLiteral(", "));
        }
    }
    if (!marked.isEmpty()) {
        sentences << PlotSentence::tr("Marked: %1.").arg(marked.join(QStringLiteral("; ")));
    }
    if (presentX) {
        sentences << PlotSentence::tr("Now at %1.").arg(measured(x, *presentX));
    }
    return sentences.join(QLatin1Char(' '));
}

}  // namespace ravnoves
