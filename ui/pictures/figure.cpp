#include "pictures/figure.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QPageSize>
#include <QPaintEngine>
#include <QPainter>
#include <QPdfWriter>
#include <QPicture>
#include <QStatusBar>
#include <QWidget>
#include <cmath>

#include "numerics/units.h"
#include "pictures/clipped_svg.h"
#include "text/csv_format.h"
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

bool isNamed(const QString& path, const char* suffix) {
    return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
}

/// A device that takes lines and text rather than pixels.
bool takesLines(const QPainter& painter) {
    const QPaintEngine::Type type = painter.paintEngine()->type();
    return type == QPaintEngine::Pdf || type == QPaintEngine::SVG || type == QPaintEngine::Picture;
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
    if (isNamed(path, ".svg")) {
        ClippedSvg device(whole, size, title);
        isDrawn = drawOn(device, draw);
    } else if (isNamed(path, ".pdf")) {
        isDrawn = drawPdf(whole, size, title, draw);
    } else if (isNamed(path, ".png")) {
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

bool drawsForFile(const QPainter& painter, const QWidget& widget) {
    return takesLines(painter) ||
           painter.deviceTransform().m11() > 1.01 * widget.devicePixelRatioF();
}

FigureMenu::FigureMenu(QWidget* figure, QString file, Draw draw)
    : QObject(figure), figure_(figure), file_(std::move(file)), draw_(std::move(draw)) {
    figure->installEventFilter(this);
}

bool FigureMenu::isEmpty() const {
    return data_ && data_(CsvFormat()).isEmpty();
}

QString FigureMenu::write(const QString& path, const QString& title) const {
    if (data_ && path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        return writeFile(path, [this] { return CsvFormat::file(data_(CsvFormat())); });
    }
    const auto draw = [this](QPainter& painter, double scale) {
        draw_(painter, QRectF(QPointF(), QSizeF(figure_->size()) * scale));
    };
    return writePicture(path, figure_->size(), title, draw);
}

void FigureMenu::copyPicture() const {
    QImage image(figure_->size() * 2, QImage::Format_RGB32);
    image.fill(Theme::instance().panel());
    QPainter painter(&image);
    draw_(painter, QRectF(QPointF(), QSizeF(image.size())));
    painter.end();
    QApplication::clipboard()->setImage(image);
}

void FigureMenu::open(const QPoint& at) {
    QMenu menu(figure_);
    menu.addActions(figure_->actions());
    if (!menu.isEmpty()) {
        menu.addSeparator();
    }
    if (data_) {
        menu.addAction(tr("Copy data"), this, [this] {
            CsvFormat cells;
            cells.separator = QLatin1Char('\t');
            QApplication::clipboard()->setText(data_(cells));
        });
    }
    menu.addAction(tr("Copy picture"), this, &FigureMenu::copyPicture);
    menu.addAction(data_ ? tr("Save picture or data…") : tr("Save picture…"), this, [this] {
        savePictureWithDialog(
            figure_, data_ ? tr("Save picture or data") : tr("Save picture"),
            file_ + QStringLiteral(".png"), data_ ? QList{csvFormat()} : QList<FileFormat>(),
            [this](const QString& path) { return write(path, figure_->accessibleName()); });
    });
    menu.exec(at);
}

bool FigureMenu::eventFilter(QObject* watched, QEvent* event) {
    const auto middle = [this] { return figure_->mapToGlobal(figure_->rect().center()); };
    switch (event->type()) {
        case QEvent::ContextMenu: {
            const auto* asked = static_cast<const QContextMenuEvent*>(event);
            open(asked->reason() == QContextMenuEvent::Keyboard ? middle() : asked->globalPos());
            return true;
        }
        case QEvent::KeyPress: {
            const auto* key = static_cast<const QKeyEvent*>(event);
            if (key->key() == Qt::Key_F10 && key->modifiers() == Qt::ShiftModifier) {
                open(middle());
                return true;
            }
            return false;
        }
        case QEvent::Paint:
            if (figure_->hasFocus()) {
                watched->event(event);
                QPainter painter(figure_);
                if (!drawsForFile(painter, *figure_)) {
                    painter.setPen(QPen(Theme::instance().accent(), 1.0));
                    painter.drawRect(QRectF(figure_->rect()).adjusted(0.5, 0.5, -0.5, -0.5));
                }
                return true;
            }
            return false;
        default:
            return false;
    }
}

void makeFigure(QWidget* widget, FigureMenu::Data data) {
    auto* menu = widget->findChild<FigureMenu*>({}, Qt::FindDirectChildrenOnly);
    if (menu == nullptr) {
        menu = new FigureMenu(widget, QStringLiteral("picture"),
                              [widget](QPainter& painter, const QRectF& target) {
                                  drawFigure(widget, painter, target);
                              });
        widget->setProperty("isFigure", true);
        if (widget->focusPolicy() == Qt::NoFocus) {
            widget->setFocusPolicy(Qt::TabFocus);
        }
    }
    if (data) {
        menu->setData(std::move(data));
    }
}

bool isFigure(const QWidget* widget) {
    return widget->property("isFigure").toBool();
}

bool isEmptyFigure(const QWidget* widget) {
    const auto* menu = widget->findChild<FigureMenu*>({}, Qt::FindDirectChildrenOnly);
    return menu != nullptr && menu->isEmpty();
}

void drawFigure(QWidget* figure, QPainter& painter, const QRectF& target) {
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / figure->width(), target.height() / figure->height());
    if (takesLines(painter)) {
        // Rendered straight, a widget mixes up the clipping of the device.
        QPicture lines;
        figure->render(&lines, QPoint(), QRegion(), QWidget::RenderFlags());
        painter.drawPicture(0, 0, lines);
    } else {
        figure->render(&painter, QPoint(), QRegion(), QWidget::RenderFlags());
    }
    painter.restore();
}

}  // namespace ravnoves
