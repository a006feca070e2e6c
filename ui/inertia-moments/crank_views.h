#pragma once

#include <QWidget>

#include "theme/theme.h"

namespace ravnoves {

class InertiaMomentsModel;

/// The crank star with the rotating masses' force and moment and the counterweights of the end
/// webs (the paper's Fig. 9), crankpin 1 up.
class CounterweightView : public QWidget {
    Q_OBJECT

  public:
    explicit CounterweightView(InertiaMomentsModel* model, QWidget* parent = nullptr);
    /// Its name, as of the table with the same content.
    static QString name() { return tr("Rotating masses and counterweights"); }
    QSize sizeHint() const override { return {420, 260}; }
    QSize minimumSizeHint() const override { return {Theme::withText(240), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    InertiaMomentsModel* model_;
};

/// The firing order as a wheel of 720°, with the intervals and the present crank angle.
class FiringWheel : public QWidget {
    Q_OBJECT

  public:
    explicit FiringWheel(InertiaMomentsModel* model, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {420, 260}; }
    QSize minimumSizeHint() const override { return {Theme::withText(240), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    InertiaMomentsModel* model_;
};

}  // namespace ravnoves
