#include "elastic-hinge/hinge_inputs.h"

#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "elastic-hinge/fields.h"
#include "page/rejected_entries.h"
#include "pictures/file_dialogs.h"
#include "text/message_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::BranchSummary;
using elastic_hinge::Guide;
using elastic_hinge::Hinge;
using elastic_hinge::RodCounterweight;
using elastic_hinge::Spring;
namespace field = elastic_hinge::field;

namespace {

constexpr int massDigits = 6;  // of a mass that was a weight, or the other way round

}  // namespace

HingeInputs::HingeInputs(ElasticHingeModel* model, QWidget* parent)
    : Form(model, parent), model_(model) {
    addMechanism();
    addSprings();
    addCounterweight();
    section(tr("Making the guide"));
    addFilled("/roller_radius_mm");
    number("/profile_error_waves");
    addMotion();
    column()->addStretch();
}

template <typename Object>
void HingeInputs::addObjectBox(const Field& field, std::optional<Object> Input::*object,
                               const char* name, std::function<Object(const Input&)> usual) {
    box(
        QLatin1String(name), shownText(field.label), fieldHint(field),
        [this, object] { return (model_->input().*object).has_value(); },
        [=, this, step = fieldName(field)](bool on) {
            model_->edit(step, [&](Input& input) {
                input.*object = on ? std::optional(usual(input)) : std::nullopt;
            });
        });
}

void HingeInputs::showSectionWhile(std::function<bool(const Input&)> wanted) {
    follow([this, part = current(), wanted = std::move(wanted)] {
        part->setVisible(wanted(model_->input()));
    });
}

void HingeInputs::addMechanism() {
    section(tr("Mechanism"));
    choice(
        QStringLiteral("masses_given_as"), shownText(field::given_as.label),
        {shownTitle(tr("weights, N")).text, shownTitle(tr("masses, kg")).text},
        fieldHint(field::given_as), [this] { return model_->input().masses_as_weights ? 0 : 1; },
        [this](int index) {
            model_->edit(tr("Weights or masses"),
                         [index](Input& input) { input.masses_as_weights = index == 0; });
        });
    addMasses(true);
    addMasses(false);
    section({});
    number("/crank_radius_mm");
    choice("/kinematics");
}

void HingeInputs::addMasses(bool weights) {
    section({});
    showSectionWhile([weights](const Input& input) { return input.masses_as_weights == weights; });
    for (const char* part : {"crank", "rod", "slider"}) {
        const std::string pointer = (weights ? "/weights_N/" : "/masses_kg/") + std::string(part);
        NumberField* mass = number(pointer.c_str());
        mass->setDigits(massDigits);
        mass->setObjectName(QString::fromLatin1(part) +
                            (weights ? QLatin1String("_weight") : QLatin1String("_mass")));
    }
    auto* gravity = number(
        weights ? field::gravity : field::gravity_with_masses,
        [this] { return std::optional(model_->input().gravity); },
        [this](std::optional<double> value) { model_->setGravity(*value); });
    if (!weights) {
        gravity->setObjectName(QStringLiteral("gravity_with_masses"));
    }
}

void HingeInputs::addSprings() {
    section(tr("Springs and guides"));
    number(
        field::free_length,
        [this] {
            const auto& spring = model_->input().spring;
            return spring ? std::optional(spring->free_length) : std::nullopt;
        },
        [this](std::optional<double> value) {
            model_->editField("/spring/free_length_mm", from_si(field::free_length, *value),
                              fieldName(field::free_length));
        });
    choice("/guide_sign");
    addObjectBox<Spring>(field::rod_hinge_spring, &Input::rod_hinge_spring, "own_rod_spring",
                         [](const Input& input) { return input.spring.value_or(Spring{}); });
    section({});
    showSectionWhile([](const Input& input) { return input.rod_hinge_spring.has_value(); });
    for (const char* pointer :
         {"/rod_hinge_spring/stiffness_N_m", "/rod_hinge_spring/free_length_mm",
          "/rod_hinge_spring/guide_radius_at_zero_mm"}) {
        NumberField* field = number(pointer);
        field->setObjectName(QStringLiteral("rod_hinge_") + field->objectName());
    }
}

void HingeInputs::addCounterweight() {
    section(tr("Counterweight on the rod"));
    addObjectBox<RodCounterweight>(field::rod_counterweight, &Input::rod_counterweight,
                                   "rod_counterweight",
                                   [](const Input&) { return RodCounterweight{}; });
    for (const bool weights : {true, false}) {
        section({});
        showSectionWhile([weights](const Input& input) {
            return input.rod_counterweight && input.masses_as_weights == weights;
        });
        NumberField* mass =
            number(weights ? "/rod_counterweight/weight_N" : "/rod_counterweight/mass_kg");
        showAssumed(this, mass, [this, weights] {
            return std::optional(model_->result().design->mechanism().counterweight_mass *
                                 (weights ? model_->input().gravity : 1.0));
        });
        mass->setDigits(massDigits);
        mass->setObjectName(weights ? QStringLiteral("counterweight_weight")
                                    : QStringLiteral("counterweight_mass"));
    }
    section({});
    showSectionWhile([](const Input& input) { return input.rod_counterweight.has_value(); });
    choice("/rod_counterweight/inertia")->setObjectName(QStringLiteral("counterweight_inertia"));
}

void HingeInputs::addMotion() {
    section(tr("Motion"));
    addFilled("/motion/turns");
    showAssumed(this, number("/motion/start_speed_rad_s"),
                [this] { return std::optional(offSpeed(model_->input())); });
    addFilled("/motion/start_angle_deg");
    addFilled("/motion/crank_torque_Nm");
    flag("/motion/with_profile_error");
}

GuideSearchForm::GuideSearchForm(ElasticHingeModel* model, QWidget* parent) : Form(model, parent) {
    column()->setSpacing(Theme::space);
    column()->addWidget(
        captionLabel(tr("Finds stiffness and preload of minimum spring energy for the required "
                        "relief of the crank's guide; free length, roller and side of the spring "
                        "are kept."),
                     this));
    section(tr("Required"));
    number("/guide_search/relief_mm");
    number("/guide_search/outer_diameter_mm");
    number("/guide_search/smallest_spring_length_mm");
    number("/guide_search/preload_margin_mm");
    column()->addWidget(headingLabel(tr("Found"), this));
    auto* answer = new QLabel(this);
    answer->setWordWrap(true);
    answer->setTextInteractionFlags(Qt::TextSelectableByMouse);
    answer->setObjectName(QStringLiteral("search_answer"));
    column()->addWidget(answer);
    auto* take = new QPushButton(tr("Use &these values"), this);
    take->setObjectName(QStringLiteral("take_proposal"));
    take->setToolTip(tr("Sets c and ρ₀ to the values found"));
    column()->addWidget(take);
    column()->addStretch();
    connect(take, &QPushButton::clicked, model, &ElasticHingeModel::takeProposal);
    showAnswer_ = [=] {
        answer->setText(model->proposalText());
        take->setEnabled(model->proposal().found && !model->meetsWish());
    };
    follow([this] {
        if (isVisible()) {
            showAnswer_();
        }
    });
}

void GuideSearchForm::showEvent(QShowEvent* event) {
    showAnswer_();
    Form::showEvent(event);
}

GuideExportForm::GuideExportForm(ElasticHingeModel* model, QWidget* parent)
    : Form(model, parent), model_(model) {
    ElasticHingeModel::GuideExport& chosen = model->guideExport();
    column()->setSpacing(Theme::space);
    section(tr("Guide for the machine shop"));
    choice(
        QStringLiteral("export_hinge"), tr("&Hinge"), ElasticHingeModel::hingeNames(),
        tr("Hinge whose guide is written"), [&chosen] { return static_cast<int>(chosen.hinge); },
        [this, &chosen](int index) {
            chosen.hinge = static_cast<Hinge>(index);
            chosen.branch.reset();
            showAll();
        });
    choice(
        QStringLiteral("export_branch"), tr("S&pring"), {tr("compressed"), tr("stretched")},
        tr("Spring compressed or stretched"),
        [this] { return model_->exportedBranch() == Branch::compressed ? 0 : 1; },
        [this, &chosen](int index) {
            chosen.branch = index == 0 ? Branch::compressed : Branch::stretched;
            showGuide();
        });
    choice(
        QStringLiteral("export_turns"), tr("&What turns"), {tr("guide turns"), tr("spring turns")},
        tr("In the paper the guide turns with the crank and the spring is fixed: "
           "the drawing is the mirror image of the plot"),
        [&chosen] { return chosen.drawing.guide_turns ? 0 : 1; },
        [&chosen](int index) { chosen.drawing.guide_turns = index == 0; });
    number(
        field::chord_tolerance, [&chosen] { return chosen.drawing.chord_tolerance; },
        [&chosen](std::optional<double> value) { chosen.drawing.chord_tolerance = *value; });
    number(
        field::table_step, [&chosen] { return chosen.stepDeg * degree; },
        [&chosen](std::optional<double> value) {
            chosen.stepDeg = from_si(field::table_step, *value);
        });
    const auto button = [&](const char* name, const QString& label, const QString& hint,
                            const QString& suffix) {
        auto* write = new QPushButton(themedIcon(QStringLiteral("export")), label, this);
        write->setObjectName(QLatin1String(name));
        write->setToolTip(hint);
        column()->addWidget(write);
        connect(write, &QPushButton::clicked, this, [=, this] { ask(suffix); });
        return write;
    };
    dxf_ = button("export_dxf", tr("Write D&XF…"),
                  tr("Closed polylines in mm, 1:1: layers PROFILE, ROLLER_PATH, AXIS, NOTE"),
                  QStringLiteral("dxf"));
    csv_ = button("export_csv", tr("Write &CSV…"),
                  tr("Crank angle, polar angle, radius, x and y of path and profile; °, mm"),
                  QStringLiteral("csv"));
    note_ = captionLabel({}, this);
    column()->addWidget(note_);
    column()->addStretch();

    follow([this] { showGuide(); });
}

void GuideExportForm::showGuide() {
    const Guide& guide = model_->guideOf(model_->guideExport().hinge);
    const BranchSummary& branch =
        model_->exportedBranch() == Branch::compressed ? guide.compressed : guide.stretched;
    const bool possible = branch.exists && !branch.undercut;
    dxf_->setEnabled(possible);
    csv_->setEnabled(possible);
    const Message overlap =
        elastic_hinge::overlap_note(guide.hinge, branch, model_->input().roller_radius);
    note_->setText(!branch.exists     ? guide.feasible
                                            ? tr("This guide has no such branch.")
                                            : tr("No guide: %1.").arg(messageText(guide.reason))
                       : branch.undercut ? tr("The roller undercuts this guide.")
                   : !overlap.empty() ? messageText(overlap)
                                      : tr("The profile is offset from the path of the roller's "
                                           "centre by the roller's radius."));
}

void GuideExportForm::ask(const QString& suffix) {
    if (!continueWithoutRejected(this, tr("Export guide"))) {
        return;
    }
    QList<FileFormat> formats{dxfFormat(), csvFormat()};
    if (formats.back().suffix == suffix) {
        std::swap(formats.front(), formats.back());
    }
    const QString path =
        saveFile(this, tr("Export guide"), QStringLiteral("guide.") + suffix, formats,
                 std::bind_front(&ElasticHingeModel::exportGuide, model_));
    if (!path.isEmpty()) {
        Q_EMIT status(tr("%1 written").arg(path));
    }
}

}  // namespace ravnoves
