#include "page/refused_entries.h"

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
    return QCoreApplication::translate("ravnoves::RefusedEntries", text);
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

void addTrouble(const TableEditor& table, QStringList& refused) {
    if (!table.trouble().isEmpty()) {
        refused << table.view()->accessibleName() + QStringLiteral(": ") + table.trouble();
    }
}

QStringList refusedOf(const QWidget* part, bool ofResultAlone) {
    QStringList refused;
    for (const EntryField* field : entriesOfPage(part)) {
        if (!field->trouble().isEmpty() && (field->isOfResult() || !ofResultAlone)) {
            refused << field->accessibleName() + QStringLiteral(": ") + field->trouble();
        }
    }
    for (const TableEditor* table : wholePage(part)->findChildren<TableEditor*>()) {
        addTrouble(*table, refused);
    }
    return refused;
}

}  // namespace

QStringList refusedEntries(const QWidget* part) {
    QStringList refused = refusedOf(part, false);
    if (const auto* page = qobject_cast<const ScenePage*>(wholePage(part))) {
        for (const QPointer<TableEditor>& table : page->tablesBeside()) {
            if (table) {
                addTrouble(*table, refused);
            }
        }
    }
    return refused;
}

QStringList refusedInputs(const QWidget* part) {
    return refusedOf(part, true);
}

QString refusedWords(const QWidget* part) {
    const QStringList refused = refusedEntries(part);
    if (refused.isEmpty()) {
        return {};
    }
    return said(QT_TRANSLATE_NOOP(
               "ravnoves::RefusedEntries",
               "These entries were not accepted; the previous values are used:")) +
           QStringLiteral("\n\n") + refused.join(QLatin1Char('\n'));
}

bool goOnWithoutRefused(QWidget* part, const QString& title) {
    const QString words = refusedWords(part);
    if (words.isEmpty()) {
        return true;
    }
    QMessageBox box(QMessageBox::Warning, title, words, QMessageBox::Ignore | QMessageBox::Cancel,
                    part->window());
    box.button(QMessageBox::Ignore)
        ->setText(said(QT_TRANSLATE_NOOP("ravnoves::RefusedEntries", "&Continue without them")));
    box.button(QMessageBox::Cancel)
        ->setText(said(QT_TRANSLATE_NOOP("ravnoves::RefusedEntries", "&Stay")));
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Ignore;
}

}  // namespace ravnoves
