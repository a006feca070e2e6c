#include "bob-weights/model/bob_parts.h"

#include <algorithm>
#include <array>

#include "bob-weights/model/bob_text.h"
#include "bob-weights/model/bob_weights_model.h"
#include "text/number_text.h"

namespace ravnoves {

using bob_weights::FirstOrder;

namespace {

/// The first-order force of the cylinders that a bob weight stands for, over a turn of the crank:
/// without counterweights, and what is left of it with them. As masses at the crank radius, g.
Figure force(const BobWeightsModel& model) {
    const QString gram = unitText(units::gram.name);
    Figure figure;
    figure.title = ForcePlot::tr("First-order force");
    figure.equalScale = true;
    figure.x = {.title = ForcePlot::tr("across, %1").arg(gram)};
    figure.left = {.title = ForcePlot::tr("upright, %1").arg(gram)};
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
        reach = std::max(reach, shown->greatest() / units::gram);
    };
    const bob_weights::Result& solution = model.solution();
    add("bare",
        {.name = ForcePlot::tr("without counterweights"),
         .colour = 1,
         .pen = Qt::DashLine,
         .toolTip =
             ForcePlot::tr("Of the reciprocating parts alone, as a mass at the crank radius"),
         .turn = 360.0},
        solution.first_order_bare);
    add("left",
        {.name = ForcePlot::tr("left"),
         .width = 2.2,
         .toolTip = ForcePlot::tr("What is left by counterweights that hold the bob weight"),
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

Notes notes(const BobWeightsModel& model) {
    const bob_weights::Result& solution = model.solution();
    const bool isDoubted = !model.doubts().isEmpty();
    Notes notes;
    notes.say(isDoubted ? Severity::warning : Severity::note, model.headline());
    notes.say(Severity::note, model.hangText());
    notes.say(solution.holds() ? Severity::note : Severity::warning, model.verdictText());
    if (solution.bob_weight) {
        notes.say(Severity::note, model.factorText());
    }
    notes.say(Severity::note,
              QStringList{model.limitText(), bob_text::weighing(Words(), model.input(), solution)});
    notes.say(Severity::warning, model.troubles());
    return notes;
}

/// Of readings, holes, and what was drilled before.
Notes holeNotes(const BobWeightsModel& model) {
    Notes notes;
    notes.say(Severity::note,
              QStringList{bob_text::asReadNote(Words(), model.input(), model.solution()),
                          model.holeNote(), model.drilledNote()});
    return notes;
}

/// What is to be done with the parts.
Notes matching(const BobWeightsModel& model) {
    Notes notes;
    notes.say(Severity::note, QStringList(model.assignmentText()) + model.assignmentRemarks());
    return notes;
}

using Maker = PartMaker<BobWeightsModel>;
constexpr std::array makers{
    Maker{{.id = "notes", .isAnswer = true}, made<notes>},
    Maker{{.id = "lines", .isAnswer = true}, made<&BobWeightsModel::lineResults>},
    Maker{{.id = "runs", .isAnswer = true}, made<&BobWeightsModel::runResults>},
    Maker{{.id = "planes", .isAnswer = true}, made<&BobWeightsModel::planeResults>},
    Maker{{.id = "holes", .isAnswer = true}, made<&BobWeightsModel::holeResults>},
    Maker{{.id = "drilled", .isAnswer = true}, made<&BobWeightsModel::drilledResults>},
    Maker{{.id = "hole-notes", .isAnswer = true}, made<holeNotes>},
    Maker{{.id = "force"}, made<force>},
    Maker{{.id = "matching", .tab = "sheet-3"}, made<matching>},
    Maker{{.id = "effects", .tab = "sheet-3"}, made<&BobWeightsModel::effectResults>},
    Maker{{.id = "assignment", .tab = "sheet-3"}, made<&BobWeightsModel::assignmentResults>},
    Maker{{.id = "take-off", .tab = "sheet-3"}, made<&BobWeightsModel::takeOffResults>},
};

}  // namespace

std::span<const PagePart> bobParts() {
    return partsOf(makers);
}

Content bobPart(const BobWeightsModel& model, std::string_view id) {
    return makePart(makers, model, id);
}

}  // namespace ravnoves
