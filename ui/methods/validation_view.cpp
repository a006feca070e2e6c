#include "methods/validation_view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "methods/model/method_words.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

namespace {

QColor verdictColour(methods::Verdict verdict) {
    const Theme& theme = Theme::instance();
    switch (verdict) {
        case methods::Verdict::reproduced:
            return theme.good();
        case methods::Verdict::not_derivable:
        case methods::Verdict::given:
            return theme.mutedText();
        case methods::Verdict::artefact:
        case methods::Verdict::slip:
            return theme.warning();
        case methods::Verdict::differs:
            break;
    }
    return theme.error();
}

}  // namespace

ValidationView::ValidationView(QWidget* parent)
    : QWidget(parent), model_(new ValidationModel(this)) {
    QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);
    counts_ = headingLabel({}, this);
    counts_->setObjectName(QStringLiteral("counts"));
    counts_->setWordWrap(true);
    counts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(counts_);
    column->addWidget(buildFilters());
    column->addWidget(buildTable(), 1);
    connect(model_, &ValidationModel::changed, this, &ValidationView::showReport);
    connect(model_, &ValidationModel::failed, this, &ValidationView::status);
    showReport();
}

QWidget* ValidationView::buildTable() {
    auto* panel = new Panel(this);
    QVBoxLayout* inside = columnIn(panel, -1, {1, 1, 1, Theme::gap});
    table_ = new ResultTable(tr("Printed numbers and our values"), panel);
    table_->setObjectName(QStringLiteral("validation_table"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setWordWrap(true);
    table_->stretchColumn(ValidationModel::Quantity);
    constexpr int shownRows = 4;  // further ones scroll below the headings, above the reason
    table_->setShownRows(shownRows);
    inside->addWidget(table_, 1);
    reason_ = captionLabel({}, panel);
    reason_->setObjectName(QStringLiteral("reason"));
    reason_->setContentsMargins(Theme::space, 0, Theme::space, 0);
    // Room for two lines, so that the table keeps its height from row to row.
    reason_->setMinimumHeight(2 * reason_->fontMetrics().lineSpacing());
    reason_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    inside->addWidget(reason_);
    connect(table_, &QTableWidget::currentCellChanged, this, &ValidationView::showReason);
    connect(&Theme::instance(), &Theme::changed, this, &ValidationView::showReport);
    return panel;
}

QWidget* ValidationView::buildFilters() {
    auto* holder = new QWidget(this);
    QHBoxLayout* row = rowIn(holder);
    auto* papers = new QComboBox(holder);
    papers->setObjectName(QStringLiteral("paper_filter"));
    papers->setAccessibleName(tr("Paper"));
    papers->setToolTip(tr("Show the numbers of one paper only"));
    papers->addItem(tr("All papers"));
    papers->addItems(model_->paperTitles());
    for (int i = 0; i < papers->count() - 1; ++i) {
        papers->setItemData(i + 1,
                            methodText(methods::papers()[static_cast<std::size_t>(i)].citation),
                            Qt::ToolTipRole);
    }
    connect(papers, &QComboBox::activated, this, [this](int index) {
        model_->setPaper(index == 0 ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(index - 1)));
    });
    auto* verdicts = new QComboBox(holder);
    verdicts->setObjectName(QStringLiteral("verdict_filter"));
    verdicts->setAccessibleName(tr("Verdict"));
    verdicts->setToolTip(tr("Show the numbers with one verdict only"));
    verdicts->addItem(tr("All verdicts"));
    for (const methods::Verdict verdict : methods::all_verdicts) {
        verdicts->addItem(verdictTitle(verdict));
    }
    connect(verdicts, &QComboBox::activated, this, [this](int index) {
        model_->setVerdict(index == 0 ? std::nullopt
                                      : std::optional(methods::all_verdicts[index - 1]));
    });
    auto* copy = new QPushButton(themedIcon(QStringLiteral("copy")), tr("Copy as CS&V"), holder);
    copy->setObjectName(QStringLiteral("copy_csv"));
    copy->setToolTip(tr("Copy the rows shown as CSV, numbers in full precision"));
    connect(copy, &QPushButton::clicked, this, [this] {
        QApplication::clipboard()->setText(asCsv());
        Q_EMIT status(tr("Report copied as CSV"));
    });
    for (QComboBox* box : {papers, verdicts}) {
        constexpr int letters = 5;
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(letters);
        box->setMaximumWidth(widthFor(box));
    }
    const auto addLabelled = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, holder);
        label->setBuddy(field);
        row->addWidget(label);
        row->addWidget(field, 1);
    };
    addLabelled(tr("&Paper"), papers);
    row->addSpacing(Theme::space);
    addLabelled(tr("Ver&dict"), verdicts);
    row->addStretch();
    row->addWidget(copy);
    return holder;
}

void ValidationView::showReport() {
    counts_->setText(model_->countsText());
    table_->setResults(model_->results());
    table_->resizeRowsToContents();
    constexpr Qt::Alignment asWords = Qt::AlignLeft | Qt::AlignVCenter;
    table_->horizontalHeaderItem(ValidationModel::Quantity)->setTextAlignment(asWords);
    for (int row = 0; row < table_->rowCount(); ++row) {
        table_->item(row, ValidationModel::Quantity)->setTextAlignment(asWords);
        const methods::Verdict verdict = model_->rows()[static_cast<std::size_t>(row)]->verdict;
        table_->item(row, ValidationModel::VerdictColumn)->setForeground(verdictColour(verdict));
    }
    showReason();
}

void ValidationView::showReason() {
    const auto row = static_cast<std::size_t>(table_->currentRow());  // none is beyond all
    reason_->setText(row < model_->rows().size()
                         ? methodText(model_->rows()[row]->reason)
                         : tr("Select a row to read the reason of its verdict."));
}

QString ValidationView::asText() const {
    return counts_->text() + QLatin1Char('\n') + table_->asText();
}

}  // namespace ravnoves
