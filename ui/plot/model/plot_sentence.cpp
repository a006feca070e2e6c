#include "plot/model/plot_sentence.h"

#include <QCoreApplication>
#include <algorithm>

#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

/// Its words.
struct PlotSentence {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::PlotSentence)
};

using plot::Shape;

namespace {

constexpr std::size_t maxCurves = 8;  ///< of a longer list nobody keeps the first in mind

/// Numbers of one axis with their unit.
struct Spoken {
    const PlotScale& scale;
    const QLocale& locale;

    QString number(double value) const { return scale.readout(value, locale); }
    QString withUnit(double value) const {
        return ravnoves::withUnit(number(value), unitOfTitle(scale.spec.title));
    }
};

/// The name of an axis without its unit.
QString nameOf(const PlotScale& scale) {
    const QString& title = scale.spec.title;
    const QString unit = unitOfTitle(title);
    return unit.size() + 2 <= title.size() ? title.chopped(unit.isEmpty() ? 0 : unit.size() + 2)
                                           : QString();
}

QString curveSentence(const PlotData& data, const PlotCurve& curve) {
    const Spoken x{data.x, data.locale};
    const Spoken y{data.left, data.locale};
    const auto [minimum, maximum] = std::minmax_element(curve.y.begin(), curve.y.end());
    const auto at = [&](auto place) {
        return curve.x[static_cast<std::size_t>(place - curve.y.begin())];
    };
    const bool hasPoints = curve.style.shape == Shape::Points || curve.style.shape == Shape::Rings;
    if (curve.y.size() == 1) {
        return PlotSentence::tr("%1 at %2").arg(y.withUnit(*minimum), x.withUnit(curve.x.front()));
    }
    if (y.number(*minimum) == y.number(*maximum)) {
        return PlotSentence::tr("constant, %1").arg(y.withUnit(*minimum));
    }
    if (!curve.ascending) {
        const auto [first, last] = std::minmax_element(curve.x.begin(), curve.x.end());
        return PlotSentence::tr("across from %1 to %2, up from %3 to %4")
            .arg(x.number(*first), x.withUnit(*last), y.number(*minimum), y.withUnit(*maximum));
    }
    const bool rises = std::is_sorted(curve.y.begin(), curve.y.end());
    if (!hasPoints && (rises || std::is_sorted(curve.y.rbegin(), curve.y.rend()))) {
        return (rises ? PlotSentence::tr("rises from %1 at %2 to %3 at %4")
                      : PlotSentence::tr("falls from %1 at %2 to %3 at %4"))
            .arg(y.number(curve.y.front()), x.withUnit(curve.x.front()), y.withUnit(curve.y.back()),
                 x.withUnit(curve.x.back()));
    }
    return PlotSentence::tr("from %1 at %2 to %3 at %4")
        .arg(y.number(*minimum), x.withUnit(at(minimum)), y.withUnit(*maximum),
             x.withUnit(at(maximum)));
}

}  // namespace

QString plotSentence(const PlotData& data) {
    const Spoken x{data.x, data.locale};
    const QString axis = nameOf(data.x);
    QString sentence = PlotSentence::tr("Over %1 from %2 to %3.")
                           .arg(axis.isEmpty() ? QStringLiteral("x") : axis, x.number(data.x.low),
                                x.withUnit(data.x.high));
    QStringList curves;
    std::size_t left = 0;
    for (const PlotCurve& curve : data.curves) {
        if (!curve.shown || curve.y.empty()) {
            continue;
        }
        if (static_cast<std::size_t>(curves.size()) == maxCurves) {
            ++left;
            continue;
        }
        QString name = curve.style.name;
        if (name.isEmpty()) {
            name = nameOf(data.left);
        }
        curves << (name.isEmpty() ? QString() : name + QStringLiteral(": ")) +
                      curveSentence(data, curve);
    }
    if (data.curves.empty() || (curves.isEmpty() && data.image.isNull())) {
        return sentence + QLatin1Char(' ') + PlotSentence::tr("No data.");
    }
    if (!curves.isEmpty()) {
        sentence += QLatin1Char(' ') + curves.join(QStringLiteral("; "));
        sentence += left > 0 ? PlotSentence::tr("; and %1 more.").arg(left) : QStringLiteral(".");
    }
    if (data.spreadShown && data.hasSpread()) {
        sentence +=
            QLatin1Char(' ') + PlotSentence::tr("With bands: 5…95 % due to the tolerances.");
    }
    QStringList marks;
    for (const plot::Mark& mark : data.marks) {
        if (!mark.text.isEmpty() && static_cast<std::size_t>(marks.size()) < maxCurves) {
            QString text = mark.text;
            marks << text.replace(QLatin1Char('\n'), QStringLiteral(", "));
        }
    }
    if (!marks.isEmpty()) {
        sentence += QLatin1Char(' ') +
                    PlotSentence::tr("Marked: %1.").arg(marks.join(QStringLiteral("; ")));
    }
    if (data.presentX) {
        sentence +=
            QLatin1Char(' ') + PlotSentence::tr("Now at %1.").arg(x.withUnit(*data.presentX));
    }
    return sentence;
}

}  // namespace ravnoves
