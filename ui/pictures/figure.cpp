#include "pictures/figure.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPicture>

#include "pictures/picture_file.h"
#include "text/csv_format.h"
#include "text/write_file.h"
#include "theme/theme.h"

namespace ravnoves {

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
            if (isFramed_ && figure_->hasFocus()) {
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
            menu->setFramed();
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
