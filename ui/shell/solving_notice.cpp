#include "shell/solving_notice.h"

#include <QLabel>
#include <QPushButton>

#include "model/scene_model.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

SolvingNotice::SolvingNotice(QWidget* parent)
    : NoticeBar(QStringLiteral("solving_notice"), parent),
      stop_(addButton(QStringLiteral("stop_solving"), tr("Cancel"),
                      tr("Give the change up and keep what holds."))) {
    connect(stop_, &QPushButton::clicked, this, [this] {
        if (model_ != nullptr) {
            model_->stopSolving();
        }
    });
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
    const QString words =
        !trouble.isEmpty() ? tr("The change was not taken: %1").arg(trouble)
        : isSolving
            ? tr("Solving… Until then the results are those of the input before the change.")
            : tr("Solving…");
    text()->setText(words);
    colourText(text(), trouble.isEmpty() ? &Theme::warning : &Theme::error);
    stop_->setVisible(isSolving);
    setVisible(isSolving || isWaiting || !trouble.isEmpty());
}

}  // namespace ravnoves
