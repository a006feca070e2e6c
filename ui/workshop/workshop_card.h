#pragma once

#include <QRectF>
#include <functional>

#include "shop/model/verdict.h"
#include "shop/shop.h"
#include "workshop/model/workshop_model.h"

class QPagedPaintDevice;
class QPainter;

namespace ravnoves {

class CardPage;

/// The job card: one sheet of paper, or more where there is more to say, painted in millimetres of
/// A4. The first page is what one takes to the machine: bob weight and verdict in large type, the
/// planes as clocks with their holes, lines for the machine's readings. Parts, plugs and take-offs
/// follow.
class WorkshopCard {
  public:
    /// Of the model in its present state when it is painted: the card says what the page says.
    WorkshopCard(const WorkshopModel& model, Words words)
        : model_(model), words_(std::move(words)) {}

    /// Paints the card. `page` is the whole of A4, 210 × 297 mm, in the painter's units; one
    /// millimetre is page.width() / 210 of them.
    /// @param next  begins another sheet at the same place, false without one; if empty, only the
    ///              first sheet is painted
    void paint(QPainter& painter, const QRectF& page, const std::function<bool()>& next = {}) const;
    /// Paints onto a printer or PDF writer, as large as its paper allows where that is not A4
    /// upright.
    /// @return false where the device cannot be painted on
    bool print(QPagedPaintDevice& device) const;
    /// Sets the paper that a card was printed on last, else the usual one of the desktop's country,
    /// upright without margins of the device's own.
    static void setPage(QPagedPaintDevice& device);
    /// Keeps the paper of a device, which the user may have changed in a dialog, for the next card.
    static void keepPaper(const QPagedPaintDevice& device);

    /// Writes a PDF with selectable text; a file already there stays whole when anything fails.
    /// @return an empty string, or what went wrong
    QString writePdf(const QString& path) const;

    void setShop(const Shop& shop) { shop_ = shop; }
    /// Entries that the form rejects: the card uses the values before them, and notes it.
    /// @param ofResult  the ones that the answer depends on
    void setRejected(const QStringList& rejected, const QStringList& ofResult) {
        rejected_ = rejected;
        rejectedOfResult_ = ofResult;
    }

  private:
    void draw(CardPage& page) const;
    QString title() const;
    /// @return where the continued text begins, mm
    double continueOn(CardPage& page) const;
    /// Empty where nothing is rejected that the answer depends on.
    QString rejectedText() const { return rejectedNote(words_, rejectedOfResult_); }
    /// The same of all other entries.
    QString otherRejectedText() const;
    // What returns a number returns where the block ends, mm.
    double head(CardPage& page, double y) const;
    double answer(CardPage& page, double y) const;
    double clocks(CardPage& page, double y) const;
    double notes(CardPage& page, double y) const;
    void signatures(CardPage& page, double y) const;
    void drawPlugBeside(CardPage& page, double y) const;

    const WorkshopModel& model_;
    Words words_;
    Shop shop_;
    QStringList rejected_;
    QStringList rejectedOfResult_;
};

}  // namespace ravnoves
