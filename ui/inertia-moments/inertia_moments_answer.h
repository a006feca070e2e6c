#pragma once

#include <QWidget>

class QTabWidget;

namespace ravnoves {

class EngineView;
class InertiaMomentsModel;
class PicturePanel;

/// The picture of the engine and the tables of the answer.
class InertiaMomentsAnswer : public QWidget {
    Q_OBJECT

  public:
    InertiaMomentsAnswer(InertiaMomentsModel* model, QWidget* parent);

    EngineView* picture() const { return picture_; }
    PicturePanel* picturePanel() const { return picturePanel_; }

  private:
    void addTable(const char* part, const QString& title, const QString& name);

    InertiaMomentsModel* model_;
    EngineView* picture_;
    PicturePanel* picturePanel_;
    QTabWidget* tabs_;
};

}  // namespace ravnoves
