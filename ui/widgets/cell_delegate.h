#pragma once

#include <QStyledItemDelegate>

namespace ravnoves {

/// Paints a cell of words or a number as the style does, in a third of the time: the style measures
/// its text, icon and mark anew for each of them, at every painting. What is selected, has the
/// focus, a mark, an icon or a ground of its own is the style's. Words that have no room end before
/// the unit behind them: "Front w…, g·mm".
class CellDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace ravnoves
