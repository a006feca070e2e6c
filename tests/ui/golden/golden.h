#pragma once

#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSet>
#include <QString>

namespace ravnoves::test {

/// Pictures as they were, at half their size and with sixteen steps of each colour; what one has
/// in common with the picture that it goes by is transparent there. So they stay small in the
/// repository.
class Golden {
  public:
    /// Of a channel, 0…255. The steps take 8 of it, the rest is for other processors' rounding.
    static constexpr int tolerance = 20;
    /// Of the pixels of a picture: 12 of 640×400.
    static constexpr double allowedShare = 5e-5;

    struct Comparison {
        int differing = 0;  ///< pixels
        int allowed = 0;
        QRect where;
        QImage difference;  ///< what differs is red over the grey picture
        bool isSame() const { return differing <= allowed; }
    };

    /// @param stored  folder of the pictures
    /// @param found   folder for what differs from them
    Golden(const QDir& stored, const QDir& found) : stored_(stored), found_(found) {}

    static QImage half(const QImage& picture) {
        return picture.scaled(picture.size() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
            .convertToFormat(QImage::Format_RGB32);
    }
    static QImage stepped(QImage picture) {
        const auto step = [](int channel) { return (channel + 8) / 17 * 17; };
        for (int y = 0; y < picture.height(); ++y) {
            auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
            for (int x = 0; x < picture.width(); ++x) {
                line[x] = qRgb(step(qRed(line[x])), step(qGreen(line[x])), step(qBlue(line[x])));
            }
        }
        return picture;
    }

    static Comparison compare(const QImage& stored, const QImage& actual) {
        Comparison found;
        found.allowed = static_cast<int>(allowedShare * actual.width() * actual.height());
        if (stored.size() != actual.size()) {
            found.differing = actual.width() * actual.height();
            found.where = actual.rect();
            found.difference = actual;
            return found;
        }
        for (int y = 0; y < actual.height(); ++y) {
            const auto* a = reinterpret_cast<const QRgb*>(actual.constScanLine(y));
            const auto* b = reinterpret_cast<const QRgb*>(stored.constScanLine(y));
            for (int x = 0; x < actual.width(); ++x) {
                if (a[x] != b[x] && (std::abs(qRed(a[x]) - qRed(b[x])) > tolerance ||
                                     std::abs(qGreen(a[x]) - qGreen(b[x])) > tolerance ||
                                     std::abs(qBlue(a[x]) - qBlue(b[x])) > tolerance)) {
                    if (found.differing++ == 0) {
                        found.difference = actual.convertToFormat(QImage::Format_Grayscale8)
                                               .convertToFormat(QImage::Format_RGB32);
                    }
                    found.where |= QRect(x, y, 1, 1);
                    found.difference.setPixelColor(x, y, Qt::red);
                }
            }
        }
        return found;
    }

    /// @return empty where the picture is as it was, else what differs and where to look at it
    QString check(const QString& name, const QImage& picture) const {
        const QString path = stored_.filePath(name + QStringLiteral(".png"));
        const QImage before = read(name);
        const QImage actual = half(picture);
        Comparison compared;
        if (!before.isNull()) {
            compared = compare(before, actual);
            if (compared.isSame()) {
                return {};
            }
        }
        const QString now = found_.absoluteFilePath(name + QStringLiteral(".actual.png"));
        const QString difference =
            found_.absoluteFilePath(name + QStringLiteral(".difference.png"));
        QDir().mkpath(found_.absolutePath());
        if (!actual.save(now)) {
            return now + QStringLiteral(": cannot be written");
        }
        if (before.isNull()) {
            return QStringLiteral("%1: no picture is stored; it looks like %2 now").arg(path, now);
        }
        compared.difference.save(difference);
        const QRect& at = compared.where;
        return QStringLiteral(
                   "%1: %2 pixels differ, %3 may, from (%4, %5) to (%6, %7); see\n  "
                   "%8\n  %9")
            .arg(path)
            .arg(compared.differing)
            .arg(compared.allowed)
            .arg(at.left())
            .arg(at.top())
            .arg(at.right())
            .arg(at.bottom())
            .arg(now, difference);
    }

    /// Stores a picture unless it is as it was. @return false where it cannot be written
    bool store(const QString& name, const QImage& picture) const {
        const QImage before = read(name);
        const QImage actual = half(picture);
        if (!before.isNull() && compare(before, actual).isSame()) {
            return true;
        }
        constexpr int smallest = 0;  // "quality" of a PNG
        return QDir().mkpath(stored_.absolutePath()) &&
               indexed(withoutGround(stepped(actual)))
                   .save(stored_.filePath(name + QStringLiteral(".png")), "PNG", smallest);
    }

    /// The pictures that follow go by this stored one; an empty name: by none.
    void goBy(const QString& name) {
        ground_ = QImage();
        ground_ = name.isEmpty() ? QImage() : read(name);
    }

    const QDir& stored() const { return stored_; }

  private:
    static constexpr QRgb clear = 0;

    /// Null where there is none.
    QImage read(const QString& name) const {
        QImage picture(stored_.filePath(name + QStringLiteral(".png")));
        picture.convertTo(QImage::Format_ARGB32);
        if (picture.size() == ground_.size()) {
            QPainter painter(&picture);
            painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);
            painter.drawImage(0, 0, ground_);
        }
        picture.convertTo(QImage::Format_RGB32);
        return picture;
    }
    QImage withoutGround(QImage picture) const {
        picture.convertTo(QImage::Format_ARGB32);
        if (picture.size() == ground_.size()) {
            for (int y = 0; y < picture.height(); ++y) {
                auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
                const auto* ground = reinterpret_cast<const QRgb*>(ground_.constScanLine(y));
                for (int x = 0; x < picture.width(); ++x) {
                    line[x] = line[x] == ground[x] ? clear : line[x];
                }
            }
        }
        return picture;
    }
    /// With a table of its colours where they are few enough.
    static QImage indexed(const QImage& picture) {
        QSet<QRgb> colours;
        for (int y = 0; y < picture.height(); ++y) {
            const auto* line = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
            colours += QSet(line, line + picture.width());
        }
        return colours.size() > 256
                   ? picture
                   : picture.convertToFormat(QImage::Format_Indexed8, colours.values());
    }

    QDir stored_;
    QDir found_;
    QImage ground_;
};

}  // namespace ravnoves::test
