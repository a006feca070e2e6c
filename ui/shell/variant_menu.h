#pragma once

#include <QMenu>
#include <QPointer>
#include <functional>

#include "model/scene_model.h"

class QToolButton;

namespace ravnoves {

class ScenePage;

/// Keeps, chooses, renames and deletes the variants of the page in front. A menu and a
/// button of the toolbar that opens it and shows which variant is the reference.
class VariantMenu : public QMenu {
    Q_OBJECT

  public:
    explicit VariantMenu(QWidget* parent);

    /// The page in front.
    void setPage(ScenePage* page);
    QToolButton* button() const { return button_; }

  private:
    QAction* add(const char* name, const QString& text, const QKeySequence& keys,
                 const QString& tip, const std::function<void()>& slot);
    void showState();
    void fillList();
    void keep();
    void rename();
    void say(const QString& trouble);

    QPointer<ScenePage> page_;
    QPointer<SceneModel> model_;  ///< of the page
    QToolButton* button_;
    QList<QAction*> listed_;
    QList<QAction*> onReference_;  ///< need a reference
    QAction* keep_;
    QAction* none_;
    QAction* table_;
};

}  // namespace ravnoves
