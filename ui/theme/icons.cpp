#include "theme/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>
#include <algorithm>
#include <vector>

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
        const QRgb colour = colourOf(mode, state).rgb();
        const auto known = std::find_if(drawn_.begin(), drawn_.end(), [&](const Drawn& each) {
            return each.colour == colour && each.picture.size() == size;
        });
        if (known != drawn_.end()) {
            return known->picture;
        }
        if (size.isEmpty()) {
            return {};  // a button that is not laid out yet
        }
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        painter.end();
        constexpr std::size_t maximum =
            4;  // a button's states; of a theme or a scale before no more
        if (drawn_.size() == maximum) {
            drawn_.erase(drawn_.begin());
        }
        drawn_.push_back({colour, pixmap});
        return pixmap;
    }

    QIconEngine* clone() const override { return new ThemedIconEngine(*this); }

  private:
    struct Drawn {
        QRgb colour;
        QPixmap picture;
    };

    static QColor colourOf(QIcon::Mode mode, QIcon::State state) {
        const Theme& theme = Theme::instance();
        return mode == QIcon::Disabled ? theme.border()
               : state == QIcon::On    ? theme.accent()
                                       : theme.text();
    }

    QByteArray svg_;
    std::vector<Drawn> drawn_;
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
    for (const RoleLook& look : roleLooks()) {
        set(look.word, theme.colour(look.role));
    }
    return svg;
}

}  // namespace ravnoves
