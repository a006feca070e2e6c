#include "workshop/journal_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "pictures/file_dialogs.h"
#include "shop/model/verdict.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "workshop/model/job_desk.h"
#include "workshop/workshop_sheet.h"

namespace ravnoves {

namespace {

constexpr int buttonHeight = 36;
constexpr int widest = 480;  // designed pixels of a column: the longest verdict, with readings
constexpr int longestList = 1000;  // more is not looked through by eye

/// What cellsOf() fills.
QStringList journalColumns() {
    QStringList titles{JournalDialog::tr("Date"),         JournalDialog::tr("Engine number"),
                       JournalDialog::tr("Crankshaft"),   JournalDialog::tr("Customer"),
                       JournalDialog::tr("Engine"),       JournalDialog::tr("Technician"),
                       JournalDialog::tr("Result"),       JournalDialog::tr("Bob weight, g"),
                       JournalDialog::tr("Machine, g·mm")};
    for (QString& each : titles) {
        each = shownTitle(each).text;
    }
    return titles;
}

}  // namespace

JournalDialog::JournalDialog(Journal* journal, QWidget* parent, const QString& text)
    : QDialog(parent), journal_(journal) {
    setWindowTitle(tr("Journal of jobs"));
    resizeWithText(this, 1120, 560);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(Theme::space);

    auto* fields = new QHBoxLayout;
    text_ = new QLineEdit(text, this);
    text_->setObjectName(QStringLiteral("journal_search"));
    text_->setAccessibleName(tr("&Search").remove(QLatin1Char('&')));
    text_->setPlaceholderText(
        tr("engine or crankshaft number, customer, technician, %1 or %2")
            .arg(Words().day(QStringLiteral("2024-05-31")), QStringLiteral("2024-05")));
    text_->setMinimumHeight(Theme::withText(buttonHeight - 4));
    text_->setClearButtonEnabled(true);
    limitLength(text_, 200);
    auto* name = new QLabel(tr("&Search"), this);
    name->setBuddy(text_);
    unfinished_ = new QCheckBox(tr("&unfinished only"), this);
    unfinished_->setObjectName(QStringLiteral("journal_unfinished"));
    fields->addWidget(name);
    fields->addWidget(text_, 1);
    fields->addWidget(unfinished_);
    column->addLayout(fields);

    table_ = new QTableWidget(this);
    table_->setObjectName(QStringLiteral("journal_table"));
    table_->setAccessibleName(tr("Jobs found"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    table_->setTabKeyNavigation(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(Theme::withText(30));
    const QStringList titles = journalColumns();
    table_->setColumnCount(static_cast<int>(titles.size()));
    table_->setHorizontalHeaderLabels(titles);
    QHeaderView* header = table_->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setMaximumSectionSize(Theme::withText(widest));
    column->addWidget(table_, 1);

    message_ = new QLabel(this);
    message_->setWordWrap(true);
    column->addWidget(message_);
    auto* allButtons = new FoldingRow(0, this);  // at large text in a small window
    const auto partOf = [&](int share) {
        auto* part = new QWidget(allButtons);
        QHBoxLayout* layout = rowIn(part);
        allButtons->add(part, share);
        return layout;
    };
    QHBoxLayout* buttons = partOf(1);
    const auto button = [&](const char* name, const QString& text) {
        QPushButton* made = largeButton(name, text, this, buttonHeight);
        made->setAutoDefault(false);
        buttons->addWidget(made);
        return made;
    };
    open_ = button("journal_open", tr("&Open"));
    copy_ = button("journal_copy", tr("&Copy as new job"));
    remove_ = button("journal_remove", tr("&Remove…"));
    buttons->addStretch();
    buttons = partOf(0);
    export_ = button("journal_export", tr("&Export list as CSV…"));
    auto* close = button("journal_close", tr("C&lose"));
    column->addWidget(allButtons);

    connect(text_, &QLineEdit::textChanged, this, &JournalDialog::search);
    connect(unfinished_, &QCheckBox::toggled, this, &JournalDialog::search);
    connect(text_, &QLineEdit::returnPressed, this, [this] { choose(false); });
    text_->installEventFilter(this);
    connect(table_, &QTableWidget::activated, this, [this] { choose(false); });
    connect(open_, &QPushButton::clicked, this, [this] { choose(false); });
    connect(copy_, &QPushButton::clicked, this, [this] { choose(true); });
    connect(remove_, &QPushButton::clicked, this, &JournalDialog::removeSelected);
    connect(export_, &QPushButton::clicked, this, &JournalDialog::exportWithDialog);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    search();
    text_->setFocus();
    // As wide as its words, within the window.
    const int wanted = header->length() + Theme::withText(60);
    if (parent != nullptr && wanted > width()) {
        resize(std::max(width(), std::min(wanted, parent->window()->width())), height());
    }
}

QStringList JournalDialog::cellsOf(const Words& words, const JournalJob& job) const {
    const auto number = [&](const std::optional<double>& value, const Unit& unit) {
        return value ? words.digits(*value * unit, unit, 1) : QStringLiteral("–");
    };
    QStringList machine{verdictText(words, job.verdict)};
    if (job.frontReading || job.rearReading) {
        machine.prepend(number(job.frontReading, units::gram_mm) + QStringLiteral(" / ") +
                        number(job.rearReading, units::gram_mm));
    }
    machine.removeAll(QString());
    const ListedJob listed = listedJob(words, job);
    return {words.day(job.date.toString(Qt::ISODate)),
            job.engineNumber,
            job.crankshaftNumber,
            job.customer,
            listed.engine,
            job.technician,
            job.isFinished ? listed.result : tr("unfinished"),
            number(job.bobWeight, units::gram),
            machine.join(QStringLiteral(": "))};
}

void JournalDialog::search() {
    jobs_ = journal_->search({text_->text(), longestList + 1, unfinished_->isChecked()});
    truncated_ = jobs_.size() > longestList;
    if (truncated_) {
        jobs_.removeLast();
    }
    const Words words;
    table_->setRowCount(static_cast<int>(jobs_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const JournalJob& job = jobs_.at(row);
        const QStringList cells = cellsOf(words, job);
        for (int column = 0; column < cells.size(); ++column) {
            auto* cell = new QTableWidgetItem(cells.at(column));
            cell->setToolTip(cells.at(column));
            table_->setItem(row, column, cell);
        }
        const Theme& theme = Theme::instance();
        QTableWidgetItem* machine = table_->item(row, table_->columnCount() - 1);
        const VerdictKind kind = verdictKind(job.verdict);
        machine->setForeground(kind == VerdictKind::Pass   ? QBrush(theme.good())
                               : kind == VerdictKind::Fail ? QBrush(theme.error())
                               : kind == VerdictKind::Open ? QBrush(theme.warning())
                                                           : QBrush());
    }
    // What no job has needs no room.
    for (int column = 0; column < table_->columnCount(); ++column) {
        bool isEmpty = table_->rowCount() > 0;
        for (int row = 0; isEmpty && row < table_->rowCount(); ++row) {
            isEmpty = table_->item(row, column)->text().isEmpty();
        }
        table_->setColumnHidden(column, isEmpty);
    }
    if (table_->rowCount() > 0) {
        table_->setCurrentCell(0, 0);
    }
    for (QPushButton* button : {open_, copy_, remove_, export_}) {
        button->setEnabled(table_->rowCount() > 0);
    }
    message_->setText(
        !journal_->lastError().isEmpty() ? journal_->lastError()
        : jobs_.isEmpty()                ? tr("No job found.")
        : truncated_
            ? tr("The newest %1 jobs; more match. The export has them all.").arg(jobs_.size())
            : tr("Jobs found: %1").arg(jobs_.size()));
}

bool JournalDialog::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && watched == text_) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Up) {  // through the list, while one searches
            QApplication::sendEvent(table_, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

qint64 JournalDialog::selectedId() const {
    const int row = table_->currentRow();
    return row >= 0 && row < jobs_.size() ? jobs_.at(row).id : 0;
}

void JournalDialog::choose(bool isCopy) {
    chosen_ = selectedId();
    isCopy_ = isCopy;
    if (chosen_ != 0) {
        accept();
    }
}

void JournalDialog::removeSelected() {
    const qint64 id = selectedId();
    if (id == 0) {
        return;
    }
    const JournalJob& job = jobs_.at(table_->currentRow());
    const QString day = Words().day(job.date.toString(Qt::ISODate));
    if (QMessageBox::question(this, tr("Remove job"),
                              tr("Remove job %1 of %2 from the journal permanently?")
                                  .arg(job.numbers(), day.isEmpty() ? QStringLiteral("–") : day),
                              QMessageBox::Yes | QMessageBox::No,
                              QMessageBox::No) == QMessageBox::Yes) {
        if (!journal_->remove(id)) {
            message_->setText(journal_->lastError());
            return;
        }
        search();
    }
}

QString JournalDialog::exportTo(const QString& file) {
    // All that match, not only those that the list has room for.
    const QList<JournalJob> jobs =
        truncated_ ? journal_->search({text_->text(), -1, unfinished_->isChecked()}) : jobs_;
    return journal_->exportCsv(file, jobs) ? QString() : journal_->lastError();
}

void JournalDialog::exportWithDialog() {
    const QString file =
        askSavePath(this, tr("Export list"), QStringLiteral("journal.csv"), {csvFormat()});
    if (file.isEmpty()) {
        return;
    }
    const QString trouble = exportTo(file);
    message_->setText(trouble.isEmpty() ? tr("Written: %1").arg(file) : trouble);
}

}  // namespace ravnoves
