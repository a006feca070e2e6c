#pragma once

#include <QTextDocument>
#include <QTextObjectInterface>
#include <algorithm>

#include "paper/paper.h"
#include "theme/theme.h"

namespace ravnoves {

/// Places and draws the pictures of a document, none wider than a page.
class PaperPictures : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

  public:
    PaperPictures(const std::vector<paper::Drawing>& drawings, double width)
        : drawings_(drawings), width_(width) {}

    QSizeF intrinsicSize(QTextDocument* /*document*/, int /*position*/,
                         const QTextFormat& format) override {
        const paper::Drawing* drawing = of(format);
        return drawing == nullptr ? QSizeF(1.0, 1.0) : QSizeF(drawing->size) * scaleOf(*drawing);
    }
    void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* /*document*/,
                    int /*position*/, const QTextFormat& format) override {
        // Next to a page break the figure of the other page is asked for, too; it sets its own
        // clip.
        const paper::Drawing* drawing = of(format);
        if (drawing != nullptr && painter->clipBoundingRect().contains(rect.center())) {
            painter->save();
            painter->translate(rect.topLeft());
            painter->scale(scaleOf(*drawing), scaleOf(*drawing));
            painter->setClipRect(QRectF(QPointF(), QSizeF(drawing->size)), Qt::IntersectClip);
            painter->setFont(Theme::font());
            drawing->draw(*painter);
            painter->restore();
        }
    }

  private:
    const paper::Drawing* of(const QTextFormat& format) const {
        bool isNumber = false;
        const std::size_t number = format.toImageFormat().name().toULong(&isNumber);
        return isNumber && number < drawings_.size() ? &drawings_[number] : nullptr;
    }
    double scaleOf(const paper::Drawing& drawing) const {
        return std::min(1.0, width_ / drawing.size.width());
    }

    const std::vector<paper::Drawing>& drawings_;
    double width_;
};

}  // namespace ravnoves
