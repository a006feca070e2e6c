#include "v8-plugs/job_sheet.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <array>

#include "theme/theme.h"
#include "v8-plugs/checked_field.h"
#include "v8-plugs/journal_dialog.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "widgets/form_section.h"
#include "v8-plugs/model/v8_names.h"

namespace ravnoves {

using namespace v8_plugs;

JobSheet::JobSheet(V8PlugsModel* model, QWidget* parent) : SheetForm(model, parent) {
    buildHead();
    buildWork();
    buildChanges();
    column_->addStretch();
}

void JobSheet::buildHead() {
    auto* job = new FormSection(tr("Job"), this);
    text(job, tr("Engine &number"), QStringLiteral("engine_number"), &JobHeader::engine_number,
         tr("The journal finds the job by it."));
    text(job, tr("Crankshaft num&ber"), QStringLiteral("crankshaft_number"),
         &JobHeader::crankshaft_number, tr("As stamped on the crankshaft."));
    text(job, tr("C&ustomer"), QStringLiteral("customer"), &JobHeader::customer,
         tr("Who brought the engine; the journal finds the job by it."));
    checked(job, tr("&Date"), QStringLiteral("date"), tr("Year-month-day or day.month.year."),
            {[](const QString& typed) { return readDay(typed).toString(Qt::ISODate); },
             [](const QString& typed) {
                 return tr("“%1” is no date; write it like 2024-05-31.").arg(typed);
             },
             [this] { return QString::fromStdString(model_->input().job.date); },
             [](Input& input, const QString& day) { input.job.date = day.toStdString(); }});
    text(job, tr("&Technician"), QStringLiteral("technician"), &JobHeader::technician,
         tr("Who does the work."));
    column_->addWidget(job);
}

void JobSheet::buildWork() {
    auto* work = new FormSection(tr("Work"), this);
    const Words words;
    engine_ = choice(work, tr("&Engine"), QStringLiteral("engine"), {},
                     tr("Engines of the paper by displacement, then your own."), [this](int place) {
                         model_->chooseEngine(place);
                         showEngines();
                     });
    engine_->setPlaceholderText(tr("other"));
    connect(model_, &V8PlugsModel::enginesChanged, this, &JobSheet::showEngines);
    QComboBox* process = choice(
        work, tr("&Work"), QStringLiteral("process"),
        {v8_text::processName(words, Process::repair),
         v8_text::processName(words, Process::manufacture)},
        tr("In manufacture repair pistons and repair shells are not counted."), [this](int which) {
            model_->edit(tr("Work"), [&](Input& input) {
                input.process = which == 0 ? Process::repair : Process::manufacture;
            });
        });
    QComboBox* crankshaft = choice(
        work, tr("Cran&kshaft"), QStringLiteral("crankshaft"),
        {v8_text::crankshaftName(words, Crankshaft::standard),
         v8_text::crankshaftName(words, Crankshaft::new_plugs)},
        tr("Which plugs the counterweights of the crankshaft were made for."), [this](int which) {
            model_->edit(tr("Crankshaft"), [&](Input& input) {
                input.crankshaft = which == 0 ? Crankshaft::standard : Crankshaft::new_plugs;
            });
        });
    follow([this, process, crankshaft] {
        showEngines();
        process->setCurrentIndex(model_->input().process == Process::repair ? 0 : 1);
        crankshaft->setCurrentIndex(model_->input().crankshaft == Crankshaft::standard ? 0 : 1);
        crankshaft->setEnabled(model_->input().engine.has_new_plug);
    });
    column_->addWidget(work);
}

void JobSheet::showEngines() {
    const QSignalBlocker block(engine_);
    const QStringList names = model_->engineNames();
    QStringList shown;
    for (int i = 0; i < engine_->count(); ++i) {
        shown << engine_->itemText(i);
    }
    if (shown != names) {
        engine_->clear();
        engine_->addItems(names);
    }
    engine_->setCurrentIndex(model_->engineIndex());
}

void JobSheet::buildChanges() {
    auto* changes = new FormSection(tr("Heavier than nominal by (negative: lighter)"), this);
    const std::array<QString, 4> labels{tr("&Improved piston"), tr("&Rod big end"),
                                        tr("Re&pair piston and rings"), tr("Repair &shells")};
    const std::array<QString, 4> hints{
        tr("Δm_pi: one piston against nominal."), tr("Δm_be: one big end against nominal."),
        tr("Δm_rp: one repair piston with its rings against nominal."),
        tr("Δm_sh: the repair shells of one crankpin against nominal.")};
    for (std::size_t i = 0; i < mass_change_fields().size(); ++i) {
        const MassChangeField& field = mass_change_fields()[i];
        NumberField* made = number(
            changes, labels[i], field.spec, hints[i],
            [this, field]() -> std::optional<double> {
                return in_unit(model_->solution().changes.*field.member, field.spec);
            },
            [field](Input& input, std::optional<double> value) {
                input.typed_changes.*field.member = value.value_or(0.0) * field.spec.to_si;
            });
        made->setPlaceholderText(QStringLiteral("0"));
        follow([this, made, field] {
            made->setEnabled(!model_->input().changes_from_weigh_in &&
                             (!field.repair_only || model_->input().process == Process::repair));
        });
    }
    QLabel* source = wrapped(changes, Theme::smallSize);
    changes->addWide(source);
    source->setText(tr("Taken from the weigh-in sheet."));
    follow([this, source] { source->setVisible(model_->input().changes_from_weigh_in); });
    number(
        changes, tr("Residual unbalance &allowed"), tolerance_field,
        tr("In each correction plane. The paper accepts 5 g·mm."),
        [this] { return in_unit(model_->input().tolerance, tolerance_field); },
        [](Input& input, std::optional<double> value) {
            input.tolerance = value ? *value * tolerance_field.to_si : default_tolerance;
        });
    column_->addWidget(changes);
}

}  // namespace ravnoves
