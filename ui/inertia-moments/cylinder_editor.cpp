#include "inertia-moments/cylinder_editor.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "inertia-moments/model/cylinder_table_model.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

CylinderEditor::CylinderEditor(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model), table_(new CylinderTableModel(model, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    column->setSpacing(Theme::gap);
    state_ = captionLabel({}, this);
    column->addWidget(state_);

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
    addTool(QStringLiteral("plus"), tr("Add a cylinder below"), [this] {
        const QModelIndex current = view_->currentIndex();
        table_->insertBelow(current.isValid() ? current.row() : -1);
    })->setObjectName(QStringLiteral("add_cylinder"));
    addTool(QStringLiteral("minus"), tr("Remove the selected cylinders"), [this] {
        const QItemSelection selection = view_->selectionModel()->selection();
        if (!selection.isEmpty()) {
            table_->removeRowRange(selection.first().top(), selection.first().height());
        }
    })->setObjectName(QStringLiteral("remove_cylinder"));
    addTool(QStringLiteral("copy"), tr("Copy (Ctrl+C)"), [this] { copy(); });
    tools->addStretch();
    evenFiring_ = new QPushButton(tr("E&ven firing"), this);
    evenFiring_->setObjectName(QStringLiteral("even_firing"));
    evenFiring_->setToolTip(
        tr("Sets the crankpins so that the cylinders fire at even intervals over 720° in the "
           "firing order: against the in-line engine they are shifted by γ + 2 φ_TDC (the paper "
           "prints γ + φ_TDC; its own angle, 21°40′, is the one with 2)."));
    connect(evenFiring_, &QPushButton::clicked, this, [this] {
        say(model_->setEvenFiring());
        model_->finishDrag();
    });
    tools->addWidget(evenFiring_);
    column->addLayout(tools);

    view_ = new QTableView(this);
    view_->setModel(table_);
    view_->setAlternatingRowColors(true);
    view_->setAccessibleName(tr("Cylinders"));
    view_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    view_->horizontalHeader()->setMinimumSectionSize(30);
    view_->verticalHeader()->setDefaultSectionSize(22);
    view_->verticalHeader()->setMinimumWidth(22);
    view_->setFont(Theme::font(Theme::baseSize - 1));
    view_->setSelectionMode(QAbstractItemView::ContiguousSelection);
    view_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                           QAbstractItemView::AnyKeyPressed);
    view_->setTabKeyNavigation(false);
    view_->installEventFilter(this);
    column->addWidget(view_, 1);
    message_ = captionLabel({}, this);
    column->addWidget(message_);

    connect(table_, &CylinderTableModel::troubleChanged, this, &CylinderEditor::say);
    connect(model_, &SceneModel::changed, this, &CylinderEditor::showState);
    showState();
}

void CylinderEditor::showState() {
    state_->setText(model_->input().layout
                        ? tr("The cylinders of the layout chosen. Editing one makes this a table "
                             "of your own; Ctrl+V pastes from a spreadsheet.")
                        : tr("Your own table. Double-click a cell to edit; Ctrl+V pastes from a "
                             "spreadsheet."));
    const bool ordered = !model_->firingOrderText().isEmpty();
    evenFiring_->setEnabled(ordered);
}

void CylinderEditor::say(const QString& trouble) {
    QPalette palette = message_->palette();
    palette.setColor(QPalette::WindowText, Theme::instance().error());
    message_->setPalette(palette);
    message_->setText(trouble);
}

void CylinderEditor::copy() {
    const QItemSelection selection = view_->selectionModel()->selection();
    QItemSelectionRange range(table_->index(0, 0),
                              table_->index(table_->rowCount() - 1, table_->columnCount() - 1));
    if (!selection.isEmpty()) {
        range = selection.first();
    }
    QString text;
    for (int row = range.top(); row <= range.bottom(); ++row) {
        QStringList cells;
        for (int cell = range.left(); cell <= range.right(); ++cell) {
            cells << table_->index(row, cell).data(Qt::EditRole).toString();
        }
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text);
}

void CylinderEditor::paste() {
    const QModelIndex current = view_->currentIndex();
    say(table_->pasteBlock(current.isValid() ? current.row() : 0,
                           current.isValid() ? current.column() : 0,
                           QApplication::clipboard()->text()));
}

bool CylinderEditor::eventFilter(QObject* watched, QEvent* event) {
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
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ravnoves
