#include "methods/validation_view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>
#include <QtMath>
#include <algorithm>
#include <numeric>
#include <span>

#include "methods/model/method_words.h"
#include "text/csv_format.h"
#include "text/text_width.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/panel.h"

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

/// The verdict in its colour, which follows the theme.
class VerdictDelegate : public QStyledItemDelegate {
  public:
    VerdictDelegate(const ValidationModel* model, QObject* parent)
        : QStyledItemDelegate(parent), model_(model) {}

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const auto& row = *model_->rows()[static_cast<std::size_t>(index.row())];
        option->palette.setColor(QPalette::Text, verdictColour(row.verdict));
    }

  private:
    const ValidationModel* model_;
};

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
    auto* inside = new QVBoxLayout(panel);
    inside->setContentsMargins(1, 1, 1, Theme::gap);
    table_ = new QTableView(panel);
    table_->setObjectName(QStringLiteral("validation_table"));
    table_->setAccessibleName(tr("Printed numbers beside ours"));
    table_->setModel(model_);
    table_->setItemDelegateForColumn(ValidationModel::VerdictColumn,
                                     new VerdictDelegate(model_, table_));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setFont(Theme::font(Theme::baseSize - 1));
    table_->setTabKeyNavigation(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(Theme::withText(20));
    table_->verticalHeader()->setMinimumSectionSize(Theme::withText(18));
    QHeaderView* headings = table_->horizontalHeader();
    headings->setHighlightSections(false);
    headings->setFont(Theme::font(Theme::smallSize + 1, true));
    headings->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->installEventFilter(this);
    table_->viewport()->installEventFilter(this);  // a scroll bar takes of its width
    inside->addWidget(table_, 1);
    reason_ = captionLabel({}, panel);
    reason_->setObjectName(QStringLiteral("reason"));
    reason_->setContentsMargins(Theme::space, 0, Theme::space, 0);
    // Room for two lines, so that the table keeps its height from row to row.
    reason_->setMinimumHeight(2 * reason_->fontMetrics().lineSpacing());
    reason_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    inside->addWidget(reason_);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &ValidationView::showReason);
    return panel;
}

QWidget* ValidationView::buildFilters() {
    auto* holder = new QWidget(this);
    QHBoxLayout* row = rowIn(holder);
    papers_ = new QComboBox(holder);
    papers_->setObjectName(QStringLiteral("paper_filter"));
    papers_->setAccessibleName(tr("Paper"));
    papers_->setToolTip(tr("Show the numbers of one paper only"));
    papers_->addItem(tr("All papers"));
    papers_->addItems(model_->paperTitles());
    for (int i = 0; i < papers_->count() - 1; ++i) {
        papers_->setItemData(i + 1,
                             methodText(methods::papers()[static_cast<std::size_t>(i)].citation),
                             Qt::ToolTipRole);
    }
    connect(papers_, &QComboBox::activated, this, [this](int index) {
        model_->setPaper(index == 0 ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(index - 1)));
    });
    verdicts_ = new QComboBox(holder);
    verdicts_->setObjectName(QStringLiteral("verdict_filter"));
    verdicts_->setAccessibleName(tr("Verdict"));
    verdicts_->setToolTip(tr("Show the numbers with one verdict only"));
    verdicts_->addItem(tr("All verdicts"));
    for (const methods::Verdict verdict : methods::all_verdicts) {
        verdicts_->addItem(verdictTitle(verdict));
    }
    connect(verdicts_, &QComboBox::activated, this, [this](int index) {
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
    for (QComboBox* box : {papers_, verdicts_}) {
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
    addLabelled(tr("&Paper"), papers_);
    row->addSpacing(Theme::space);
    addLabelled(tr("Ver&dict"), verdicts_);
    row->addStretch();
    row->addWidget(copy);
    return holder;
}

void ValidationView::showReport() {
    counts_->setText(model_->countsText());
    measure();
    fitColumns();
}

void ValidationView::showReason() {
    const int row = table_->currentIndex().row();
    const bool known = row >= 0 && static_cast<std::size_t>(row) < model_->rows().size();
    if (!known) {
        reason_->setText(tr("Choose a row to read why it has its verdict."));
        return;
    }
    // What the table has no room for is said here.
    QStringList where;
    for (const int column : {ValidationModel::Paper, ValidationModel::Place}) {
        if (table_->isColumnHidden(column)) {
            where << model_->index(row, column).data().toString();
        }
    }
    const QString reason = methodText(model_->rows()[static_cast<std::size_t>(row)]->reason);
    reason_->setText(where.isEmpty()
                         ? reason
                         : where.join(QStringLiteral(", ")) + QStringLiteral(": ") + reason);
}

void ValidationView::measure() {
    const int padding = Theme::withText(12);
    const QFontMetrics headings = table_->horizontalHeader()->fontMetrics();
    for (int column = 0; column < ValidationModel::Columns; ++column) {
        const QString heading = model_->headerData(column, Qt::Horizontal).toString();
        int& wanted = wanted_[static_cast<std::size_t>(column)];
        wanted = headings.horizontalAdvance(heading) + padding;
        for (int row = 0; row < model_->rowCount(); ++row) {
            const QString text = model_->index(row, column).data().toString();
            wanted = std::max(wanted, qCeil(textWidth(table_->font(), text)) + padding);
        }
    }
}

void ValidationView::fitColumns() {
    const int room = table_->viewport()->width();
    std::array<int, ValidationModel::Columns> least = wanted_;
    for (int column = 0; column < ValidationModel::Unit; ++column) {
        int& width = least[static_cast<std::size_t>(column)];
        width = std::min(width, Theme::withText(150));
    }
    // The verdict stays in sight: what a tip says as well gives way, with or without a scroll bar.
    const int sure = table_->width() - table_->verticalScrollBar()->sizeHint().width();
    auto widths = wanted_;
    const auto hide = [&](int column, bool hidden) {
        table_->setColumnHidden(column, hidden);
        if (hidden) {
            widths[static_cast<std::size_t>(column)] = 0;
            least[static_cast<std::size_t>(column)] = 0;
        }
    };
    for (const int column : {ValidationModel::Paper, ValidationModel::Place,
                             ValidationModel::Difference, ValidationModel::Unit}) {
        hide(column, std::accumulate(least.begin(), least.end(), 0) > sure);
    }
    const auto words = std::span(widths).first(ValidationModel::Unit);
    int over = room - std::accumulate(widths.begin(), widths.end(), 0);
    if (over > 0) {
        const auto shown = std::count_if(words.begin(), words.end(), [](int w) { return w > 0; });
        for (int& width : words) {  // no number goes far from what it is of
            width += width > 0 ? over / static_cast<int>(shown) : 0;
        }
    }
    // The widest gives way first; where none can, the table scrolls.
    for (; over < 0; ++over) {
        std::size_t widest = 0;
        int most = 0;
        for (std::size_t column = 0; column < words.size(); ++column) {
            if (words[column] > least[column] && words[column] > most) {
                widest = column;
                most = words[column];
            }
        }
        if (most == 0) {
            break;
        }
        --words[widest];
    }
    for (int column = 0; column < ValidationModel::Columns; ++column) {
        if (!table_->isColumnHidden(column)) {
            table_->setColumnWidth(column, widths[static_cast<std::size_t>(column)]);
        }
    }
    table_->resizeRowsToContents();
    showReason();
}

bool ValidationView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == table_->viewport() && event->type() == QEvent::Resize) {
        QMetaObject::invokeMethod(this, &ValidationView::fitColumns, Qt::QueuedConnection);
    }
    if (watched == table_ && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copySelection();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ValidationView::copySelection() {
    QString text;
    for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
        for (int column = 0; column < ValidationModel::Columns; ++column) {
            text += column == 0 ? QString() : QStringLiteral("\t");
            text += CsvFormat::plainMinus(row.siblingAtColumn(column).data().toString());
        }
        text += QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text.isEmpty() ? asText() : text);
}

QString ValidationView::asText() const {
    return counts_->text() + QLatin1Char('\n') + model_->asText();
}

}  // namespace ravnoves
