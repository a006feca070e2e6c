#include <QLabel>

#include "shop/job_header.h"
#include "text/message_text.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "workshop/sheets.h"

namespace ravnoves {

JobSheet::JobSheet(WorkshopModel* model, QWidget* parent) : WorkshopSheet(model, parent) {
    section(tr("Job"));
    text("/job/engine_number");
    text("/job/crankshaft_number");
    text("/job/customer");
    checked(shop::field::date,
            {[](const QString& typed) { return readDay(typed).toString(Qt::ISODate); },
             [](const QString& typed) {
                 return tr("“%1” is not a date; example: %2.")
                     .arg(typed, Words().day(QStringLiteral("2024-05-31")));
             },
             [this] { return QString::fromStdString(model_->input().job.date); },
             [this](const QString& name, const QString& day) {
                 model_->editField("/job/date", day.toStdString(), name);
             },
             [](const QString& day) { return Words().day(day); }, false});
    text("/job/technician");
    section(tr("Engine"));
    choice("/engine/type", [this](int chosen) { return model_->chooseType(chosen); });
    number("/engine/cylinders");
    NumberField* bank = number("/engine/bank_angle_deg");
    QComboBox* rods = choice("/engine/rods_per_pin");
    NumberField* split = number("/engine/pin_split_deg");
    follow([this, bank, rods, split] {
        const bob_weights::EngineType chosen = model_->input().engine.type;
        for (NumberField* angle : {bank, split}) {
            angle->setEnabled(chosen == bob_weights::EngineType::v);
            if (!angle->isEnabled()) {
                angle->setPlaceholderText(QStringLiteral("–"));
            }
        }
        // On split crankpins each rod has its own.
        const bool isSplit = model_->input().engine.pin_split != 0.0;
        rods->setEnabled(chosen != bob_weights::EngineType::in_line && !isSplit);
        if (isSplit) {
            rods->setCurrentIndex(0);
        }
    });
    wide(choice("/balance"));
    line(Theme::smallSize, [this] {
        return model_->input().balance == bob_weights::Balance::external
                   ? tr("Balance the crankshaft with damper and flywheel in place, each in its "
                        "position.")
                   : QString();
    });
    section(tr("Sludge-trap plugs"));
    QCheckBox* there = box(
        QStringLiteral("has_plugs"), tr("The crankpins have sludge-trap &plugs"),
        tr("Crankpin plugs of a V-8 at 90° are bored or replaced to balance heavier or lighter "
           "parts."),
        [this] { return model_->hasPlugs(); }, [this](bool on) { model_->setHasPlugs(on); });
    enableWhile(there, [this] { return model_->hasPlugs() || model_->mayHavePlugs(); });
    plugsSection(true, {});
    QComboBox* engine = choice(
        QStringLiteral("engine"), shownText(v8_plugs::field::engine.label), model_->engineNames(),
        fieldHint(v8_plugs::field::engine), [this] { return model_->engineIndex(); },
        [this](int place) { model_->chooseEngine(place); });
    follow([this, engine] {
        const QString name = model_->ownEngineName();
        engine->setPlaceholderText(name.isEmpty() ? shownText(v8_plugs::field::engine.placeholder)
                                                  : name);
    });
    choice("/plugs/process");
    enableWhile(choice("/plugs/crankshaft"), [this] {
        return model_->hasPlugs() && model_->input().plugs->engine.has_new_plug;
    });
    section(tr("Notes on the job card"));
    text("/job/notes", longestNotes);
    finish();
}

}  // namespace ravnoves
