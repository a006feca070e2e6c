#pragma once

#include <QWidget>
#include <vector>

#include "text/result_row.h"

class QTabWidget;
class QLabel;

namespace ravnoves {

class EngineView;
class InertiaMomentsModel;
class PicturePanel;
class ResultTable;

/// The picture of the engine and the tables of the answer.
class InertiaMomentsAnswer : public QWidget {
    Q_OBJECT

  public:
    InertiaMomentsAnswer(InertiaMomentsModel* model, QWidget* parent);

    QString asText() const;
    QString asCsv() const;
    EngineView* picture() const { return picture_; }
    PicturePanel* picturePanel() const { return picturePanel_; }
    QTabWidget* tabs() const { return tabs_; }

  private:
    using Find = Results (InertiaMomentsModel::*)() const;
    struct Table {
        ResultTable* table;
        Find results;
    };

    void addTable(const QString& title, const QString& name, Find results);
    void showFront();
    /// Fills the tables that are not in front too.
    void fill() const;

    InertiaMomentsModel* model_;
    EngineView* picture_;
    PicturePanel* picturePanel_;
    QTabWidget* tabs_;
    std::vector<Table> tables_;
};

}  // namespace ravnoves
