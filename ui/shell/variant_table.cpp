#include "shell/variant_table.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

#include "model/scene_model.h"
#include "model/variant_results.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "text/csv_format.h"
#include "text/write_file.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/result_table.h"

namespace ravnoves {

VariantTable::VariantTable(ScenePage* page, QWidget* parent)
    : QDialog(parent),
      page_(page),
      verdicts_(copyableCaption({}, this)),
      words_(captionLabel({}, this)),
      star_(captionLabel(tr("★ marks the best of those without a warning."), this)),
      table_(new ResultTable(this)) {
    setWindowTitle(tr("Variants side by side"));
    resizeWithText(this, 720, 520);
    auto* column = new QVBoxLayout(this);
    column->addWidget(verdicts_);
    table_->setAccessibleName(windowTitle());
    constexpr int fewest = 8;
    table_->setShownRows(fewest);
    column->addWidget(table_, 1);
    column->addWidget(star_);
    colourText(words_, &Theme::warning);
    column->addWidget(words_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    table_->addCopyButtons(buttons);
    QPushButton* save = buttons->addButton(tr("&Save as CSV…"), QDialogButtonBox::ActionRole);
    connect(save, &QPushButton::clicked, this, &VariantTable::saveWithDialog);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    column->addWidget(buttons);
    constexpr int restMs = 300;  // every variant is solved again: not at each step of a slider
    rest_.setSingleShot(true);
    rest_.setInterval(restMs);
    connect(&rest_, &QTimer::timeout, this, &VariantTable::showVariants);
    connect(page->model(), &SceneModel::changed, &rest_, qOverload<>(&QTimer::start));
    connect(page->model(), &SceneModel::variantsChanged, &rest_, qOverload<>(&QTimer::start));
    connect(page, &QObject::destroyed, this, [this] {
        rest_.stop();
        page_ = nullptr;
        close();
    });
    showVariants();
}

void VariantTable::showVariants() {
    if (page_ == nullptr) {
        return;  // the page is gone, and this closes
    }
    const SceneModel& model = *page_->model();
    const VariantResults found = variantResults(model);
    showOrHide(verdicts_, found.verdicts.join(QLatin1Char('\n')));
    table_->setResults(found.results);
    star_->setVisible(std::ranges::any_of(found.results.rows, [](const ResultRow& row) {
        return std::ranges::any_of(row, &ResultCell::isBest);
    }));
    showOrHide(words_,
               model.variants().isEmpty()
                   ? tr("No variants yet. Press Ctrl+K to keep the present input as a variant.")
                   : found.troubles.join(QLatin1Char('\n')));
}

QString VariantTable::exportTo(const QString& path) const {
    return writeFile(path, [this] { return CsvFormat::file(table_->asCsv()); });
}

void VariantTable::saveWithDialog() {
    saveFile(this, windowTitle(), QStringLiteral("variants.csv"), {csvFormat()},
             std::bind_front(&VariantTable::exportTo, this));
}

}  // namespace ravnoves
