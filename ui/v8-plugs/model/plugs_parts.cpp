#include "v8-plugs/model/plugs_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "v8-plugs/compensation.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/model/weighing_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int todayColour = 6;  ///< of this job, and of this engine

/// The excess that each option compensates over the lightening of one plug: the paper's lines
/// (15)–(18) up to their limits, today's excess, and the point of the option chosen.
Figure compensation(const V8PlugsModel& model) {
    using units::gram;
    const Words words;
    const Result& solution = model.solution();
    double reach = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    Figure figure;
    figure.title = CompensationPlot::tr("Excess compensated");
    figure.left = {.title = CompensationPlot::tr("Δmᵤ, g")};
    std::vector<plot::Mark>& marks = figure.marks.emplace();
    for (const OptionId id : all_options) {
        Figure::Curve& curve = figure.curves.emplace_back();
        curve.id = option_word(id).word;
        curve.style = {.name = v8_names::shortOption(words, id),
                       .colour = static_cast<int>(id),
                       .width = 2.0,
                       .toolTip = v8_names::optionName(words, id)};
        const auto& option = solution.option(id);
        if (!option) {
            continue;
        }
        const double most = option->max_reduction / gram;
        curve.x = {0.0, most};
        curve.y = {option->constant / gram, option->maximum / gram};
        marks.push_back({most, option->maximum / gram, words.digits(option->maximum, gram, 2),
                         static_cast<int>(id)});
        reach = std::max(reach, most);
        lowest = std::min(lowest, option->constant / gram);
        highest = std::max(highest, option->maximum / gram);
    }
    // Where this job stands: its excess, and the point of the chosen option.
    if (solution.unbalanced_mass) {
        const double today = *solution.unbalanced_mass / gram;
        figure.lines.push_back({today, Qt::Horizontal, todayColour,
                                CompensationPlot::tr("today %1")
                                    .arg(words.digits(*solution.unbalanced_mass, gram, 2))});
        lowest = std::min(lowest, today);
        highest = std::max(highest, today);
    }
    if (highest > lowest) {
        figure.leftRange = std::pair(lowest, highest + 0.16 * (highest - lowest));
    }
    if (const auto chosen = v8_text::chosenOption(solution)) {
        marks.push_back({.x = chosen->reduction / gram,
                         .y = (chosen->constant + chosen->slope * chosen->reduction) / gram,
                         .text = {},
                         .colour = static_cast<int>(chosen->id),
                         .ring = true});
    }
    figure.x = {.title = CompensationPlot::tr("lightening of one plug Δm, g"),
                .min = 0.0,
                .max = reach > 0.0 ? 1.25 * reach : 1.0};
    return figure;
}

/// What a shift Δr of the plug's centre of mass does to the coefficient, Δk = Δr / r, for the five
/// crank radii of the paper's Fig. 2 and for this engine's.
Figure shift(const V8PlugsModel& model) {
    using units::mm;
    constexpr double widest = 1.4;  // right end of the x axis, mm
    const auto line = [](double crankRadius) {
        return std::vector{0.0, shift_coefficient(widest * mm, crankRadius)};
    };
    const Words words;
    Figure figure;
    figure.title = ShiftPlot::tr("Shift of the plug's centre of mass");
    figure.x = {.title = ShiftPlot::tr("Δr, mm"), .min = 0.0, .max = widest};
    figure.left = {.title = ShiftPlot::tr("Δk")};
    figure.leftRange = std::pair(0.0, 0.04);  // with room for the word over the lines
    figure.bands = {{smallest_shift / mm, largest_shift / mm, plot::AccentInk, 0.12,
                     ShiftPlot::tr("neglected")}};
    const std::optional<double>& own = model.input().engine.crank_radius;
    bool isListed = false;
    for (std::size_t i = 0; i < shift_curves.size(); ++i) {
        const ShiftCurve& printed = shift_curves[i];
        const QString radius = words.plainWithUnit(printed.crank_radius, mm, 1);
        const QString engines = QString::fromUtf8(printed.engines.data(),
                                                  static_cast<qsizetype>(printed.engines.size()));
        figure.curves.push_back(
            {.id = "radius-" + std::to_string(i),
             .style = {.name = radius,
                       .colour = static_cast<int>(i),
                       .toolTip = ShiftPlot::tr("r = %1: %2").arg(radius, engines)},
             .x = {0.0, widest},
             .y = line(printed.crank_radius)});
        isListed = isListed || (own && std::abs(printed.crank_radius - *own) < 1e-6);
    }
    std::vector<plot::Mark>& marks = figure.marks.emplace();
    if (!own) {
        return figure;
    }
    if (!isListed) {
        figure.curves.push_back({.id = "own",
                                 .style = {.name = ShiftPlot::tr("this engine"),
                                           .colour = todayColour,
                                           .width = 2.4,
                                           .pen = Qt::DashLine,
                                           .inLegend = false},
                                 .x = {0.0, widest},
                                 .y = line(*own)});
    }
    for (const double each : {smallest_shift, largest_shift}) {
        const double k = shift_coefficient(each, *own);
        marks.push_back({.x = each / mm,
                         .y = k,
                         .text = words.number(k, 3),
                         .colour = todayColour,
                         .ring = true});
    }
    return figure;
}

Notes notes(const V8PlugsModel& model) {
    const Result& solution = model.solution();
    const Words words;
    const bool isDoubted = solution.advice && v8_text::doubtsWeights(model.input());
    const bool isUneven = v8_text::hasUnequalCrankpins(model.input(), solution);
    const bool shifts = solution.shift_that_matters() != nullptr;
    const auto warnWhere = [](bool doubtful) {
        return doubtful ? Severity::warning : Severity::note;
    };
    Notes notes;
    if (solution.before) {
        notes.say(warnWhere(isUneven || isDoubted), model.excessText());
    }
    notes.say(v8_text::adviceSeverity(model.input(), solution), model.adviceText());
    notes.say(Severity::note, model.boringText());
    notes.say(warnWhere(isDoubted), model.hangText());
    notes.say(Severity::note, model.plugsText());
    notes.say(Severity::warning, model.troubles());
    if (solution.before) {
        const auto weighing = v8_text::weighingNote(words, model.input());
        notes.say(warnWhere(shifts), QStringList{model.checkText(), model.rodFactorText()});
        notes.say(warnWhere(!weighing.enough), weighing.text);
    }
    notes.say(Severity::note, model.shiftText());
    return notes;
}

/// What is to be done with the parts.
Notes matching(const V8PlugsModel& model) {
    Notes notes;
    notes.say(Severity::note, QStringList(model.assignmentText()) + model.assignmentRemarks());
    return notes;
}

Notes limits(const V8PlugsModel& model) {
    Notes notes;
    if (model.solution().balancing) {
        notes.say(Severity::note, QStringList{model.isoText(), model.machineLimitsText()});
    }
    return notes;
}

using Maker = PartMaker<V8PlugsModel>;
constexpr std::array makers{
    Maker{{.id = "notes", .isAnswer = true}, made<notes>},
    Maker{{.id = "options", .isAnswer = true}, made<&V8PlugsModel::optionResults>},
    Maker{{.id = "bob-weights", .isAnswer = true}, made<&V8PlugsModel::bobWeightResults>},
    Maker{{.id = "compensation"}, made<compensation>},
    Maker{{.id = "shift"}, made<shift>},
    Maker{{.id = "matching", .tab = "sheet-3"}, made<matching>},
    Maker{{.id = "effects", .tab = "sheet-3"}, made<&V8PlugsModel::effectResults>},
    Maker{{.id = "assignment", .tab = "sheet-3"}, made<&V8PlugsModel::assignmentResults>},
    Maker{{.id = "take-off", .tab = "sheet-3"}, made<&V8PlugsModel::takeOffResults>},
    Maker{{.id = "crankpins", .tab = "sheet-3"}, made<&V8PlugsModel::crankpinResults>},
    Maker{{.id = "planes", .tab = "sheet-5", .isAnswer = true}, made<&V8PlugsModel::planeResults>},
    Maker{{.id = "limits", .tab = "sheet-5"}, made<limits>},
};

}  // namespace

std::span<const PagePart> plugsParts() {
    return partsOf(makers);
}

Content plugsPart(const V8PlugsModel& model, std::string_view id) {
    return makePart(makers, model, id);
}

}  // namespace ravnoves
