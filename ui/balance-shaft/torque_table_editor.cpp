#include "balance-shaft/torque_table_editor.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/torque_table_model.h"
#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

TorqueTableEditor::TorqueTableEditor(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      table_(new TorqueTableModel([] { return Theme::instance().error(); }, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    column->setSpacing(Theme::gap);
    column->addWidget(captionLabel(
        tr("Engine torque over one four-stroke cycle, 720°. Paste a whole table from a "
           "spreadsheet, or type."),
        this));

    auto* tools = new QHBoxLayout;
    tools->setSpacing(2);
    const auto addTool = [&](const QString& icon, const QString& tip, auto slot) {
        auto* button = new QToolButton(this);
        button->setIcon(themedIcon(icon));
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        button->setAutoRaise(true);
        button->setIconSize(QSize(18, 18));
        connect(button, &QToolButton::clicked, this, slot);
        tools->addWidget(button);
        return button;
    };
    addTool(QStringLiteral("import"), tr("Import CSV file…"), [this] {
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Import torque table"), QString(),
                                         tr("Tables (*.csv *.txt *.tsv);;All files (*)"));
        if (path.isEmpty()) {
            return;
        }
        const QString trouble = importFile(path);
        if (!trouble.isEmpty()) {
            QMessageBox::warning(this, tr("Import torque table"), trouble);
        }
    });
    addTool(QStringLiteral("export"), tr("Export CSV file…"), [this] {
        const QString path =
            QFileDialog::getSaveFileName(this, tr("Export torque table"),
                                         QStringLiteral("torque.csv"), tr("CSV tables (*.csv)"));
        if (path.isEmpty()) {
            return;
        }
        try {
            write_text_file(fsPath(path),
                            balance_shaft::write_torque_table(model_->input().torque.table));
        } catch (const InputError& error) {
            QMessageBox::warning(this, tr("Export torque table"),
                                 path + QStringLiteral(": ") + errorText(error));
        }
    });
    addTool(QStringLiteral("copy"), tr("Copy (Ctrl+C)"), [this] { copy(); });
    addTool(QStringLiteral("plus"), tr("Insert a row below"), [this] {
        table_->insertRowBelow(view_->currentIndex().isValid() ? view_->currentIndex().row() : 0);
    });
    addTool(QStringLiteral("minus"), tr("Delete the selected rows"), [this] {
        const QItemSelection selection = view_->selectionModel()->selection();
        if (!selection.isEmpty()) {
            table_->removeRowRange(selection.first().top(), selection.first().height());
        }
    });
    tools->addStretch();
    column->addLayout(tools);

    view_ = new QTableView(this);
    view_->setModel(table_);
    view_->setAlternatingRowColors(true);
    view_->setAccessibleName(tr("Torque table"));
    view_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    view_->verticalHeader()->setDefaultSectionSize(22);
    view_->setSelectionMode(QAbstractItemView::ContiguousSelection);
    view_->installEventFilter(this);
    column->addWidget(view_, 1);
    message_ = captionLabel({}, this);
    column->addWidget(message_);

    table_->setTable(model_->input().torque.table);
    connect(model_, &SceneModel::changed, this,
            [this] { table_->setTable(model_->input().torque.table); });
    connect(table_, &TorqueTableModel::tableEdited, this, [this] {
        model_->edit(tr("Edit torque table"), [this](balance_shaft::Input& input) {
            input.torque.kind = balance_shaft::TorqueSource::Kind::table;
            input.torque.csv.clear();
            input.torque.table = table_->checkedTable();
        });
    });
    connect(table_, &TorqueTableModel::troubleChanged, this, [this](const QString& trouble) {
        say(trouble.isEmpty() ? QString()
                              : trouble + QLatin1Char('\n') +
                                    tr("The last valid table holds until this is mended."),
            !trouble.isEmpty());
    });
}

void TorqueTableEditor::say(const QString& text, bool isTrouble) {
    QPalette palette = message_->palette();
    palette.setColor(QPalette::WindowText,
                     isTrouble ? Theme::instance().error() : Theme::instance().mutedText());
    message_->setPalette(palette);
    message_->setText(text);
}

QString TorqueTableEditor::importFile(const QString& path) {
    try {
        const std::string text = read_text_file(fsPath(path));
        const QString what = table_->replaceByText(QString::fromStdString(text));
        say(tr("Read %1.").arg(what), false);
        return {};
    } catch (const InputError& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
}

void TorqueTableEditor::paste() {
    const QString text = QApplication::clipboard()->text();
    if (text.trimmed().isEmpty()) {
        say(tr("The clipboard holds no table."), true);
        return;
    }
    // A whole cycle replaces the table; anything smaller goes into the cells from the current one.
    try {
        const QString what = table_->replaceByText(text);
        say(tr("Read %1.").arg(what), false);
    } catch (const InputError& error) {
        const bool block = text.trimmed().count(QLatin1Char('\n')) + 1 < table_->rowCount() &&
                           view_->currentIndex().isValid();
        if (block) {
            table_->pasteBlock(view_->currentIndex().row(), view_->currentIndex().column(), text);
        } else {
            say(tr("Not pasted: %1").arg(errorText(error)), true);
        }
    }
}

void TorqueTableEditor::copy() {
    const QItemSelection selection = view_->selectionModel()->selection();
    if (selection.isEmpty()) {
        QApplication::clipboard()->setText(QString::fromStdString(
            balance_shaft::write_torque_table(model_->input().torque.table)));
        return;
    }
    QString text;
    const QItemSelectionRange& range = selection.first();
    for (int row = range.top(); row <= range.bottom(); ++row) {
        QStringList cells;
        for (int cell = range.left(); cell <= range.right(); ++cell) {
            cells << table_->index(row, cell).data(Qt::DisplayRole).toString();
        }
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text);
}

bool TorqueTableEditor::eventFilter(QObject* watched, QEvent* event) {
    if (watched == view_ && event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Paste)) {
            paste();
            return true;
        }
        if (key->matches(QKeySequence::Copy)) {
            copy();
            return true;
        }
        if (key->key() == Qt::Key_Delete) {
            const QItemSelection selection = view_->selectionModel()->selection();
            if (!selection.isEmpty()) {
                table_->removeRowRange(selection.first().top(), selection.first().height());
            }
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ravnoves
