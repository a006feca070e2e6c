#pragma once

#include <QRectF>
#include <QString>

#include "v8-plugs/input.h"
#include "v8-plugs/model/words.h"
#include "v8-plugs/solver.h"

class QPagedPaintDevice;
class QPainter;

namespace ravnoves {

/// The job card: one A4 page with the head of the job, the inputs, the answer, the plug, the bob
/// weights line by line, the machine's limits and room for its readings and for signatures.
class JobCard {
  public:
    JobCard(v8_plugs::Input input, Words words);

    /// Paints the page. `page` is the whole sheet, 210 × 297 mm, in the painter's units; one
    /// millimetre is page.width() / 210 of them.
    void paint(QPainter& painter, const QRectF& page) const;
    /// Paints onto a printer or PDF writer; its page must be A4 upright (setPage()).
    /// @return false where the device cannot be painted on
    bool print(QPagedPaintDevice& device) const;
    /// Sets A4 upright without margins of the device's own.
    static void setPage(QPagedPaintDevice& device);

    /// Writes a PDF with selectable text; a file already there stays whole when anything fails.
    /// @return an empty string, or what went wrong
    QString writePdf(const QString& path) const;

    const Words& words() const { return words_; }

  private:
    v8_plugs::Input input_;
    v8_plugs::Result solution_;
    Words words_;
};

}  // namespace ravnoves
