#include "v8-plugs/shift_plot.h"

#include <algorithm>
#include <cmath>

#include "text/number_text.h"
#include "theme/theme.h"
#include "v8-plugs/compensation.h"
#include "v8-plugs/model/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {
using units::mm;
constexpr double widest = 1.4;  // right end of the x axis, mm
constexpr int ownColour = 6;

/// The ends of a line through the origin.
std::vector<double> ends(double crankRadius) {
    return {0.0, shift_coefficient(widest * mm, crankRadius)};
}
}  // namespace

ShiftPlot::ShiftPlot(QWidget* parent) : PlotView(tr("Shift of the plug's centre of mass"), parent) {
    const Words words;
    setAccessibleName(tr("Coefficient Δk over the shift Δr for five crank radii"));
    setXAxis({tr("Δr, mm"), 0.0, widest});
    setYAxis(Side::Left, {tr("Δk")});
    for (std::size_t i = 0; i < shift_curves.size(); ++i) {
        const ShiftCurve& printed = shift_curves[i];
        CurveStyle style;
        style.name = words.plainWithUnit(printed.crank_radius, mm, 1);
        style.toolTip =
            tr("r = %1: %2")
                .arg(style.name, QString::fromUtf8(printed.engines.data(),
                                                   static_cast<qsizetype>(printed.engines.size())));
        style.colour = static_cast<int>(i);
        setCurve(addCurve(style), {0.0, widest}, ends(printed.crank_radius));
    }
    CurveStyle own;
    own.name = tr("this engine");
    own.colour = ownColour;
    own.width = 2.4;
    own.pen = Qt::DashLine;
    own.inLegend = false;
    own_ = addCurve(own);
    setYRange(Side::Left, 0.0, 0.04);  // with room for the word over the lines
    setBands({{smallest_shift / mm, largest_shift / mm, plot::AccentInk, 0.12, tr("neglected")}});
}

void ShiftPlot::showRadius(const std::optional<double>& crankRadius) {
    const bool listed =
        crankRadius &&
        std::any_of(shift_curves.begin(), shift_curves.end(), [&](const ShiftCurve& curve) {
            return std::abs(curve.crank_radius - *crankRadius) < 1e-6;
        });
    std::vector<Mark> marks;
    if (crankRadius) {
        setCurve(own_, {0.0, widest}, ends(*crankRadius));
        const Words words;
        for (const double shift : {smallest_shift, largest_shift}) {
            const double k = shift_coefficient(shift, *crankRadius);
            marks.push_back({shift / mm, k, words.number(k, 3), ownColour, Side::Left, true});
        }
    }
    setCurveShown(own_, crankRadius.has_value() && !listed);
    setMarks(std::move(marks));
}

}  // namespace ravnoves
