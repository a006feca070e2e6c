#include "bob-weights/bob_weights_page.h"

#include <QTabWidget>

#include "bob-weights/bob_answer.h"
#include "bob-weights/bob_card.h"
#include "bob-weights/bob_sheets.h"
#include "bob-weights/model/bob_text.h"
#include "bob-weights/model/bob_weights_model.h"
#include "workshop/journal_dialog.h"

namespace ravnoves {

BobWeightsPage::BobWeightsPage(QWidget* parent, SceneModel* kept)
    : BobWeightsPage(Journal::defaultPath(), parent, kept) {}

BobWeightsPage::BobWeightsPage(const QString& journalPath, QWidget* parent, SceneModel* kept)
    : WorkshopPage(parent), model_(takeOver<BobWeightsModel>(kept, journalPath)) {
    answer_ = new BobAnswer(model_, this);
    build({{new BobJobSheet(model_), tr("&1 Job")},
           {new BobPartsSheet(model_), tr("&2 Parts")},
           {new BobWeighInSheet(model_), tr("&3 Weigh-in")},
           {new BobMachineSheet(model_), tr("&4 Machine")},
           {new BobDrillsSheet(model_), tr("&5 Drills")}},
          answer_);
    connect(model_, &BobWeightsModel::sheetChosen, sheets(), &QTabWidget::setCurrentIndex);
}

SceneModel* BobWeightsPage::model() {
    return model_;
}

JobDesk* BobWeightsPage::desk() const {
    return model_->desk();
}

std::unique_ptr<JobCard> BobWeightsPage::card() {
    return std::make_unique<BobCard>(model_->input(), model_->solution(),
                                     model_->desk()->cardWords());
}

void BobWeightsPage::emptySheet() {
    model_->newJob();
}

QString BobWeightsPage::carriedOver() const {
    return model_->carriedOver();
}

ListedJob BobWeightsPage::listed(const Words& words, const JournalJob& job) const {
    return {bob_text::engineName(words, job.engine),
            job.bobWeight ? words.translate("BobWeights", "Bob weight %1")
                                .arg(words.number(*job.bobWeight * units::gram, units::gram, 1))
                          : QStringLiteral("–")};
}

void BobWeightsPage::showRefused(const QStringList& refused) {
    answer_->setRefused(refused);
}

}  // namespace ravnoves
