#pragma once

#include "shell/notice_bar.h"

namespace ravnoves {

class SceneModel;

/// Over the page: that its results are not those of the last change, which is still being solved,
/// or why that was refused. Hidden where they are.
class SolvingNotice : public NoticeBar {
    Q_OBJECT

  public:
    explicit SolvingNotice(QWidget* parent = nullptr);

    /// Follows the model that is seen; null: none.
    void follow(SceneModel* model);

  private:
    void say(const QString& trouble);

    SceneModel* model_ = nullptr;
    QPushButton* stop_;
};

}  // namespace ravnoves
