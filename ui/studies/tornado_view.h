#pragma once

#include <QWidget>
#include <vector>

#include "theme/theme.h"

namespace ravnoves {

class StudyModel;
struct StudyAnswer;

/// The share of each input in a result's variance, the largest at the top: alone, and dimmed with
/// its interactions.
class TornadoView : public QWidget {
    Q_OBJECT

  public:
    struct Bar {
        QString name;
        double alone = 0.0;  ///< share of the variance, 0 … 1
        double whole = 0.0;  ///< with its interactions
    };

    explicit TornadoView(QWidget* parent = nullptr);

    /// @param title  what the shares are of
    void setBars(const QString& title, std::vector<Bar> bars);
    /// Dims the drawing: newer numbers are being computed.
    void setFaded(bool faded);

    QSize sizeHint() const override { return {420, 240}; }
    QSize minimumSizeHint() const override { return {Theme::withText(220), Theme::withText(120)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString title_;
    std::vector<Bar> bars_;
    bool faded_ = false;
};

/// The shares of a study's inputs in a result.
void showShares(TornadoView& view, const StudyAnswer& value, const StudyModel& study);

}  // namespace ravnoves
