#include "pictures/picture_file.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QMainWindow>
#include <QPageSize>
#include <QPaintEngine>
#include <QPainter>
#include <QPdfWriter>
#include <QStatusBar>
#include <QWidget>
#include <cmath>

#include "numerics/units.h"
#include "pictures/clipped_svg.h"
#include "text/write_file.h"
#include "theme/theme.h"

namespace ravnoves {

/// Its words.
struct PictureFile {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::PictureFile)
};

namespace {

constexpr double screenDots = 96.0;  ///< to the inch
constexpr double printDots = 300.0;

bool endsIn(const QString& path, const char* suffix) {
    return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
}

bool drawOn(QPaintDevice& device, const DrawPicture& draw) {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    painter.setRenderHint(QPainter::LosslessImageRendering);  // no JPEG within a PDF
    draw(painter, 1.0);
    return painter.end();
}

bool drawPdf(QIODevice& out, const QSize& size, const QString& title, const DrawPicture& draw) {
    QPdfWriter writer(&out);
    writer.setResolution(static_cast<int>(screenDots));
    writer.setPageSize(
        QPageSize(QSizeF(size) * (72.0 / screenDots), QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    writer.setTitle(title);
    return drawOn(writer, draw);
}

bool drawPng(QIODevice& out, const QSize& size, const DrawPicture& draw) {
    constexpr double scale = printDots / screenDots;
    QImage image(size * scale, QImage::Format_RGB32);
    const int dotsPerMetre = static_cast<int>(std::lround(scale * screenDots / units::inch.to_si));
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    image.fill(Theme::instance().window());
    QPainter painter(&image);
    draw(painter, scale);
    painter.end();
    return image.save(&out, "PNG");
}

}  // namespace

QString writePicture(const QString& path, const QSize& size, const QString& title,
                     const DrawPicture& draw) {
    QBuffer whole;  // a file is only begun with a picture that is drawn
    whole.open(QIODevice::WriteOnly);
    bool isDrawn = false;
    if (endsIn(path, ".svg")) {
        ClippedSvg device(whole, size, title);
        isDrawn = drawOn(device, draw);
    } else if (endsIn(path, ".pdf")) {
        isDrawn = drawPdf(whole, size, title, draw);
    } else if (endsIn(path, ".png")) {
        isDrawn = drawPng(whole, size, draw);
    } else {
        return PictureFile::tr("%1: a picture is written as .png, .svg or .pdf.").arg(path);
    }
    return isDrawn ? writeFile(path, [&] { return whole.data().toStdString(); })
                   : PictureFile::tr("%1 cannot be written.").arg(path);
}

void savePictureWithDialog(QWidget* parent, const QString& title, const QString& name,
                           const QList<FileFormat>& others,
                           const std::function<QString(const QString&)>& write) {
    const QString path = saveFile(parent, title, name, pictureFormats() + others, write);
    if (path.isEmpty()) {
        return;
    }
    for (QWidget* each = parent; each != nullptr; each = each->parentWidget()) {
        if (auto* window = qobject_cast<QMainWindow*>(each)) {
            constexpr int readFor = 5000;  // ms
            window->statusBar()->showMessage(
                PictureFile::tr("Written: %1").arg(QFileInfo(path).fileName()), readFor);
            break;
        }
    }
}

bool takesLines(const QPainter& painter) {
    const QPaintEngine::Type type = painter.paintEngine()->type();
    return type == QPaintEngine::Pdf || type == QPaintEngine::SVG || type == QPaintEngine::Picture;
}

bool drawsForFile(const QPainter& painter, const QWidget& widget) {
    return takesLines(painter) ||
           painter.deviceTransform().m11() > 1.01 * widget.devicePixelRatioF();
}

}  // namespace ravnoves
