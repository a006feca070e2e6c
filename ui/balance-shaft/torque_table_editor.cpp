#include "balance-shaft/torque_table_editor.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/import_dialog.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/import_model.h"
#include "balance-shaft/model/torque_table_model.h"
#include "case-file/input_error.h"
#include "pictures/file_dialogs.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/write_file.h"

namespace ravnoves {

TorqueTableEditor::TorqueTableEditor(BalanceShaftModel* model, QWidget* parent)
    : TableEditor(new TorqueTableModel(model), tr("Torque table"), tr("Insert a row below"),
                  tr("Delete the selected rows"), parent),
      model_(model),
      table_(static_cast<TorqueTableModel*>(table())) {
    table_->setParent(this);
    caption()->setText(
        tr("Engine torque over one cycle, 720° (two-stroke 360°). Paste a whole table from a "
           "spreadsheet, or type."));
    addTool(QStringLiteral("import"), tr("Import CSV file…"), [this] { importWithDialog(); });
    addTool(QStringLiteral("export"), tr("Export CSV file…"), [this] {
        saveFile(this, tr("Export torque table"), QStringLiteral("torque.csv"), {csvFormat()},
                 [this](const QString& path) {
                     return writeFile(path, [this] {
                         return balance_shaft::write_torque_table(model_->input().torque.table);
                     });
                 });
    });
    connect(model_, &SceneModel::changed, this, [this] {
        if (trouble().isEmpty()) {
            say({}, false);  // what was said was of the table before
        }
    });
    connect(table_, &EditableTable::troubleChanged, this, [this](const QString& trouble) {
        const QString text = trouble.isEmpty()
                                 ? table_->strokesNote()
                                 : trouble + QLatin1Char('\n') +
                                       tr("The previous value is used until this is corrected.");
        say(text, !text.isEmpty());
    });
}

void TorqueTableEditor::importWithDialog() {
    const QString path = askOpenPath(this, tr("Import torque table"), {}, tablesFilter());
    if (!path.isEmpty()) {
        importFile(path);
    }
}

void TorqueTableEditor::importFile(const QString& path) {
    ImportModel file(balance_shaft::Measured::torque, slider_crank(model_->input()),
                     model_->input().strokes);
    file.open(path);
    ImportDialog dialog(&file, tr("Import torque table"), this);
    if (dialog.exec() == QDialog::Accepted) {
        table_->replaceBy(file.cycle()->table);
        say(tr("Read %1.").arg(messageText(file.cycle()->describe())), false);
    }
}

namespace {

/// Whether cells go from the beginning of a cycle to its end: meant for a table of their own, they
/// are not put among the rows of another.
bool isCycle(const std::vector<QStringList>& cells) {
    std::vector<double> angles;
    for (const QStringList& row : cells) {
        const auto angle = row.size() > 1 ? readFormNumber(row[0]) : std::nullopt;
        if (angle) {
            angles.push_back(*angle);
        }
    }
    constexpr std::size_t fewest = 3;
    constexpr double turn = 360.0;  // degrees
    return angles.size() >= fewest && angles.front() == 0.0 &&
           (angles.back() == turn || angles.back() == 2.0 * turn);
}

}  // namespace

void TorqueTableEditor::paste() {
    const QString text = QApplication::clipboard()->text();
    try {
        const QString what = tr("Read %1.").arg(table_->replaceByText(text.toStdString()));
        const QString& note = table_->strokesNote();
        say(note.isEmpty() ? what : what + QLatin1Char(' ') + note, !note.isEmpty());
    } catch (const InputError& error) {
        const auto cells = readTextTable(text);
        const auto rows = static_cast<int>(cells.size());
        if (!isCycle(cells) && rows < table_->rowCount() &&
            (rows == 0 || view()->currentIndex().isValid())) {
            TableEditor::paste();
        } else {
            say(tr("Not pasted: %1").arg(errorText(error)), true);
        }
    }
}

}  // namespace ravnoves
