#include "v8-plugs/job_sheet.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "text/message_text.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"

namespace ravnoves {

using namespace v8_plugs;

JobSheet::JobSheet(V8PlugsModel* model, QWidget* parent) : V8Sheet(model, parent) {
    addJob();
    buildWork();
    buildChanges();
    finish();
}

void JobSheet::buildWork() {
    section(tr("Work"));
    engine_ = ordered(new QComboBox(current()));
    engine_->setObjectName(QStringLiteral("engine"));
    engine_->setPlaceholderText(shownText(field::engine.placeholder));
    enlarge(engine_);
    current()->addWidget(shownText(field::engine.label), engine_, {}, fieldHint(field::engine));
    connect(engine_, &QComboBox::activated, this, [this](int place) {
        model_->chooseEngine(place);
        showEngines();
    });
    connect(model_, &V8PlugsModel::enginesChanged, this, &JobSheet::showEngines);
    follow([this] { showEngines(); });
    choice("/process");
    QComboBox* crankshaft = choice("/crankshaft");
    follow([this, crankshaft] { crankshaft->setEnabled(model_->input().engine.has_new_plug); });
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
    section(tr("Heavier than nominal by (negative: lighter)"));
    for (const MassChangeField& each : mass_change_fields()) {
        NumberField* made = number(
            each.field,
            [this, each] {
                // Empty until one of them is given: then the others are 0.
                return model_->input().changes_known() || model_->input().has_typed_changes()
                           ? std::optional(model_->solution().changes.*each.member)
                           : std::nullopt;
            },
            [this, each](std::optional<double> value) {
                model_->edit(fieldName(each.field), [&](Input& input) {
                    input.typed_changes.*each.member = value.value_or(0.0);
                    input.changes_given = true;
                });
            });
        follow([this, made, each] {
            made->setEnabled(model_->input().takes_typed(each.member) &&
                             (!each.repair_only || model_->input().process == Process::repair));
        });
    }
    number("/tolerance_g_mm");
    // Below the fields: they must not move while one types.
    QLabel* owner = line(Theme::smallSize, [this] { return model_->toleranceText(); });
    owner->setObjectName(QStringLiteral("tolerance_owner"));
    owner->setMinimumHeight(3 * owner->fontMetrics().height());  // a scroll bar would move them too
    auto* keep = new QPushButton(tr("&Make it the shop's own"), this);
    keep->setObjectName(QStringLiteral("keep_tolerance"));
    keep->setToolTip(tr("New jobs begin with this limit."));
    keep->setMinimumHeight(Theme::withText(fieldHeight));
    QSizePolicy place = keep->sizePolicy();
    place.setRetainSizeWhenHidden(true);
    keep->setSizePolicy(place);
    current()->addWide(keep);
    connect(keep, &QPushButton::clicked, model_, &V8PlugsModel::keepTolerance);
    follow([this, keep] { keep->setVisible(!model_->isShopsTolerance()); });
    QLabel* grey = line(Theme::smallSize, [this] {
        return model_->replacedInputs().empty()
                   ? QString()
                   : tr("Those in grey are taken from the weigh-in sheet.");
    });
    grey->setTextInteractionFlags(Qt::NoTextInteraction);  // of the form: no report has it
    line(Theme::smallSize, [this] {
        return model_->carriedOver();
    })->setObjectName(QStringLiteral("carried_over"));
}

}  // namespace ravnoves
