#include "page/rejected_entries.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>

#include "model/scene_model.h"
#include "page/scene_page.h"
#include "widgets/entry_field.h"
#include "widgets/table_editor.h"

namespace ravnoves {

namespace {

QString said(const char* text) {
    return QCoreApplication::translate("ravnoves::RejectedEntries", text);
}

const QWidget* wholePage(const QWidget* part) {
    while (qobject_cast<const ScenePage*>(part) == nullptr && part->parentWidget() != nullptr) {
        part = part->parentWidget();
    }
    return part;
}

}  // namespace

QList<EntryField*> entriesOfPage(const QWidget* part) {
    return wholePage(part)->findChildren<EntryField*>();
}

namespace {

void addTrouble(const TableEditor& table, QStringList& rejected) {
    if (!table.trouble().isEmpty()) {
        rejected << table.view()->accessibleName() + QStringLiteral(": ") + table.trouble();
    }
}

QStringList rejectedOf(const QWidget* part, bool ofResultAlone) {
    QStringList rejected;
    for (const EntryField* field : entriesOfPage(part)) {
        if (!field->trouble().isEmpty() && (field->isOfResult() || !ofResultAlone)) {
            rejected << field->accessibleName() + QStringLiteral(": ") + field->trouble();
        }
    }
    for (const TableEditor* table : wholePage(part)->findChildren<TableEditor*>()) {
        addTrouble(*table, rejected);
    }
    return rejected;
}

}  // namespace

QStringList rejectedEntries(const QWidget* part) {
    QStringList rejected = rejectedOf(part, false);
    if (const auto* page = qobject_cast<const ScenePage*>(wholePage(part))) {
        for (const QPointer<TableEditor>& table : page->tablesBeside()) {
            if (table) {
                addTrouble(*table, rejected);
            }
        }
    }
    return rejected;
}

QStringList rejectedInputs(const QWidget* part) {
    return rejectedOf(part, true);
}

QString rejectedWords(const QWidget* part) {
    const QStringList rejected = rejectedEntries(part);
    if (rejected.isEmpty()) {
        return {};
    }
    return said(QT_TRANSLATE_NOOP(
               "ravnoves::RejectedEntries",
               "These entries were not accepted; the previous values are used:")) +
           QStringLiteral("\n\n") + rejected.join(QLatin1Char('\n'));
}

bool continueWithoutRejected(QWidget* part, const QString& title) {
    const QString words = rejectedWords(part);
    if (words.isEmpty()) {
        return true;
    }
    QMessageBox box(QMessageBox::Warning, title, words, QMessageBox::Ignore | QMessageBox::Cancel,
                    part->window());
    box.button(QMessageBox::Ignore)
        ->setText(said(QT_TRANSLATE_NOOP("ravnoves::RejectedEntries", "&Continue without them")));
    box.button(QMessageBox::Cancel)
        ->setText(said(QT_TRANSLATE_NOOP("ravnoves::RejectedEntries", "&Stay")));
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Ignore;
}

}  // namespace ravnoves
