#include "shell/recovery_dialog.h"

#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "model/scene_model.h"
#include "page/scene_names.h"
#include "text/language.h"
#include "theme/theme.h"
#include "widgets/dialog_size.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {

namespace {

QLabel* recoveryText(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

RecoveryDialog::RecoveryDialog(const Recovery::Found& found, QWidget* parent)
    : QDialog(parent), cases_(found.cases) {
    setObjectName(QStringLiteral("recovery"));
    setWindowTitle(tr("Unsaved cases"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(Theme::space);
    if (!cases_.isEmpty()) {
        column->addWidget(
            recoveryText(tr("The program ended unexpectedly. These cases were not saved:"), this));
        list_ = new QTreeWidget(this);
        list_->setObjectName(QStringLiteral("recovered"));
        list_->setAccessibleName(tr("Unsaved cases"));
        list_->setRootIsDecorated(false);
        list_->setTextElideMode(Qt::ElideMiddle);
        list_->setHeaderLabels({tr("Case"), tr("File"), tr("Backup")});
        for (const RecoveredCase& each : cases_) {
            QStringList names{SceneModel::titleText(QString::fromStdString(each.content.title))};
            names << JobDesk::wordsOf(each.content);
            names.removeAll(QString());
            QString name = sceneTitle(QString::fromStdString(each.content.scene));
            if (!names.isEmpty()) {
                name += QStringLiteral(": ") + names.join(QStringLiteral(", "));
            }
            const QString path =
                each.path.isEmpty() ? tr("no file yet") : QDir::toNativeSeparators(each.path);
            auto* row = new QTreeWidgetItem(list_, {name, path, timeText(each.saved)});
            row->setCheckState(0, Qt::Checked);
            row->setToolTip(0, name);
            row->setToolTip(1, path);
        }
        list_->header()->setStretchLastSection(false);
        list_->header()->setSectionResizeMode(0, QHeaderView::Fixed);
        list_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
        list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
        list_->setCurrentItem(list_->topLevelItem(0));
        list_->viewport()->installEventFilter(this);
        column->addWidget(list_, 1);
    }
    for (const QString& file : found.damaged) {
        column->addWidget(recoveryText(
            tr("The copy of an unsaved case is damaged; it is now %1.").arg(file), this));
    }
    for (const QString& file : found.newer) {
        column->addWidget(recoveryText(
            tr("An unsaved case was written by a newer version of Ravnoves, which can open it: %1.")
                .arg(file),
            this));
    }
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    const auto add = [&](const char* name, const QString& text, auto&& slot) {
        auto* button = new QPushButton(text, this);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, slot);
        buttons->addWidget(button);
        return button;
    };
    if (!cases_.isEmpty()) {
        add("recovery_restore", tr("&Restore"), [this] {
            QList<RecoveredCase> ticked = takeTicked();
            // Tabs stand as they stood.
            std::stable_sort(
                ticked.begin(), ticked.end(),
                [](const RecoveredCase& a, const RecoveredCase& b) { return a.order < b.order; });
            for (const RecoveredCase& each : ticked) {
                Q_EMIT restored(each);
            }
        })->setDefault(true);
        add("recovery_throw_away", tr("&Discard"), [this] {
            if (!mayDiscard()) {
                return;
            }
            for (const RecoveredCase& each : takeTicked()) {
                Q_EMIT discarded(each);
            }
        })->setAutoDefault(false);
    }
    add("recovery_later", cases_.isEmpty() ? tr("&Close") : tr("&Later"), [this] {
        reject();
    })->setToolTip(cases_.isEmpty() ? QString() : tr("Ask again at the next start"));
    column->addLayout(buttons);
    resizeWithText(this, 640, cases_.isEmpty() ? 140 : 320);
}

/// The name has the room that the file leaves, and half of it at least.
bool RecoveryDialog::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && watched == list_->viewport()) {
        const QAbstractItemView* list = list_;
        const int room = list_->viewport()->width() - list_->header()->sectionSize(2);
        list_->header()->resizeSection(
            0, std::min(list->sizeHintForColumn(0),
                        std::max(room / 2, room - list->sizeHintForColumn(1))));
    }
    return QDialog::eventFilter(watched, event);
}

bool RecoveryDialog::mayDiscard() {
    constexpr qsizetype maximum = 8;  // a box has room for
    QStringList ticked;
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        if (list_->topLevelItem(row)->checkState(0) == Qt::Checked) {
            ticked << list_->topLevelItem(row)->text(0);
        }
    }
    const qsizetype count = ticked.size();
    if (count > maximum) {
        ticked = ticked.mid(0, maximum) << QStringLiteral("…");
    }
    return count > 0 &&
           QMessageBox::question(
               this, windowTitle(),
               tr("Delete the ticked cases permanently? Cases that will be deleted: %1.")
                       .arg(count) +
                   QStringLiteral("\n\n") + ticked.join(QLatin1Char('\n')),
               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

QList<RecoveredCase> RecoveryDialog::takeTicked() {
    QList<RecoveredCase> ticked;
    for (int row = list_->topLevelItemCount(); row-- > 0;) {
        if (list_->topLevelItem(row)->checkState(0) == Qt::Checked) {
            delete list_->takeTopLevelItem(row);
            ticked.prepend(cases_.takeAt(row));
        }
    }
    if (list_->topLevelItemCount() == 0) {
        accept();
    }
    return ticked;
}

}  // namespace ravnoves
