#include "page/rejected_entries.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>

#include "model/scene_model.h"
#include "page/scene_page.h"
#include "widgets/entry_field.h"
#include "widgets/page_columns.h"
#include "widgets/table_editor.h"

namespace ravnoves {

namespace {

struct RejectedEntries {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::RejectedEntries)
};

/// The page, or a window beside it.
template <typename Widget>
Widget* pageOf(Widget* part) {
    while (qobject_cast<const ScenePage*>(part) == nullptr && !part->isWindow()) {
        part = part->parentWidget();
    }
    return part;
}

/// Of a page; null of a window.
const SceneModel* modelOf(const QWidget* part) {
    return part->findChild<SceneModel*>({}, Qt::FindDirectChildrenOnly);
}

/// What has rejected texts: of a page also tables in windows beside it, of a window its tables.
QList<QObject*> rejectedIn(const QWidget* part) {
    if (const SceneModel* model = modelOf(part)) {
        return model->rejectedIn();
    }
    QList<QObject*> tables;
    for (TableEditor* table : part->findChildren<TableEditor*>()) {
        if (!table->trouble().isEmpty()) {
            tables << table;
        }
    }
    return tables;
}

/// Brings the part to the front, with the entry that was rejected first.
void showRejected(QWidget* part) {
    if (auto* page = qobject_cast<ScenePage*>(part)) {
        Q_EMIT page->frontWanted();
    }
    for (QObject* each : rejectedIn(part)) {
        auto* field = static_cast<QWidget*>(each);
        if (part->isAncestorOf(field)) {
            showTabOf(field);
            field->setFocus();
            if (auto* entry = qobject_cast<EntryField*>(field)) {
                entry->selectAll();  // what is typed next takes its place
            } else if (auto* table = qobject_cast<TableEditor*>(field)) {
                table->showRejected();
            }
            return;
        }
    }
}

QStringList rejectedOf(const QWidget* part, bool ofResultAlone, const Retold& retold) {
    part = pageOf(part);
    QStringList rejected;
    for (const EntryField* field : part->findChildren<EntryField*>()) {
        if (!field->trouble().isEmpty() && (field->isOfResult() || !ofResultAlone)) {
            rejected << (retold
                             ? retold(*field)
                             : field->accessibleName() + QStringLiteral(": ") + field->trouble());
        }
    }
    for (QObject* each : rejectedIn(part)) {
        const auto* table = qobject_cast<TableEditor*>(each);
        // One of the tolerances is in a window beside.
        if (table != nullptr && (part->isAncestorOf(table) || !ofResultAlone)) {
            rejected << table->view()->accessibleName() + QStringLiteral(": ") + table->trouble();
        }
    }
    return rejected;
}

QString under(const QString& name, const QString& words) {
    return name.isEmpty() ? words : name + QStringLiteral("\n\n") + words;
}

}  // namespace

QStringList rejectedEntries(const QWidget* part, const Retold& retold) {
    return rejectedOf(part, false, retold);
}

QStringList rejectedInputs(const QWidget* part, const Retold& retold) {
    return rejectedOf(part, true, retold);
}

QString rejectedWords(const QWidget* part) {
    const SceneModel* model = modelOf(pageOf(part));
    const bool leavesOut = model != nullptr && model->leavesOutRejected();
    const QStringList leftOut = leavesOut ? rejectedInputs(part) : QStringList();
    QStringList replaced = rejectedEntries(part);
    for (const QString& each : leftOut) {
        replaced.removeOne(each);
    }
    QStringList said;
    const auto say = [&said](const QString& how, const QStringList& entries) {
        if (!entries.isEmpty()) {
            said << how << entries.join(QLatin1Char('\n'));
        }
    };
    say(RejectedEntries::tr("These entries were not accepted and are left out:"), leftOut);
    say(RejectedEntries::tr("These entries were not accepted; the previous values are used:"),
        replaced);
    return said.join(QStringLiteral("\n\n"));
}

bool mayBeSaved(QWidget* part, const QString& title, const QString& name) {
    const QString why = modelOf(pageOf(part))->mustBeCorrected();
    if (why.isEmpty()) {
        return true;
    }
    QMessageBox::warning(part->window(), title, under(name, why));
    showRejected(pageOf(part));
    return false;
}

bool saveWithoutRejected(QWidget* part, const QString& title, const QString& name) {
    return mayBeSaved(part, title, name) && continueWithoutRejected(part, title, name);
}

bool continueWithoutRejected(QWidget* part, const QString& title, const QString& name) {
    const QString words = rejectedWords(part);
    if (words.isEmpty()) {
        return true;
    }
    QMessageBox box(QMessageBox::Warning, title, under(name, words),
                    QMessageBox::Ignore | QMessageBox::Cancel, part->window());
    box.button(QMessageBox::Ignore)->setText(RejectedEntries::tr("&Continue without them"));
    box.button(QMessageBox::Cancel)->setText(RejectedEntries::tr("&Stay"));
    box.setDefaultButton(QMessageBox::Cancel);
    if (box.exec() == QMessageBox::Ignore) {
        return true;
    }
    showRejected(pageOf(part));
    return false;
}

}  // namespace ravnoves
