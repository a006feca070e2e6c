#include "elastic-hinge/guide_search_form.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "theme/theme.h"

namespace ravnoves {

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

}  // namespace ravnoves
