#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QStringList>
#include <vector>

namespace ravnoves {

/// A sheet of paper in millimetres from its upper left corner, with type in points: what the job
/// card is drawn on.
class CardPage {
  public:
    static constexpr double width = 210.0;   ///< A4, mm
    static constexpr double height = 297.0;  ///< mm

    static constexpr double left = 16.0;  ///< where the print begins, with room to file it, mm
    static constexpr double right = width - 12.0;
    static constexpr double top = 11.0;
    static constexpr double full = right - left;

    static const QColor ink;
    static const QColor grey;   ///< captions
    static const QColor hair;   ///< thin lines
    static const QColor shade;  ///< behind what matters
    static const QColor amber;  ///< what does not count

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
    /// One line; a text that is too wide is set smaller, as far as it can be read, then elided.
    void text(double x, double y, double w, const QString& text, double points = 8.5,
              Qt::Alignment align = Qt::AlignLeft, bool bold = false, const QColor& colour = ink);
    static constexpr double smallestType = 6.0;  ///< points; less is not read in a workshop
    /// Height of wrapped text with all its lines, mm.
    double heightOf(const QString& text, double points, double w) const;
    /// Wrapped text of at most `lines` lines; the last is elided where there is more.
    /// @return its height, mm
    double paragraph(double x, double y, double w, const QString& text, double points, int lines,
                     bool bold = false, const QColor& colour = ink);
    void heading(double x, double y, double w, const QString& title);
    /// A value with its small caption above and a line below to write on.
    void blank(double x, double y, double w, const QString& caption, const QString& value);

    /// While measuring, paragraphs say their height and paint nothing.
    void setMeasuring(bool measuring) { measuring_ = measuring; }

  private:
    std::vector<QString> wrappedRows(const QString& text, const QFont& face, double w,
                                     int lines) const;

    QPainter& painter_;
    QRectF page_;
    double unit_;
    bool measuring_ = false;
};

/// A table of text on the card: columns with widths and alignment, rows of equal height.
class CardTable {
  public:
    struct Column {
        double width;  ///< mm
        Qt::Alignment align = Qt::AlignRight;
    };
    struct Row {
        QStringList cells;
        bool bold = false;
        bool shaded = false;
    };

    CardTable(std::vector<Column> columns, double points, double rowHeight)
        : columns_(std::move(columns)), points_(points), rowHeight_(rowHeight) {}

    void head(const QStringList& cells) { head_ = cells; }
    void add(Row row) { rows_.push_back(std::move(row)); }

    /// @return the height, mm
    double draw(CardPage& page, double x, double y) const;
    double tableWidth() const;  ///< mm

  private:
    void drawCells(CardPage& page, double x, double y, const QStringList& texts, bool bold,
                   bool caption) const;

    std::vector<Column> columns_;
    double points_;
    double rowHeight_;
    QStringList head_;
    std::vector<Row> rows_;
};

}  // namespace ravnoves
