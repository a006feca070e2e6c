#include "v8-plugs/weigh_in_sheet.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include "text/message_text.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "widgets/result_table.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int choiceHeight = 30;

QVBoxLayout* columnOf(QWidget* sheet) {
    return static_cast<QVBoxLayout*>(sheet->layout());
}

}  // namespace

WeighInSheet::WeighInSheet(V8PlugsModel* model, QWidget* parent)
    : MatchingSheet(
          model,
          [model] {
              const auto& sheet = model->input().weigh_in;
              return sheet ? sheet->matching : Rules();
          },
          [model](const QString& name, const std::function<void(Rules&)>& change) {
              model->editWeights(name, [&](WeighIn& sheet) { change(sheet.matching); });
          },
          [model] {
              const auto& sheet = model->input().weigh_in;
              return sheet && sheet->is_moved();
          },
          parent),
      model_(model) {
    columnOf(this)->setSpacing(Theme::space);
    section({});
    ordered(box(
        QStringLiteral("changes_from_weigh_in"), tr("Take the mass changes &from this sheet"),
        shownText(field::changes_source.hint),
        [this] { return model_->input().changes_from_weigh_in; },
        [this](bool on) {
            model_->edit(fieldName(field::changes_source), [&](Input& input) {
                input.changes_from_weigh_in = on;
                if (!input.weigh_in) {
                    input.weigh_in.emplace();
                }
            });
        }));
    QComboBox* numbering = choice("/weigh_in/cylinder_numbering");
    numbering->setMinimumHeight(Theme::withText(choiceHeight));
    numbering->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    addWeights(new WeighInTable(WeighInTable::sourceOf(model, field::part_mass, true,
                                                       [] { return int{cylinder_count}; }),
                                this),
               cylinder_count, [model](Part part) { return model->columnNote(part); });
    addGoal(false);
    buildFindings();
    finish();
}

void WeighInSheet::buildFindings() {
    addFindings([this] { return findings(); }, [this] { model_->moveParts(); },
                [this] { model_->moveBack(); });
    crankpins_ = new ResultTable(tr("Excess on each crankpin, as weighed and after moving"), this);
    crankpins_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    columnOf(this)->addWidget(crankpins_);
    follow([this] {
        crankpins_->setEnabled(!model_->isSearching());
        if (model_->isSearching()) {
            return;
        }
        crankpins_->setResults(model_->crankpinResults());
        crankpins_->setVisible(crankpins_->rowCount() > 0);
    });
}

MatchingSheet::Findings WeighInSheet::findings() const {
    const QStringList gaps = model_->notCounted();
    QStringList summary = gaps;
    summary << model_->assignmentText() << model_->assignmentRemarks();
    summary.removeAll(QString());
    const auto& assignment = model_->solution().assignment;
    return {summary.join(QLatin1Char('\n')),
            !gaps.isEmpty() || (assignment && !assignment->remark.empty()),
            assignment && assignment->moved > 0,
            model_->isSearching(),
            model_->effectResults(),
            model_->assignmentResults(),
            model_->takeOffResults()};
}

}  // namespace ravnoves
