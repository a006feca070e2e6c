#include "workshop/model/workshop_parts.h"

#include <algorithm>
#include <array>

#include "bob-weights/solver.h"
#include "shop/model/scale_settings.h"
#include "shop/weighing.h"
#include "text/number_text.h"
#include "v8-plugs/compensation.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

using bob_weights::FirstOrder;

namespace {

/// The first-order force of the cylinders that a bob weight represents, over a turn of the crank:
/// without counterweights, and what is left of it with them. As masses at the crank radius, g.
Figure force(const WorkshopModel& model) {
    const QString gram = unitText(units::gram.name);
    Figure figure;
    figure.title = ForcePlot::tr("First-order force");
    figure.equalScale = true;
    figure.x = {.title = ForcePlot::tr("horizontal, %1").arg(gram)};
    figure.left = {.title = ForcePlot::tr("vertical, %1").arg(gram)};
    double reach = 0.0;
    const auto add = [&](const char* id, plot::CurveStyle style,
                         const std::optional<FirstOrder>& shown) {
        Figure::Curve& curve = figure.curves.emplace_back();
        curve.id = id;
        curve.style = std::move(style);
        if (!shown) {
            return;
        }
        bob_weights::ForcePath path = bob_weights::force_path(*shown);
        for (std::vector<double>* masses : {&path.across, &path.upright}) {
            for (double& mass : *masses) {
                mass = mass / units::gram;
            }
        }
        curve.x = std::move(path.across);
        curve.y = std::move(path.upright);
        reach = std::max(reach, shown->maximum() / units::gram);
    };
    const bob_weights::Result& solution = model.solution();
    add("bare",
        {.name = ForcePlot::tr("without counterweights"),
         .role = Role::Engine,
         .toolTip = ForcePlot::tr("Reciprocating parts only, as a mass at the crank radius"),
         .turn = 360.0},
        solution.first_order_bare);
    add("left",
        {.name = ForcePlot::tr("with counterweights"),
         .role = Role::Sum,
         .width = 2.2,
         .toolTip = ForcePlot::tr("Residual with counterweights for this bob weight"),
         .turn = 360.0},
        solution.first_order);
    if (reach > 0.0) {
        constexpr double room = 1.265;
        figure.x.min = -room * reach;
        figure.x.max = room * reach;
        figure.leftRange = std::pair(-room * reach, room * reach);
    }
    return figure;
}

/// The excess that each option compensates over the lightening of one plug: the paper's lines
/// (15)–(18) up to their limits, today's excess, and the point of the option chosen.
Figure compensation(const WorkshopModel& model) {
    using units::gram;
    // In the order of their enumeration.
    static constexpr std::array names{
        QT_TRANSLATE_NOOP("V8", "steel"), QT_TRANSLATE_NOOP("V8", "aluminium"),
        QT_TRANSLATE_NOOP("V8", "new: steel"), QT_TRANSLATE_NOOP("V8", "new: its own"),
        QT_TRANSLATE_NOOP("V8", "new: aluminium")};
    const Words words;
    Figure figure;
    if (model.plugs() == nullptr) {
        return figure;
    }
    const v8_plugs::Result& solution = *model.plugs();
    double reach = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    figure.title = CompensationPlot::tr("Excess compensated");
    figure.left = {.title = CompensationPlot::tr("Δmᵤ, g")};
    std::vector<plot::Mark>& marks = figure.marks.emplace();
    for (const v8_plugs::OptionId id : v8_plugs::all_options) {
        Figure::Curve& curve = figure.curves.emplace_back();
        curve.id = v8_plugs::option_word(id).word;
        curve.style = {.name = words.translate("V8", names.at(static_cast<std::size_t>(id))),
                       .role = series(static_cast<int>(id)),
                       .width = 2.0,
                       .toolTip = v8_text::optionName(words, id)};
        const auto& option = solution.option(id);
        if (!option) {
            continue;
        }
        const double maximum = option->max_reduction / gram;
        curve.x = {0.0, maximum};
        curve.y = {option->constant / gram, option->maximum / gram};
        marks.push_back({maximum, option->maximum / gram, words.digits(option->maximum, gram, 2),
                         series(static_cast<int>(id))});
        reach = std::max(reach, maximum);
        lowest = std::min(lowest, option->constant / gram);
        highest = std::max(highest, option->maximum / gram);
    }
    // Where this job stands: its excess, and the point of the chosen option.
    if (solution.unbalanced_mass) {
        const double today = *solution.unbalanced_mass / gram;
        figure.lines.push_back({today, Qt::Horizontal, Role::Present,
                                CompensationPlot::tr("present %1")
                                    .arg(words.digits(*solution.unbalanced_mass, gram, 2))});
        lowest = std::min(lowest, today);
        highest = std::max(highest, today);
    }
    if (highest > lowest) {
        figure.leftRange = std::pair(lowest, highest + 0.16 * (highest - lowest));
    }
    if (const auto* chosen = solution.chosen()) {
        marks.push_back({.x = chosen->reduction / gram,
                         .y = (chosen->constant + chosen->slope * chosen->reduction) / gram,
                         .text = {},
                         .role = series(static_cast<int>(chosen->id)),
                         .ring = true});
    }
    figure.x = {.title = CompensationPlot::tr("lightening of one plug Δm, g"),
                .min = 0.0,
                .max = reach > 0.0 ? 1.25 * reach : 1.0};
    return figure;
}

Notes linesOf(const WorkshopModel& model, std::string_view part) {
    Notes notes;
    for (const AnswerLine& line : answerLines(model)) {
        if (line.part == part) {
            notes.say(line.severity, line.texts);
        }
    }
    return notes;
}
/// What is to be done with the parts.
Notes matching(const WorkshopModel& model) {
    Notes notes;
    notes.say(Severity::note, QStringList(model.assignmentText()) + model.assignmentRemarks());
    return notes;
}

/// A table in the language of the page.
template <auto make>
Results inWords(const WorkshopModel& model) {
    return (model.*make)(Words());
}

/// Of what is to be drilled, which a rejected entry stops.
template <auto make>
Content ofShown(const WorkshopModel& model) {
    return made<make>(model.shown());
}

Results holes(const WorkshopModel& model) {
    return model.holeResults();
}

using Maker = PartMaker<WorkshopModel>;
constexpr std::array makers{
    Maker{{.id = "notes", .isAnswer = true},
          [](const WorkshopModel& model) -> Content { return linesOf(model, "notes"); }},
    Maker{{.id = "planes", .isAnswer = true}, ofShown<inWords<&WorkshopModel::planeResults>>},
    Maker{{.id = "holes", .isAnswer = true}, ofShown<holes>},
    Maker{{.id = "hole-notes", .isAnswer = true},
          [](const WorkshopModel& model) -> Content { return linesOf(model, "hole-notes"); }},
    Maker{{.id = "runs", .isAnswer = true}, ofShown<&WorkshopModel::runResults>},
    Maker{{.id = "drilled", .isAnswer = true}, ofShown<inWords<&WorkshopModel::drilledResults>>},
    Maker{{.id = "options", .isAnswer = true}, made<&WorkshopModel::optionResults>},
    Maker{{.id = "lines", .isAnswer = true}, made<inWords<&WorkshopModel::lineResults>>},
    Maker{{.id = "force"}, made<force>},
    Maker{{.id = "compensation"}, made<compensation>},
    Maker{{.id = "matching", .tab = "sheet-3"}, made<matching>},
    Maker{{.id = "effects", .tab = "sheet-3"}, made<inWords<&WorkshopModel::effectResults>>},
    Maker{{.id = "assignment", .tab = "sheet-3"}, made<inWords<&WorkshopModel::assignmentResults>>},
    Maker{{.id = "take-off", .tab = "sheet-3"}, made<inWords<&WorkshopModel::takeOffResults>>},
};

}  // namespace

namespace {

/// What the last digit of the scale leaves uncertain; empty where that is not known.
QString weighingNote(const WorkshopModel& model) {
    const double resolution = ScaleSettings::load().resolution;
    if (!model.solution().bob_weight || resolution <= 0.0) {
        return {};
    }
    const Words words;
    const auto digit = [&](double mass) { return words.plainWithUnit(mass, units::gram, 6); };
    const auto weight = [&](double mass) { return words.number(mass, units::gram, 2); };
    QStringList said;
    shop::Weighing found{};
    std::optional<double> limit;
    std::optional<double> radius;
    if (model.hasPlugs()) {
        const v8_plugs::Input& plugs = *model.plugsInput();
        limit = plugs.tolerance;
        radius = plugs.engine.crank_radius;
        found = shop::weighing(resolution, rounding_squares(plugs), limit);
        said << words
                    .translate("V8",
                               "Weighed to %1, the bob weight is accurate to ±%2 and the "
                               "unbalance of a crankpin to ±%3 (95 %).")
                    .arg(digit(resolution), weight(found.bob_weight),
                         words.number(found.bob_weight * radius.value(), units::gram_mm, 1));
    } else {
        const bob_weights::Result& result = model.solution();
        const auto& sheet = model.input().weigh_in;
        limit = result.permissible ? std::optional(std::ranges::min(*result.permissible))
                                   : std::nullopt;
        radius = sheet ? sheet->matching.crank_radius : std::nullopt;
        found = shop::weighing(resolution, rounding_squares(model.input(), result), limit);
        said << words
                    .translate("BobWeights",
                               "Weighed to %1, a bob weight is accurate to ±%2 (95 %).")
                    .arg(digit(resolution), weight(found.bob_weight));
    }
    if (found.largest_radius && radius) {
        const QString tolerance = words.number(*limit, units::gram_mm, 0);
        said << (found.is_enough(*radius)
                     ? words.translate("V8", "This is enough for the tolerance of %1.")
                           .arg(tolerance)
                     : words
                           .translate("V8",
                                      "This is too coarse for the tolerance of %1: use a scale "
                                      "with a last digit of %2.")
                           .arg(tolerance, digit(found.coarsest(*radius))));
    }
    return said.join(QLatin1Char(' '));
}

}  // namespace

std::vector<AnswerLine> answerLines(const WorkshopModel& model) {
    const bool hasFactor = model.solution().bob_weight && !model.hasPlugs();
    const WorkshopModel& shown = model.shown();
    std::vector<AnswerLine> lines{
        // The page alone shows these two apart: the first line of a copy, tables and verdict have
        // them.
        {"rejected", Severity::warning, {model.rejectedText()}, {}},
        {"headline",
         model.withheld().bob_weight ? Severity::error : Severity::note,
         {model.headline()}},
        {"correction", Severity::note, {shown.correctionText()}, {}},
        {"hang", Severity::note, {model.hangText()}},
        {"factor", Severity::note, {hasFactor ? model.factorText() : QString()}},
        {"limits", Severity::note, QStringList{model.limitText(), weighingNote(model)}},
        {"troubles", Severity::warning, model.troubles()},
        {"doubtful", Severity::error, {model.doubtfulText()}},
        {"advice", Severity::note, {model.adviceText()}},
        {"boring", Severity::note, {model.boringText()}},
        {"excess", Severity::note, {model.excessText()}},
        {"check", Severity::note, {model.checkText()}},
        // By another convention a hole is drilled on the wrong side.
        {"convention",
         Severity::note,
         {model.solution().newest() != nullptr ? shown.machineText() : QString()},
         "hole-notes"},
        {"as_read_note", Severity::note, {shown.asReadNote()}, "hole-notes"},
        {"hole_note", Severity::note, {shown.holeNote()}, "hole-notes"}};
    for (AnswerLine& line : lines) {
        line.texts.removeAll(QString());
    }
    return lines;
}

std::span<const PagePart> workshopParts() {
    return partsOf(makers);
}

Content workshopPart(const WorkshopModel& model, std::string_view id) {
    return makePart(makers, model, id);
}

}  // namespace ravnoves
