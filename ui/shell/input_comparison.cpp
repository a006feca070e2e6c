#include "shell/input_comparison.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include "case-file/json.h"
#include "model/input_differences.h"
#include "page/scene_page.h"
#include "theme/theme.h"
#include "widgets/dialog_size.h"
#include "widgets/result_table.h"

namespace ravnoves {

InputComparison::InputComparison(ScenePage* page, QWidget* parent)
    : QDialog(parent),
      model_(page->model()),
      title_(new QLabel(this)),
      table_(new ResultTable(this)) {
    setWindowTitle(tr("Inputs against the reference"));
    resizeWithText(this, 680, 420);
    auto* column = new QVBoxLayout(this);
    title_->setWordWrap(true);
    column->addWidget(title_);
    table_->setAccessibleName(tr("Inputs that differ"));
    table_->setColumns({tr("Input"), tr("Present"), tr("Reference"), tr("Unit"),
                        QStringLiteral("Δ"), QStringLiteral("Δ, %")});
    constexpr int fewest = 6;
    table_->setShownRows(fewest);  // an engine's table has more than a screen
    column->addWidget(table_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    table_->addCopyButtons(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    column->addWidget(buttons);
    connect(model_, &SceneModel::changed, this, &InputComparison::showDifferences);
    connect(model_, &SceneModel::variantsChanged, this, &InputComparison::showDifferences);
    connect(page, &QObject::destroyed, this, [this] {
        model_ = nullptr;
        close();
    });
    showDifferences();
}

void InputComparison::showDifferences() {
    if (model_ == nullptr) {
        return;  // the page is gone, and this closes
    }
    if (model_->reference() < 0) {
        title_->setText(tr("No reference is chosen."));
        table_->setRows({});
        return;
    }
    const QString name = model_->variants().at(model_->reference()).name;
    const std::vector<InputDifference> differences =
        inputDifferences(*model_, model_->variantInput(model_->reference()));
    title_->setText(differences.empty()
                        ? tr("The present input is that of the reference %1.").arg(name)
                        : tr("Present input against the reference %1").arg(name));
    ResultRows rows;
    const auto orDash = [](const QString& text) {
        return text.isEmpty() ? QStringLiteral("–") : text;
    };
    for (const InputDifference& each : differences) {
        rows.push_back({each.name, orDash(each.present), orDash(each.reference), each.unit,
                        each.absolute(), each.percent()});
    }
    table_->setRows(rows);
}

}  // namespace ravnoves
