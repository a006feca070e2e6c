#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QStringList>
#include <functional>
#include <vector>

#include "text/result_row.h"

namespace ravnoves {

/// Sheets of paper in millimetres from their upper left corner, with type in points: what the job
/// card is drawn on. What a sheet has no room for continues on the next one.
class CardPage {
  public:
    static constexpr double width = 210.0;   ///< A4, mm
    static constexpr double height = 297.0;  ///< mm

    static constexpr double left = 16.0;  ///< where the print begins, with room to file it, mm
    static constexpr double right = width - 12.0;
    static constexpr double top = 11.0;
    static constexpr double bottom = 289.0;  ///< where the print ends
    static constexpr double full = right - left;

    static const QColor ink;
    static const QColor grey;   ///< captions
    static const QColor hair;   ///< thin lines
    static const QColor shade;  ///< behind what matters
    static const QColor amber;  ///< what does not count
    static const QColor red;    ///< STOP

    /// @param page  the whole sheet in the painter's units
    CardPage(QPainter& painter, const QRectF& page);

    QPainter& painter() { return painter_; }
    double unit() const { return unit_; }  ///< painter's units in a millimetre
    QFont font(double points, bool bold = false) const;
    QRectF rect(double x, double y, double w, double h) const;
    double lineHeight(double points) const;                                         ///< mm
    double textWidth(const QString& text, double points, bool bold = false) const;  ///< mm

    void line(double x1, double y1, double x2, double y2, double thickness = 0.15,
              const QColor& colour = hair);
    void box(double x, double y, double w, double h, const QColor& fill,
             const QColor& border = hair, double thickness = 0.15);
    /// One line; a text that is too wide is set smaller, as far as it can be read, then elided. For
    /// labels: sentences and typed texts are paragraphs.
    void text(double x, double y, double w, const QString& text, double points = 8.5,
              Qt::Alignment align = Qt::AlignLeft, bool bold = false, const QColor& colour = ink);
    static constexpr double smallestType = 6.0;  ///< points; less is not read in a workshop
    /// Height of wrapped text with all its lines, mm.
    double heightOf(const QString& text, double points, double w, bool bold = false) const;
    /// Wrapped text with all its lines.
    /// @return its height, mm
    double paragraph(double x, double y, double w, const QString& text, double points,
                     bool bold = false, const QColor& colour = ink,
                     Qt::Alignment align = Qt::AlignLeft);
    void heading(double x, double y, double w, const QString& title);
    /// A value with its small caption above and a line below to write on.
    /// @return its height, mm
    double blank(double x, double y, double w, const QString& caption, const QString& value);

    // ------------------------------------------------------------------------------- sheets

    int number() const { return number_; }  ///< of the sheet, from 1
    /// Where the contents of the sheet must end, mm.
    double end() const { return end_; }
    /// The lowest part of the first sheet, from `y` down.
    void setFoot(double y, std::function<void()> paint);
    /// Called after a sheet is finished, to begin the next; returns where its print begins, mm.
    void setNextSheet(std::function<double()> next) { next_ = std::move(next); }
    double nextSheet();
    /// Paints the foot.
    void finishSheet();

    /// Paints at y (mm); returns the end.
    using Section = std::function<double(double y)>;
    double heightOf(const Section& section);
    /// The section at y, or on the next sheet where it has no room there.
    /// @return where it ends
    double place(double y, const Section& section);
    /// A paragraph as wide as the sheet, which continues on the next sheet.
    /// @return where it ends
    double flow(double y, const QString& text, double points, const QColor& colour = ink);

    /// While measuring, nothing is painted.
    void setMeasuring(bool measuring) { measuring_ = measuring; }
    bool isMeasuring() const { return measuring_; }

  private:
    static std::vector<QString> wrappedRows(const QString& text, const QFont& face, double width);

    QPainter& painter_;
    QRectF page_;
    double unit_;
    bool measuring_ = false;
    int number_ = 1;
    double end_ = bottom;
    std::function<void()> foot_;
    std::function<double()> next_;
};

/// A table of text on the card: columns with widths and alignment, rows of equal height, which grow
/// where a text does not fit its cell in one line.
class CardTable {
  public:
    struct Column {
        double width;  ///< mm
        Qt::Alignment align = Qt::AlignRight;
    };
    enum class Bold { None, Last, All };

    /// @param bold  the last row is shaded, too
    CardTable(std::vector<Column> columns, double points, double rowHeight, Bold bold)
        : columns_(std::move(columns)), points_(points), rowHeight_(rowHeight), bold_(bold) {}

    /// @return the height, mm; nothing is drawn without rows
    double draw(CardPage& page, const Results& results, double x, double y) const;
    double tableWidth() const;  ///< mm

  private:
    double heightOf(const CardPage& page, const QStringList& texts, bool bold) const;
    void drawCells(CardPage& page, double x, double y, const QStringList& texts, bool bold,
                   bool caption) const;

    static constexpr double inset = 0.6;  ///< of a text in its cell, mm
    /// Type of wrapped text, points: text too wide for a line even in this type.
    double wrappedType() const { return std::max(CardPage::smallestType, points_ - 2.0); }

    std::vector<Column> columns_;
    double points_;
    double rowHeight_;
    Bold bold_;
};

}  // namespace ravnoves
