#include "workshop/job_card.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <QSettings>
#include <algorithm>

#include "numerics/units.h"
#include "text/write_file.h"
#include "workshop/card_page.h"

namespace ravnoves {

namespace {

const QString shopName = QStringLiteral("workshop/shop-name");
const QString shopLogo = QStringLiteral("workshop/shop-logo");

/// Above the card's title, where the margin is.
void drawShop(CardPage& page, const Shop& shop) {
    constexpr double top = 4.0;
    constexpr double height = 6.4;
    double x = CardPage::left;
    const QImage logo = shop.logo.isEmpty() ? QImage() : QImage(shop.logo);
    if (!logo.isNull()) {
        const double width = std::min(60.0, height * logo.width() / logo.height());
        const double scaled = width * logo.height() / logo.width();
        page.painter().drawImage(page.rect(x, top + (height - scaled) / 2.0, width, scaled), logo);
        x += width + 3.0;
    }
    page.text(x, top + 1.2, CardPage::right - x, shop.name, 9, Qt::AlignLeft, true);
}

}  // namespace

Shop Shop::kept() {
    const QSettings settings;
    return {settings.value(shopName).toString(), settings.value(shopLogo).toString()};
}

void Shop::keep() const {
    QSettings settings;
    settings.setValue(shopName, name);
    settings.setValue(shopLogo, logo);
}

void JobCard::paint(QPainter& painter, const QRectF& page) const {
    painter.save();
    painter.fillRect(page, Qt::white);
    CardPage sheet(painter, page);
    drawShop(sheet, shop_);
    draw(sheet);
    // Those that the answer depends on stand beside it.
    QStringList others = refused_;
    others.removeIf([this](const QString& each) { return refusedOfResult_.contains(each); });
    constexpr double bottom = 292.5;  // below the line of the method
    sheet.text(CardPage::left, bottom, CardPage::full, refusedNote(words_, others), 8,
               Qt::AlignLeft, true, CardPage::amber);
    painter.restore();
}

void JobCard::setPage(QPagedPaintDevice& device) {
    QPageLayout layout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0),
                       QPageLayout::Millimeter);
    layout.setMode(QPageLayout::FullPageMode);
    device.setPageLayout(layout);
}

bool JobCard::print(QPagedPaintDevice& device) const {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    // The paper in device pixels. A printer that keeps margins of its own and was not set to the
    // full page begins inside it.
    const double perMillimetre = device.logicalDpiX() / (units::inch.to_si / units::mm);
    const QPageLayout layout = device.pageLayout();
    const QRectF paper = layout.fullRect(QPageLayout::Millimeter);
    const QMarginsF margins = layout.mode() == QPageLayout::FullPageMode
                                  ? QMarginsF()
                                  : layout.margins(QPageLayout::Millimeter);
    // Letter is shorter than A4, a sheet on its side much more: the card shrinks to it, in the
    // middle. Its own margins are what a printer needs.
    const double scale =
        std::min({1.0, paper.width() / CardPage::width, paper.height() / CardPage::height});
    const QRectF card((paper.width() - scale * CardPage::width) / 2.0 - margins.left(),
                      -margins.top(), scale * CardPage::width, scale * CardPage::height);
    paint(painter, {card.topLeft() * perMillimetre, card.size() * perMillimetre});
    return painter.end();
}

QString JobCard::writePdf(const QString& path) const {
    QBuffer whole;  // a file is only begun with a card that is painted
    whole.open(QIODevice::WriteOnly);
    bool painted = false;
    {
        QPdfWriter writer(&whole);
        writer.setResolution(1200);
        writer.setCreator(QStringLiteral("Ravnoves " RAVNOVES_VERSION));
        writer.setTitle(title());
        setPage(writer);
        painted = print(writer);
    }
    return painted ? writeFile(path, [&] { return whole.data().toStdString(); })
                   : QCoreApplication::translate("ravnoves::PictureFile", "%1 cannot be written.")
                         .arg(path);
}

}  // namespace ravnoves
