#include "v8-plugs/compensation_plot.h"

#include <algorithm>

#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {
using units::gram;
constexpr int todayColour = 6;
}  // namespace

CompensationPlot::CompensationPlot(QWidget* parent) : PlotView(tr("Excess compensated"), parent) {
    const Words words;
    setAccessibleName(tr("Excess compensated over the lightening of one plug"));
    setYAxis(Side::Left, {tr("Δmᵤ, g")});
    for (const OptionId id : all_options) {
        CurveStyle style;
        style.name = v8_names::shortOption(words, id);
        style.toolTip = v8_names::optionName(words, id);
        style.colour = static_cast<int>(id);
        style.width = 2.0;
        curves_.push_back(addCurve(style));
    }
}

void CompensationPlot::showSolution(const Result& solution) {
    const Words words;
    double reach = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    std::vector<Mark> marks;
    for (const OptionId id : all_options) {
        const auto i = static_cast<std::size_t>(id);
        const auto& option = solution.options[i];
        if (!option) {
            setCurve(curves_[i], {}, {});
            continue;
        }
        const double most = option->max_reduction / gram;
        setCurve(curves_[i], {0.0, most}, {option->constant / gram, option->maximum / gram});
        marks.push_back({most, option->maximum / gram, words.digits(option->maximum, gram, 2),
                         static_cast<int>(i)});
        reach = std::max(reach, most);
        lowest = std::min(lowest, option->constant / gram);
        highest = std::max(highest, option->maximum / gram);
    }
    // Where this job stands: its excess, and the point of the chosen option.
    std::vector<Line> lines;
    if (solution.unbalanced_mass) {
        const double today = *solution.unbalanced_mass / gram;
        lines.push_back({today, Qt::Horizontal, todayColour,
                         tr("today %1").arg(words.digits(*solution.unbalanced_mass, gram, 2))});
        lowest = std::min(lowest, today);
        highest = std::max(highest, today);
    }
    if (highest > lowest) {
        setYRange(Side::Left, lowest, highest + 0.16 * (highest - lowest));
    }
    if (const auto chosen = v8_text::chosenOption(solution)) {
        marks.push_back({chosen->reduction / gram,
                         (chosen->constant + chosen->slope * chosen->reduction) / gram,
                         {},
                         static_cast<int>(chosen->id),
                         Side::Left,
                         true});
    }
    const double wanted = reach > 0.0 ? 1.25 * reach : 1.0;
    if (wanted != shownReach_) {
        shownReach_ = wanted;
        setXAxis({tr("lightening of one plug Δm, g"), 0.0, wanted});
    }
    setLines(std::move(lines));
    setMarks(std::move(marks));
}

}  // namespace ravnoves
