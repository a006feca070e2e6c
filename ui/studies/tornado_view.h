#pragma once

#include <QWidget>
#include <vector>

#include "theme/theme.h"

namespace ravnoves {

class StudyModel;
struct StudyAnswer;

/// How much of a result's variance each input makes, the largest at the top: by itself, and pale
/// what it does together with others.
class TornadoView : public QWidget {
    Q_OBJECT

  public:
    struct Bar {
        QString name;
        double alone = 0.0;  ///< share of the variance, 0 … 1
        double whole = 0.0;  ///< with what it does together with others
    };

    explicit TornadoView(QWidget* parent = nullptr);

    /// @param title  what the shares are of
    void setBars(const QString& title, std::vector<Bar> bars);
    const std::vector<Bar>& bars() const { return bars_; }
    /// Pales what is drawn: newer numbers are on the way.
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
