#pragma once

#include <QDialog>

class QLineEdit;
class QPlainTextEdit;

namespace ravnoves {

class SceneModel;

/// Title and notes of a case, as one step of its history.
class CaseProperties : public QDialog {
    Q_OBJECT

  public:
    CaseProperties(SceneModel* model, QWidget* parent);

    void accept() override;

  private:
    SceneModel* model_;
    QLineEdit* title_;
    QPlainTextEdit* notes_;
};

}  // namespace ravnoves
