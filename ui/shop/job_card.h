#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <functional>

#include "shop/model/verdict.h"
#include "shop/model/words.h"

class QPagedPaintDevice;
class QPainter;

namespace ravnoves {

class CardPage;

/// Whose card it is, set once.
struct Shop {
    QString name;
    QString logo;  ///< file of a picture

    static Shop kept();
    /// Of a file; null where that is none. A picture that never ends is not waited for.
    static QImage read(const QString& file);
    /// With a copy of the picture, which stays where its file goes.
    /// @return an empty string, or why it could not be copied
    QString keep() const;
    /// That the picture cannot be read; empty where it can, or there is none.
    QString trouble() const;
};

/// A job card: one sheet of paper, or more where there is more to say, painted in millimetres of A4
/// by the card of a scene.
class JobCard {
  public:
    explicit JobCard(Words words) : words_(std::move(words)) {}
    virtual ~JobCard() = default;
    JobCard(const JobCard&) = delete;
    JobCard& operator=(const JobCard&) = delete;

    /// Paints the card. `page` is the whole of A4, 210 × 297 mm, in the painter's units; one
    /// millimetre is page.width() / 210 of them.
    /// @param next  begins another sheet at the same place, false where there is none; without it
    ///              the first sheet alone is painted
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

    const Words& words() const { return words_; }
    void setShop(const Shop& shop) { shop_ = shop; }
    /// Entries that the form rejects: the card is of the values before them, and says so.
    /// @param ofResult  those of them that the answer depends on
    void setRefused(const QStringList& refused, const QStringList& ofResult) {
        refused_ = refused;
        refusedOfResult_ = ofResult;
    }
    void setRefused(const QStringList& refused) { setRefused(refused, refused); }

  protected:
    virtual void draw(CardPage& page) const = 0;
    /// Of the PDF.
    virtual QString title() const = 0;

    /// Empty where nothing is rejected that the answer depends on.
    QString refusedText() const { return refusedNote(words_, refusedOfResult_); }
    /// The same of all other entries.
    QString otherRefusedText() const;

  private:
    /// @return where what goes on begins, mm
    double goOn(CardPage& page) const;

    Words words_;
    Shop shop_;
    QStringList refused_;
    QStringList refusedOfResult_;
};

}  // namespace ravnoves
