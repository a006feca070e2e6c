#include "shell/new_case_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "shell/scene_list.h"
#include "theme/icons.h"
#include "theme/theme.h"

namespace ravnoves {

NewCaseDialog::NewCaseDialog(const QString& scene, QWidget* parent)
    : QDialog(parent), all_(newCases()) {
    setWindowTitle(tr("New case"));
    auto* column = new QVBoxLayout(this);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(Theme::margin);
    grid->setColumnStretch(1, 1);
    const auto list = [&](const QString& caption, const QString& name, int at) {
        auto* made = new QListWidget(this);
        made->setObjectName(name);
        made->setAccessibleName(QString(caption).remove(QLatin1Char('&')));
        made->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        auto* label = new QLabel(caption, this);
        label->setBuddy(made);
        grid->addWidget(label, 0, at);
        grid->addWidget(made, 1, at);
        return made;
    };
    scenes_ = list(tr("&Module"), QStringLiteral("new-scenes"), 0);
    scenes_->setIconSize(QSize(Theme::withText(28), Theme::withText(28)));
    beginnings_ = list(tr("&Start from"), QStringLiteral("new-beginnings"), 1);
    beginnings_->setWordWrap(true);
    for (const SceneInfo& info : sceneList()) {
        if (std::none_of(all_.begin(), all_.end(),
                         [&](const NewCase& each) { return each.scene == info.name; })) {
            continue;  // a page without cases
        }
        auto* item = new QListWidgetItem(themedIcon(QStringLiteral("scene-") + info.name),
                                         info.title, scenes_);
        item->setData(Qt::UserRole, info.name);
        item->setToolTip(info.summary);
        if (info.name == scene || scenes_->count() == 1) {
            scenes_->setCurrentItem(item);
        }
    }
    scenes_->setMinimumWidth(scenes_->sizeHintForColumn(0) + 2 * Theme::margin);
    scenes_->setMaximumWidth(scenes_->minimumWidth());
    column->addLayout(grid, 1);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    auto* create = buttons->addButton(tr("&Create"), QDialogButtonBox::AcceptRole);
    create->setObjectName(QStringLiteral("new-create"));
    create->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(scenes_, &QListWidget::currentRowChanged, this, &NewCaseDialog::fill);
    connect(beginnings_, &QListWidget::itemDoubleClicked, this, &QDialog::accept);
    fill();
    beginnings_->setFocus();
    resize(fontMetrics().averageCharWidth() * 90, fontMetrics().height() * 20);
}

void NewCaseDialog::fill() {
    const QString scene = scenes_->currentItem()->data(Qt::UserRole).toString();
    beginnings_->clear();
    for (std::size_t i = 0; i < all_.size(); ++i) {
        const NewCase& each = all_[i];
        if (each.scene != scene) {
            continue;
        }
        auto* item = new QListWidgetItem(listed(each), beginnings_);
        item->setData(Qt::UserRole, static_cast<int>(i));
    }
    beginnings_->setCurrentRow(0);
}

CaseFile NewCaseDialog::chosen() const {
    const int place = beginnings_->currentItem()->data(Qt::UserRole).toInt();
    return all_[static_cast<std::size_t>(place)].make();
}

std::optional<CaseFile> NewCaseDialog::ask(const QString& scene, QWidget* parent) {
    NewCaseDialog dialog(scene, parent);
    return dialog.exec() == Accepted ? std::optional(dialog.chosen()) : std::nullopt;
}

}  // namespace ravnoves
