#include "shell/variant_menu.h"

#include <QMessageBox>
#include <QToolButton>

#include "model/input_differences.h"
#include "page/scene_page.h"
#include "shell/variant_table.h"
#include "theme/icons.h"
#include "widgets/entry_field.h"

namespace ravnoves {

VariantMenu::VariantMenu(QWidget* parent)
    : QMenu(tr("&Variants"), parent), button_(new QToolButton(parent)) {
    setObjectName(QStringLiteral("variants"));
    setToolTipsVisible(true);
    setIcon(themedIcon(QStringLiteral("variants")));
    keep_ = add("keep", tr("&Keep as reference"), QKeySequence(Qt::CTRL | Qt::Key_K),
                tr("Keeps the present input as a variant; later changes are compared with it"),
                [this] { keep(); });
    addSeparator();
    none_ = add("none", tr("&No reference"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K),
                tr("Shows the present input alone; variants are kept"), [this] {
                    model_->chooseReference(-1);
                    none_->setChecked(true);
                });
    none_->setCheckable(true);
    QAction* const end = addSeparator();
    end->setObjectName(QStringLiteral("end-of-list"));
    table_ =
        add("table", tr("&Compare side by side…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D),
            tr("Shows the differences between the present input and all variants, then their "
               "results"),
            [this] {
                auto* dialog = new VariantTable(page_, parentWidget());
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->show();
            });
    onReference_ = {
        add("take", tr("&Use"), {},
            tr("The reference becomes the present input and remains the reference"),
            [this] { say(model_->takeVariant(model_->reference())); }),
        add("rename", tr("&Rename…"), {}, tr("Renames the reference"), [this] { rename(); }),
        add("delete", tr("&Delete"), {}, tr("Removes the reference from the case"),
            [this] { model_->removeVariant(model_->reference()); })};
    connect(this, &QMenu::aboutToShow, this, &VariantMenu::fillList);
    button_->setObjectName(QStringLiteral("variants_button"));
    button_->setMenu(this);
    button_->setPopupMode(QToolButton::InstantPopup);
    button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button_->setIcon(icon());
    button_->setAutoRaise(true);
    button_->setFocusPolicy(Qt::TabFocus);
    showState();
}

QAction* VariantMenu::add(const char* name, const QString& text, const QKeySequence& keys,
                          const QString& tip, const std::function<void()>& slot) {
    QAction* action = addAction(text);
    action->setObjectName(QLatin1String("variant_") + QLatin1String(name));
    action->setShortcut(keys);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, slot);
    return action;
}

void VariantMenu::setPage(ScenePage* page) {
    if (page_ == page) {
        return;
    }
    if (model_ != nullptr) {
        disconnect(model_, nullptr, this, nullptr);
    }
    page_ = page;
    model_ = page != nullptr ? page->model() : nullptr;
    if (model_ != nullptr) {
        connect(model_, &SceneModel::variantsChanged, this, &VariantMenu::showState);
    }
    showState();
}

void VariantMenu::showState() {
    const bool usable = page_ != nullptr && model_->hasCaseFile();
    const int reference = usable ? model_->reference() : -1;
    keep_->setEnabled(usable);
    none_->setChecked(reference < 0);
    none_->setEnabled(usable && !model_->variants().isEmpty());
    table_->setEnabled(none_->isEnabled());
    for (QAction* action : onReference_) {
        action->setEnabled(reference >= 0);
    }
    button_->setEnabled(usable);
    const QString name = reference >= 0 ? model_->variants().at(reference).name : QString();
    constexpr int longest = 16;
    button_->setText(name.size() > longest ? name.left(longest - 1) + QChar(0x2026) : name);
    button_->setToolButtonStyle(name.isEmpty() ? Qt::ToolButtonIconOnly
                                               : Qt::ToolButtonTextBesideIcon);
    QString tip = !usable          ? tr("This page has no inputs to keep as variants.")
                  : name.isEmpty() ? tr("Variants: keep the present input as reference (Ctrl+K); "
                                        "later changes are compared with it")
                                   : tr("Variants: the reference is %1").arg(name);
    const QString changed = reference >= 0 ? model_->changedFilesText(reference) : QString();
    if (!changed.isEmpty()) {
        tip += QLatin1Char('\n') + changed;
    }
    button_->setToolTip(tip);
    button_->setAccessibleName(tip);
}

void VariantMenu::fillList() {
    qDeleteAll(listed_);
    listed_.clear();
    if (page_ == nullptr || !model_->hasCaseFile()) {
        return;
    }
    QAction* const before = none_;
    for (int i = 0; i < model_->variants().size(); ++i) {
        QString text = model_->variants().at(i).name;
        text.replace(QLatin1Char('&'), QLatin1String("&&"));
        auto* action = new QAction(text, this);
        action->setObjectName(QStringLiteral("variant_%1").arg(i));
        const QString changed = model_->changedFilesText(i);
        action->setToolTip(changed.isEmpty() ? tr("Compare the present input with %1").arg(text)
                                             : changed);
        action->setCheckable(true);
        action->setChecked(i == model_->reference());
        connect(
            action, &QAction::triggered, this, [this, i] { model_->chooseReference(i); },
            Qt::QueuedConnection);
        insertAction(before, action);
        listed_ << action;
    }
}

void VariantMenu::keep() {
    model_->keepVariant(nameByDifferences(*model_));
    Q_EMIT page_->status(tr("Kept as variant %1; later changes are compared with it.")
                             .arg(model_->variants().constLast().name));
}

void VariantMenu::rename() {
    const int place = model_->reference();
    if (const auto name = askName(parentWidget(), tr("Rename variant"), tr("Name of the variant"),
                                  model_->variants().at(place).name)) {
        say(model_->renameVariant(place, *name));
    }
}

void VariantMenu::say(const QString& trouble) {
    if (!trouble.isEmpty()) {
        QMessageBox::warning(parentWidget(), tr("Variants"), trouble);
    }
}

}  // namespace ravnoves
