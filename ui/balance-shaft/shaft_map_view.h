#pragma once

#include <QWidget>

#include "widgets/value_slider.h"

class QComboBox;
class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class PartPlot;
class ShaftMapModel;
class ShaftMapPlot;

/// Positions the shaft: the map of its places over the front view, the limits on them, and the cost
/// of the criterion in size.
class ShaftMapView : public QWidget {
    Q_OBJECT

  public:
    explicit ShaftMapView(BalanceShaftModel* model, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* buildBar();
    QWidget* buildLimits();
    QWidget* buildSizes();
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
    FieldSlider* distance_;
    QComboBox* criterion_;
    QPushButton* best_;
    QLabel* words_;
    QWidget* wordsRoom_;  ///< what the words may take
    ShaftMapPlot* plot_;
    PartPlot* sizes_;
};

}  // namespace ravnoves
