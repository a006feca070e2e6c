#pragma once

#include <array>
#include <vector>

#include "page/compared_figure.h"
#include "theme/theme.h"

namespace ravnoves {

class InertiaMomentsModel;
struct CsvFormat;

/// Amplitudes by order as bars: force, moment and roll moment; exact beside two-term beside what
/// is left over, each in the outline of the reference's. The height is the largest value of the
/// order's ellipse.
class OrderBars : public ComparedFigure {
    Q_OBJECT

  public:
    explicit OrderBars(InertiaMomentsModel* model, QWidget* parent = nullptr);

    bool isLogarithmic() const { return logarithmic_; }
    /// A logarithmic scale over six decades, so that high orders can be seen.
    void setLogarithmic(bool logarithmic);

    /// What the bars of one order show; [0] force, [1] moment, [2] roll moment.
    struct Group {
        double exact = 0.0;
        double twoTerm = 0.0;
        double left = 0.0;
    };
    std::vector<std::array<Group, 3>> groups() const { return groupsOf(*model_); }

    QSize sizeHint() const override { return {420, 260}; }
    QSize minimumSizeHint() const override { return {Theme::withText(240), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    QString sentence() const;
    QString table(const CsvFormat& format) const;
    static std::vector<std::array<Group, 3>> groupsOf(const InertiaMomentsModel& model);
    std::vector<std::array<Group, 3>> ghosts() const;  ///< the reference's; none without one
    QRectF panelRect(int panel) const;
    QRectF barsRect(int panel) const;

    InertiaMomentsModel* model_;
    bool logarithmic_ = false;
};

}  // namespace ravnoves
