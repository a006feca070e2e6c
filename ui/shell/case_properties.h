#pragma once

#include <QDialog>

namespace ravnoves {

class SceneModel;

/// Title and notes of a case. However it is closed, both are taken as one step of the history.
class CaseProperties : public QDialog {
    Q_OBJECT

  public:
    CaseProperties(SceneModel* model, QWidget* parent);
};

}  // namespace ravnoves
