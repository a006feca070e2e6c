#include "shell/refused_entries.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMap>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>

#include "case-file/json.h"
#include "model/editable_table.h"
#include "model/scene_model.h"
#include "shell/scene_page.h"
#include "studies/tolerance_window.h"
#include "widgets/entry_field.h"
#include "widgets/table_editor.h"

namespace ravnoves {

namespace {

QString said(const char* text) {
    return QCoreApplication::translate("ravnoves::RefusedEntries", text);
}

ScenePage* pageOf(QWidget* part) {
    while (part != nullptr && qobject_cast<ScenePage*>(part) == nullptr) {
        part = part->parentWidget();
    }
    return static_cast<ScenePage*>(part);
}

/// Waits for what is being solved. @return false where the user does not, or it is refused
bool isSolved(SceneModel& model, const QWidget* part, const QString& title) {
    if (!model.isSolving()) {
        return true;
    }
    QMessageBox box(QMessageBox::Information, title,
                    said(QT_TRANSLATE_NOOP("ravnoves::RefusedEntries",
                                           "The last change is still being solved. When that is "
                                           "done, this goes on by itself.")),
                    QMessageBox::Cancel, part->window());
    bool isRefused = false;
    QObject::connect(&model, &SceneModel::notSolved, &box, [&isRefused] { isRefused = true; });
    QObject::connect(&model, &SceneModel::solvingChanged, &box, [&model, &box] {
        if (!model.isSolving()) {
            box.done(QMessageBox::Ignore);
        }
    });
    return box.exec() == QMessageBox::Ignore && !isRefused;
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
    const QWidget* page = wholePage(part);
    for (const ToleranceWindow* window : page->window()->findChildren<ToleranceWindow*>()) {
        if (window->page() == page) {
            for (const TableEditor* table : {window->inputs(), window->watched()}) {
                addTrouble(*table, refused);
            }
        }
    }
    return refused;
}

QStringList refusedInputs(const QWidget* part) {
    return refusedOf(part, true);
}

namespace {

/// A page of another size has its sections in another order.
QMap<QString, QList<EntryField*>> fieldsByName(const ScenePage& page) {
    QMap<QString, QList<EntryField*>> fields;
    for (EntryField* field : entriesOfPage(&page)) {
        fields[field->objectName()] << field;
    }
    return fields;
}

}  // namespace

Json refusedTexts(const ScenePage& page) {
    Json texts;
    const auto byName = fieldsByName(page);
    for (auto each = byName.cbegin(); each != byName.cend(); ++each) {
        const QList<EntryField*>& fields = each.value();
        for (qsizetype i = 0; i < fields.size(); ++i) {
            if (!fields[i]->trouble().isEmpty()) {
                texts.push_back({{"field", each.key().toStdString()},
                                 {"place", i},
                                 {"text", fields[i]->text().toStdString()}});
            }
        }
    }
    const auto tables = page.findChildren<TableEditor*>();
    for (qsizetype i = 0; i < tables.size(); ++i) {
        if (!tables[i]->trouble().isEmpty()) {
            texts.push_back({{"table", i}, {"cells", tables[i]->table()->refusedState()}});
        }
    }
    return texts;
}

void typeAgain(ScenePage& page, const Json& texts) {
    SceneModel& model = *page.model();
    const auto fields = fieldsByName(page);
    const auto tables = page.findChildren<TableEditor*>();
    for (const Json& each : texts) {
        const int steps = model.history()->index();
        try {
            // What is not there is of a copy of another version of the program.
            if (each.contains("table")) {
                if (TableEditor* table = tables.value(each.at("table").get<qsizetype>())) {
                    table->table()->bringRefused(each.at("cells"));
                }
            } else if (EntryField* field =
                           fields.value(QString::fromStdString(each.at("field").get<std::string>()))
                               .value(each.at("place").get<qsizetype>())) {
                field->typeAgain(QString::fromStdString(each.at("text").get<std::string>()));
            }
        } catch (const Json::exception&) {
            // A copy that is damaged here still holds its case.
        }
        while (model.history()->index() > steps) {
            model.undo();
        }
    }
}

bool takeBackRefused(const SceneModel& model) {
    QObject* where = model.newestRefused();
    if (auto* table = qobject_cast<TableEditor*>(where)) {
        return table->takeBackAnyRefused();
    }
    if (where != nullptr) {
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QCoreApplication::sendEvent(where, &escape);
    }
    return where != nullptr;
}

QString refusedWords(const QWidget* part) {
    const QStringList refused = refusedEntries(part);
    if (refused.isEmpty()) {
        return {};
    }
    return said(QT_TRANSLATE_NOOP("ravnoves::RefusedEntries",
                                  "These entries were refused; the values before them count:")) +
           QStringLiteral("\n\n") + refused.join(QLatin1Char('\n'));
}

bool goOnWithoutRefused(QWidget* part, const QString& title) {
    if (ScenePage* page = pageOf(part); page != nullptr && !isSolved(*page->model(), part, title)) {
        return false;
    }
    const QString words = refusedWords(part);
    if (words.isEmpty()) {
        return true;
    }
    QMessageBox box(QMessageBox::Warning, title, words, QMessageBox::Ignore | QMessageBox::Cancel,
                    part->window());
    box.button(QMessageBox::Ignore)
        ->setText(said(QT_TRANSLATE_NOOP("ravnoves::RefusedEntries", "&Go on without them")));
    box.button(QMessageBox::Cancel)
        ->setText(said(QT_TRANSLATE_NOOP("ravnoves::RefusedEntries", "&Stay")));
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Ignore;
}

}  // namespace ravnoves
