#include "widgets/table_editor.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QResizeEvent>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <algorithm>
#include <exception>
#include <new>

#include "model/scene_model.h"
#include "text/error_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"

namespace ravnoves {

namespace {

/// Colours what was rejected.
class TroubleDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.data(EditableTable::TroubleRole).toBool()) {
            option->palette.setColor(QPalette::Text, Theme::instance().error());
        }
    }
};

/// Its current cell stays in sight where a message below takes of its height.
class CellView final : public QTableView {
  public:
    using QTableView::QTableView;

  protected:
    void resizeEvent(QResizeEvent* event) override {
        const bool wasSeen =
            QRect(QPoint(), event->oldSize()).contains(visualRect(currentIndex()).center());
        QTableView::resizeEvent(event);
        if (wasSeen) {
            scrollTo(currentIndex());
        }
    }
};

}  // namespace

TableEditor::TableEditor(EditableTable* table, const QString& name, const QString& addTip,
                         const QString& removeTip, QWidget* parent)
    : QWidget(parent), table_(table), tools_(new QHBoxLayout) {
    QVBoxLayout* column = columnIn(this, Theme::gap, panelMargins);
    caption_ = captionLabel({}, this);
    column->addWidget(caption_);
    tools_->setSpacing(2);
    tools_->addStretch();
    column->addLayout(tools_);
    view_ = new CellView(this);
    view_->setModel(table_);
    view_->setItemDelegate(new TroubleDelegate(view_));
    view_->setAlternatingRowColors(true);
    view_->setAccessibleName(name);
    view_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    view_->horizontalHeader()->setMinimumSectionSize(Theme::withText(30));
    view_->verticalHeader()->setDefaultSectionSize(Theme::withText(22));
    view_->verticalHeader()->setMinimumWidth(Theme::withText(22));
    view_->setFont(Theme::font(Theme::baseSize - 1));
    view_->setSelectionMode(QAbstractItemView::ContiguousSelection);
    view_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                           QAbstractItemView::AnyKeyPressed);
    view_->setTabKeyNavigation(false);
    view_->installEventFilter(this);
    setFocusProxy(view_);
    column->addWidget(view_, 1);
    message_ = new TroubleLine(this);
    column->addWidget(message_);
    // A table that is shown again keeps its current cell, unless another was chosen meanwhile.
    connect(table_, &EditableTable::modelAboutToBeReset, this, [this] {
        const QModelIndex at = view_->currentIndex();
        const auto restore = [this, row = at.row(), column = at.column()] {
            if (!view_->currentIndex().isValid()) {
                view_->setCurrentIndex(
                    table_->index(std::min(row, table_->rowCount() - 1), column));
            }
        };
        if (at.isValid()) {
            connect(table_, &EditableTable::modelReset, this, restore,
                    Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
        }
    });
    const auto note = [this] { table_->scene()->noteRejected(this, !trouble_.isEmpty()); };
    connect(table_, &EditableTable::troubleChanged, this, [this, note](const QString& trouble) {
        trouble_ = trouble;
        note();
    });
    connect(table_, &EditableTable::dataChanged, this, [this, note] {
        if (!trouble_.isEmpty()) {
            note();  // another text is rejected now
        }
    });

    addTool(QStringLiteral("copy"), tr("Copy (Ctrl+C)"), [this] { copy(); });
    addTool(QStringLiteral("plus"), addTip, [this] {
        const QModelIndex at = view_->currentIndex();
        // What is typed next is the new row's.
        if (const int added = table_->insertRowBelow(at.row()); added >= 0) {
            view_->setCurrentIndex(table_->index(added, std::max(at.column(), 0)));
        }
    })->setObjectName(QStringLiteral("add_row"));
    addTool(QStringLiteral("minus"), removeTip, [this] {
        removeSelected();
    })->setObjectName(QStringLiteral("remove_row"));
}

QToolButton* TableEditor::addTool(const QString& icon, const QString& tip,
                                  std::function<void()> use) {
    auto* button = new QToolButton(this);
    button->setIcon(themedIcon(icon));
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setAutoRaise(true);
    button->setIconSize(QSize(Theme::withText(18), Theme::withText(18)));
    connect(button, &QToolButton::clicked, this, std::move(use));
    tools_->insertWidget(toolCount_++, button);
    return button;
}

void TableEditor::say(const QString& text, bool isTrouble) {
    message_->say(text, isTrouble);
}

void TableEditor::removeSelected() {
    const QItemSelection selection = view_->selectionModel()->selection();
    if (!selection.isEmpty()) {
        table_->removeRowRange(selection.first().top(), selection.first().height());
    }
}

void TableEditor::copy() const {
    const QItemSelection selection = view_->selectionModel()->selection();
    const QItemSelectionRange range =
        selection.isEmpty()
            ? QItemSelectionRange(table_->index(0, 0),
                                  table_->index(table_->rowCount() - 1, table_->columnCount() - 1))
            : selection.first();
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

void TableEditor::paste() {
    const std::vector<QStringList> cells = readTextTable(QApplication::clipboard()->text());
    if (cells.empty()) {
        say(tr("The clipboard contains no numbers."), true);
        return;
    }
    const QModelIndex at = view_->currentIndex();
    const QString trouble = table_->paste(std::max(at.row(), 0), std::max(at.column(), 0), cells);
    if (!trouble.isEmpty()) {
        say(trouble, true);
    }
}

void TableEditor::tryPaste() {
    try {
        paste();
    } catch (const std::bad_alloc&) {
        say(errorText(std::current_exception()), true);
    }
}

bool TableEditor::takeBackRejected() {
    const QModelIndex at = view_->currentIndex();
    const int row = at.row();
    const int column = at.column();
    if (!at.data(EditableTable::TroubleRole).toBool()) {
        return false;
    }
    table_->takeBackRejected(at);
    if (!view_->currentIndex().isValid() && row >= 0) {  // the whole table was shown again
        view_->setCurrentIndex(table_->index(row, column));
    }
    return true;
}

void TableEditor::showRejected() {
    for (int row = 0; row < table_->rowCount(); ++row) {
        for (int column = 0; column < table_->columnCount(); ++column) {
            const QModelIndex at = table_->index(row, column);
            if (at.data(EditableTable::TroubleRole).toBool()) {
                view_->setCurrentIndex(at);
                view_->scrollTo(at);
                return;
            }
        }
    }
}

bool TableEditor::eventFilter(QObject* watched, QEvent* event) {
    if (watched == view_ && event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo) &&
        view_->currentIndex().data(EditableTable::TroubleRole).toBool()) {
        event->accept();  // then it comes as a key
        return true;
    }
    if (watched == view_ && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Paste)) {
            tryPaste();
        } else if (key->matches(QKeySequence::Copy)) {
            copy();
        } else if (key->matches(QKeySequence::Undo) || key->key() == Qt::Key_Escape) {
            return takeBackRejected();
        } else if (key->key() == Qt::Key_Delete) {
            removeSelected();
        } else {
            return false;
        }
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ravnoves
