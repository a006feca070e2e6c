#include "shell/case_properties.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QShortcut>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>

#include "model/scene_model.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "widgets/layouts.h"

namespace ravnoves {

namespace {

/// Of a paste that is longer than notes are, what has no room is cut; a tip says so.
class NotesField final : public QPlainTextEdit {
  public:
    using QPlainTextEdit::QPlainTextEdit;

  protected:
    void insertFromMimeData(const QMimeData* source) override {
        constexpr qsizetype longest = 20'000;  // letters
        const qsizetype kept = toPlainText().size() - textCursor().selectedText().size();
        const qsizetype room = std::max<qsizetype>(longest - kept, 0);
        const QString text = source->text();
        insertPlainText(text.left(room));
        if (text.size() > room) {
            QToolTip::showText(mapToGlobal(QPoint(0, height())), cutText(static_cast<int>(longest)),
                               this);
        }
    }
};

}  // namespace

CaseProperties::CaseProperties(SceneModel* model, QWidget* parent)
    : QDialog(parent), model_(model) {
    setWindowTitle(tr("Title and notes"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(Theme::gap);
    const auto add = [&](const QString& name, const QString& hint, auto* field) {
        auto* label = new QLabel(name, this);
        label->setBuddy(field);
        field->setToolTip(hint);
        field->setAccessibleDescription(hint);
        column->addWidget(label);
        column->addWidget(field);
        return field;
    };
    title_ = add(tr("&Title"), tr("Title of the case, in its file and in the window"),
                 new QLineEdit(model->titleShown(), this));
    title_->setObjectName(QStringLiteral("case_title"));
    limitLength(title_, 200);
    notes_ = add(tr("&Notes"),
                 tr("Your notes on the case: sources, assumptions, open tasks. They are saved with "
                    "the case."),
                 new NotesField(model->notes(), this));
    notes_->setObjectName(QStringLiteral("case_notes"));
    notes_->setTabChangesFocus(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &CaseProperties::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &CaseProperties::reject);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {  // a new line is Return's in notes
        connect(new QShortcut(QKeySequence(Qt::CTRL | key), this), &QShortcut::activated, this,
                &CaseProperties::accept);
    }
    resizeWithText(this, 480, 320);
}

QString CaseProperties::title() const {
    const QString typed = title_->text().trimmed();
    return typed == model_->titleShown().trimmed() ? model_->title() : typed;
}

bool CaseProperties::isChanged() const {
    return title() != model_->title() || notes_->toPlainText() != model_->notes();
}

void CaseProperties::accept() {
    model_->editText(title(), notes_->toPlainText());
    QDialog::accept();
}

void CaseProperties::reject() {
    if (!isChanged()) {
        QDialog::reject();
        return;
    }
    QMessageBox box(QMessageBox::Question, windowTitle(), tr("Apply the changed title and notes?"),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.button(QMessageBox::Save)->setText(tr("&Apply"));
    box.button(QMessageBox::Discard)->setText(tr("&Discard"));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) {
        accept();
    } else if (answer == QMessageBox::Discard) {
        QDialog::reject();
    }
}

}  // namespace ravnoves
