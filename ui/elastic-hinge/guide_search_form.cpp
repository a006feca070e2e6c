#include "elastic-hinge/guide_search_form.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"

namespace ravnoves {

using elastic_hinge::GuideWish;
using elastic_hinge::Input;
namespace field = elastic_hinge::field;

GuideSearchForm::GuideSearchForm(ElasticHingeModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::space);
    column->addWidget(captionLabel(
        tr("Finds stiffness and preload that give the crank's guide a relief that can be made, "
           "with the free length, the roller and the side of the spring as they are."),
        this));
    auto* section = new FormSection(tr("Wanted"), this);
    relief_ = section->addNumber(tr("R&elief"), field::wanted_relief,
                                 tr("Difference between the guide's largest and least radius"));
    diameter_ = section->addNumber(tr("&Outer diameter"), field::outer_diameter,
                                   tr("Guide and rollers must fit in it"));
    shortest_ = section->addNumber(
        tr("&Shortest spring"), field::smallest_spring_length,
        tr("The spring gets no shorter than that (its solid length). Empty: 0.4 ℓ₀."));
    shortest_->setOptional(true);
    shortest_->setPlaceholderText(tr("0.4 ℓ₀"));
    column->addWidget(section);
    column->addWidget(headingLabel(tr("Found"), this));
    answer_ = new QLabel(this);
    answer_->setWordWrap(true);
    answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    answer_->setObjectName(QStringLiteral("search_answer"));
    column->addWidget(answer_);
    take_ = new QPushButton(tr("&Take it over"), this);
    take_->setObjectName(QStringLiteral("take_proposal"));
    take_->setToolTip(tr("Sets c and ρ₀ to the values found"));
    column->addWidget(take_);
    column->addStretch();
    connect(take_, &QPushButton::clicked, model_, &ElasticHingeModel::takeProposal);

    const auto edit = [this](const QString& name, auto write) {
        return [this, name, write](std::optional<double> value) {
            model_->edit(name, [&](Input& input) {
                GuideWish wish = input.guide_search.value_or(GuideWish{});
                write(wish, value);
                input.guide_search = wish;
            });
        };
    };
    connect(relief_, &NumberField::valueEdited, this,
            edit(tr("Wanted relief"), [](GuideWish& wish, std::optional<double> value) {
                wish.relief = *value * field::millimetre;
            }));
    connect(diameter_, &NumberField::valueEdited, this,
            edit(tr("Outer diameter"), [](GuideWish& wish, std::optional<double> value) {
                wish.outer_diameter = *value * field::millimetre;
            }));
    connect(shortest_, &NumberField::valueEdited, this,
            edit(tr("Shortest spring"), [](GuideWish& wish, std::optional<double> value) {
                wish.smallest_spring_length =
                    value ? std::optional(*value * field::millimetre) : std::nullopt;
            }));
    connect(model_, &SceneModel::changed, this, [this] {
        if (isVisible()) {
            show();
        }
    });
    show();
}

void GuideSearchForm::showEvent(QShowEvent* event) {
    show();
    QWidget::showEvent(event);
}

void GuideSearchForm::show() {
    const GuideWish wish = model_->wish();
    relief_->setValue(wish.relief / field::millimetre);
    diameter_->setValue(wish.outer_diameter / field::millimetre);
    shortest_->setValue(wish.smallest_spring_length
                            ? std::optional(*wish.smallest_spring_length / field::millimetre)
                            : std::nullopt);
    answer_->setText(model_->proposalText());
    take_->setEnabled(model_->proposal().found);
}

}  // namespace ravnoves
