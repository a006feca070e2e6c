#pragma once

#include <QWidget>
#include <optional>

#include "widgets/field_slider.h"

class QComboBox;
class QPushButton;
class QTabWidget;
class QVBoxLayout;

namespace ravnoves {

class BalanceShaftModel;
class PartPlot;
class ShaftMapModel;
class ShaftMapPlot;

/// Positions the shaft: the map of its places over the front view, the criteria over the centre
/// distance, and their cost in size. The charts are beside the map where there is room, else on
/// tabs of their own.
class ShaftMapView : public QWidget {
    Q_OBJECT

  public:
    explicit ShaftMapView(BalanceShaftModel* model, QWidget* parent = nullptr);

    /// The minimum of the map alone: the charts move to tabs where there is no room.
    QSize minimumSizeHint() const override;

  protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* buildBar();
    QWidget* buildLimits();
    void buildCharts();
    void arrange();
    void showMap();
    void showPresent();
    void showStale();
    bool nothingIsBuilt() const;  ///< though there is something to balance
    void showWords(const QString& hovered = {});
    /// Room for the words, so that the map rests while they change.
    void fitWords();
    void pickSize(double size, double change);

    BalanceShaftModel* model_;
    ShaftMapModel* map_;
    QWidget* bar_;
    FieldSlider* distance_;
    QComboBox* criterion_;
    ValueSlider* weight_;
    QPushButton* best_;
    QLabel* words_;
    QWidget* wordsRoom_;  ///< what the words may take
    QTabWidget* tabs_;
    QWidget* side_;
    QVBoxLayout* sideColumn_;
    ShaftMapPlot* plot_;
    PartPlot* distances_;
    PartPlot* sizes_;
    std::optional<bool> wide_;  ///< the charts are beside the map
};

}  // namespace ravnoves
