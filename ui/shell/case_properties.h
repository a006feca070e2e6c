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
    /// Also by Escape; changes are asked for.
    void reject() override;

  private:
    /// As the case is to have it.
    QString title() const;
    bool isChanged() const;

    SceneModel* model_;
    QLineEdit* title_;
    QPlainTextEdit* notes_;
};

}  // namespace ravnoves
