#include "v8-plugs/v8_plugs_page.h"

#include <QTabWidget>

#include "v8-plugs/engine_sheet.h"
#include "v8-plugs/job_sheet.h"
#include "v8-plugs/machine_sheet.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/plug_sizes_sheet.h"
#include "v8-plugs/plugs_answer.h"
#include "v8-plugs/plugs_card.h"
#include "v8-plugs/weigh_in_sheet.h"
#include "workshop/journal_dialog.h"

namespace ravnoves {

V8PlugsPage::V8PlugsPage(QWidget* parent, SceneModel* kept)
    : V8PlugsPage(Journal::defaultPath(), parent, kept) {}

V8PlugsPage::V8PlugsPage(const QString& journalPath, QWidget* parent, SceneModel* kept)
    : WorkshopPage(parent), model_(takeOver<V8PlugsModel>(kept, journalPath)) {
    auto* engine = new EngineSheet(model_);
    connect(engine, &EngineSheet::status, this, &ScenePage::status);
    answer_ = new PlugsAnswer(model_, this);
    build({{new JobSheet(model_), tr("&1 Job")},
           {engine, tr("&2 Engine")},
           {new WeighInSheet(model_), tr("&3 Weigh-in")},
           {new PlugSizesSheet(model_), tr("&4 Plug")},
           {new MachineSheet(model_), tr("&5 Machine")}},
          answer_);
    connect(model_, &V8PlugsModel::sheetChosen, sheets(), &QTabWidget::setCurrentIndex);
}

SceneModel* V8PlugsPage::model() {
    return model_;
}

JobDesk* V8PlugsPage::desk() const {
    return model_->desk();
}

std::unique_ptr<JobCard> V8PlugsPage::card() {
    return std::make_unique<PlugsCard>(model_->input(), model_->solution(),
                                       model_->desk()->cardWords());
}

void V8PlugsPage::emptySheet() {
    model_->newJob();
}

QString V8PlugsPage::carriedOver() const {
    return model_->carriedOver();
}

ListedJob V8PlugsPage::listed(const Words& words, const JournalJob& job) const {
    ListedJob text{v8_names::engineName(words, job.engine.toStdString()), job.recommended};
    if (job.recommended.isEmpty()) {
        text.result = QStringLiteral("–");
    } else if (job.recommended == QLatin1String("none-needed")) {
        text.result = tr("nothing needed");
    } else if (job.recommended == QLatin1String("not-compensated")) {
        text.result = tr("not compensated");
    }
    for (const v8_plugs::OptionId id : v8_plugs::all_options) {
        if (job.recommended.toStdString() == v8_plugs::option_word(id).word) {
            text.result = v8_names::optionName(words, id);
            if (job.reduction) {
                text.result +=
                    QStringLiteral(", ") + v8_text::grams(words, *job.reduction * units::gram);
            }
        }
    }
    return text;
}

void V8PlugsPage::showRefused(const QStringList& refused) {
    answer_->setRefused(refused);
}

void V8PlugsPage::setActive(bool active) {
    if (active) {
        model_->reloadEngines();
    }
    WorkshopPage::setActive(active);
}

}  // namespace ravnoves
