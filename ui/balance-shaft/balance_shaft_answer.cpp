#include "balance-shaft/balance_shaft_page.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include "balance-shaft/mechanism_view.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "page/mechanism_picture.h"
#include "theme/theme.h"
#include "widgets/apart.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/verdict_line.h"

namespace ravnoves {

QWidget* BalanceShaftPage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(Theme::withText(338));
    holder->setMaximumWidth(Theme::withText(440));
    QVBoxLayout* column = columnIn(holder);

    picture_ = new MechanismView(model_);
    auto* picturePanel =
        new PicturePanel(picture_, tr("Crank angle of the picture; 0 is top dead centre"), holder);
    playAction_ = picturePanel->action();
    column->addWidget(picturePanel, 1);

    auto* answer = new Panel(holder);
    QVBoxLayout* answerColumn = columnIn(answer, Theme::gap, tableMargins);
    criteria_ = new ResultTable(tr("Criteria of the three moments"), answer);
    answerColumn->addWidget(criteria_);

    auto* best = new QGridLayout;
    best->setHorizontalSpacing(Theme::space);
    best->setVerticalSpacing(2);
    bestRange_ = copyableLabel("best_range", Theme::baseSize, answer);
    bestRms_ = copyableLabel("best_rms", Theme::baseSize, answer);
    goRange_ = new QPushButton(tr("Go"), answer);
    goRms_ = new QPushButton(tr("Go"), answer);
    const auto addBest = [&](int row, QLabel* label, QPushButton* button, const QString& name) {
        label->setToolTip(tr("Over all α that can be built, exact for the continuous cycle"));
        button->setMaximumWidth(Theme::withText(52));
        button->setAccessibleName(name);
        button->setToolTip(name);
        best->addWidget(new Apart(label, answer), row, 0);
        best->addWidget(button, row, 1);
    };
    addBest(1, bestRange_, goRange_, tr("Go to the α of the least range"));
    addBest(2, bestRms_, goRms_, tr("Go to the α of the least RMS"));
    best->setColumnStretch(0, 1);
    goRange_->setObjectName(QStringLiteral("go_best_range"));
    goRms_->setObjectName(QStringLiteral("go_best_rms"));
    connect(goRange_, &QPushButton::clicked, model_, &BalanceShaftModel::goToBestRange);
    connect(goRms_, &QPushButton::clicked, model_, &BalanceShaftModel::goToBestRms);
    answerColumn->addLayout(best);

    quantities_ = new ResultTable(tr("Forces, masses and sizes"), answer);
    quantities_->horizontalHeader()->hide();
    answerColumn->addWidget(quantities_);
    notes_ = copyableCaption("notes", answer);
    answerColumn->addWidget(new Apart(notes_, answer), 1);
    column->addWidget(answer);
    return holder;
}

QString BalanceShaftPage::resultsAsText() const {
    return verdict_->text() + QLatin1Char('\n') + criteria_->asText() + QLatin1Char('\n') +
           quantities_->asText() + QLatin1Char('\n') + bestRange_->text() + QLatin1Char('\n') +
           bestRms_->text() + QLatin1Char('\n');
}

QString BalanceShaftPage::resultsAsCsv() const {
    return criteria_->asCsv() + QLatin1Char('\n') + quantities_->asCsv();
}

}  // namespace ravnoves
