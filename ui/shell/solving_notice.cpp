#include "shell/solving_notice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "model/scene_model.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

SolvingNotice::SolvingNotice(QWidget* parent) : Panel(parent) {
    setObjectName(QStringLiteral("solving_notice"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    row->setSpacing(Theme::space);
    text_ = new QLabel(this);
    text_->setWordWrap(true);
    row->addWidget(text_, 1);
    stop_ = new QPushButton(tr("Cancel"), this);
    stop_->setObjectName(QStringLiteral("stop_solving"));
    stop_->setToolTip(tr("Give the change up and keep what holds."));
    row->addWidget(stop_);
    connect(stop_, &QPushButton::clicked, this, [this] {
        if (model_ != nullptr) {
            model_->stopSolving();
        }
    });
    hide();
}

void SolvingNotice::follow(SceneModel* model) {
    if (model_ != nullptr) {
        model_->disconnect(this);
    }
    model_ = model;
    if (model_ != nullptr) {
        connect(model_, &SceneModel::solvingChanged, this, [this] { say({}); });
        connect(model_, &SceneModel::changed, this, [this] { say({}); });
        connect(model_, &SceneModel::notSolved, this, &SolvingNotice::say);
        connect(model_, &QObject::destroyed, this, [this] { model_ = nullptr; });
    }
    say({});
}

void SolvingNotice::say(const QString& trouble) {
    const bool isSolving = model_ != nullptr && model_->isSolving();
    const bool isWaiting = model_ != nullptr && model_->isWaiting();
    const QString text =
        !trouble.isEmpty() ? tr("The change was not taken: %1").arg(trouble)
        : isSolving
            ? tr("Solving… Until then the results are those of the input before the change.")
            : tr("Solving…");
    text_->setText(text);
    colourText(text_, trouble.isEmpty() ? Theme::instance().warning() : Theme::instance().error());
    stop_->setVisible(isSolving);
    setVisible(isSolving || isWaiting || !trouble.isEmpty());
}

}  // namespace ravnoves
