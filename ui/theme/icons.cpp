#include "theme/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "theme/theme.h"

namespace ravnoves {

namespace {

/// Draws the SVG with "currentColor" replaced by the theme's colour at paint time, so that a switch
/// between light and dark needs no new icons.
class ThemedIconEngine : public QIconEngine {
  public:
    explicit ThemedIconEngine(QByteArray svg) : svg_(std::move(svg)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode,
               QIcon::State state) override {
        QByteArray svg = svg_;
        svg.replace("currentColor", colourOf(mode, state).name().toLatin1());
        QSvgRenderer renderer(svg);
        painter->setRenderHint(QPainter::Antialiasing);
        renderer.render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QString key = QStringLiteral("icon %1 %2 %3 %4")
                                .arg(qHash(svg_))
                                .arg(colourOf(mode, state).rgb())
                                .arg(size.width())
                                .arg(size.height());
        QPixmap pixmap(size);
        if (!size.isEmpty() && !QPixmapCache::find(key, &pixmap)) {
            pixmap.fill(Qt::transparent);
            QPainter painter(&pixmap);
            paint(&painter, QRect(QPoint(), size), mode, state);
            painter.end();
            QPixmapCache::insert(key, pixmap);
        }
        return pixmap;
    }

    QIconEngine* clone() const override { return new ThemedIconEngine(*this); }

  private:
    static QColor colourOf(QIcon::Mode mode, QIcon::State state) {
        const Theme& theme = Theme::instance();
        return mode == QIcon::Disabled ? theme.border()
               : state == QIcon::On    ? theme.accent()
                                       : theme.text();
    }

    QByteArray svg_;
};

}  // namespace

QIcon themedIcon(const QString& name) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return QIcon(new ThemedIconEngine(file.readAll()));
}

QByteArray themedSvg(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QByteArray svg = file.readAll();
    const Theme& theme = Theme::instance();
    const auto set = [&svg](const QByteArray& name, const QColor& colour) {
        svg.replace("var(--" + name + ")", colour.name().toLatin1());
    };
    svg.replace("currentColor", theme.text().name().toLatin1());
    set("panel", theme.panel());
    set("grid", theme.grid());
    set("muted", theme.mutedText());
    set("accent", theme.accent());
    set("warning", theme.warning());
    set("good", theme.good());
    set("error", theme.error());
    for (const RoleLook& look : roleLooks()) {
        set(look.word, theme.colour(look.role));
    }
    return svg;
}

}  // namespace ravnoves
