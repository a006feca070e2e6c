#pragma once

#include <QWidget>

class QTabWidget;

namespace ravnoves {

class InertiaMomentsModel;
class PicturePanel;

/// The picture of the engine and the tables of the answer.
class InertiaMomentsAnswer : public QWidget {
    Q_OBJECT

  public:
    InertiaMomentsAnswer(InertiaMomentsModel* model, QWidget* parent);

    PicturePanel* picturePanel() const { return picturePanel_; }

  private:
    void addTable(const char* part, const QString& title, const QString& name);

    InertiaMomentsModel* model_;
    PicturePanel* picturePanel_;
    QTabWidget* tabs_;
};

}  // namespace ravnoves
