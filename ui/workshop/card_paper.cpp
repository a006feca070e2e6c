// The job card on its paper: sheets, printer, PDF.

#include <QBuffer>
#include <QCoreApplication>
#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <QSettings>
#include <algorithm>

#include "numerics/units.h"
#include "shop/card_page.h"
#include "text/usual_paper.h"
#include "text/write_file.h"
#include "workshop/workshop_card.h"

namespace ravnoves {

namespace {

const QString paperKey = QStringLiteral("workshop/paper");  ///< upright, in points

/// The paper of the last card.
QPageSize paper() {
    const QPageSize kept(QSettings().value(paperKey).toSize());
    return kept.isValid() ? kept : QPageSize(usualPaper());
}

/// Above the card's title, where the margin is.
void drawShop(CardPage& page, const Shop& shop) {
    constexpr double top = 4.0;
    constexpr double height = 6.4;
    double x = CardPage::left;
    const QImage logo = Shop::read(shop.logo);
    if (!logo.isNull()) {
        const double width = std::min(60.0, height * logo.width() / logo.height());
        const double scaled = width * logo.height() / logo.width();
        page.painter().drawImage(page.rect(x, top + (height - scaled) / 2.0, width, scaled), logo);
        x += width + 3.0;
    }
    page.text(x, top + 1.2, CardPage::right - x, shop.name, 9, Qt::AlignLeft, true);
}

}  // namespace

QString WorkshopCard::otherRejectedText() const {
    QStringList others = rejected_;
    others.removeIf([this](const QString& each) { return rejectedOfResult_.contains(each); });
    return others.isEmpty()
               ? QString()
               : words_.translate("JobCard", "Not accepted, the previous value is used: %1")
                     .arg(others.join(QLatin1Char(' ')));
}

double WorkshopCard::continueOn(CardPage& page) const {
    constexpr double points = 9.0;
    const double end = CardPage::top + page.paragraph(CardPage::left, CardPage::top, CardPage::full,
                                                      title(), points, true);
    page.line(CardPage::left, end + 0.8, CardPage::right, end + 0.8, 0.5, CardPage::ink);
    return end + 3.0;
}

void WorkshopCard::paint(QPainter& painter, const QRectF& page,
                         const std::function<bool()>& next) const {
    painter.save();
    CardPage counted(painter, page);
    counted.setMeasuring(true);
    counted.setNextSheet([&] { return continueOn(counted); });
    draw(counted);
    CardPage sheet(painter, page);
    const auto begin = [&] {
        if (sheet.isMeasuring()) {
            return;
        }
        painter.fillRect(page, Qt::white);
        drawShop(sheet, shop_);
        if (counted.number() > 1) {
            constexpr double below = 292.5;  // the line of the method
            sheet.text(CardPage::left, below, CardPage::full,
                       words_.translate("JobCard", "Page %1 of %2")
                           .arg(sheet.number())
                           .arg(counted.number()),
                       8, Qt::AlignRight, true);
        }
    };
    sheet.setNextSheet([&] {
        sheet.setMeasuring(!next || !next());
        begin();
        return continueOn(sheet);
    });
    begin();
    draw(sheet);
    painter.restore();
}

void WorkshopCard::setPage(QPagedPaintDevice& device) {
    QPageLayout layout(paper(), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0),
                       QPageLayout::Millimeter);
    layout.setMode(QPageLayout::FullPageMode);
    device.setPageLayout(layout);
}

void WorkshopCard::keepPaper(const QPagedPaintDevice& device) {
    const QPageSize chosen = device.pageLayout().pageSize();
    if (chosen.isValid() && chosen != paper()) {  // the usual one may change with the country
        QSettings().setValue(paperKey, chosen.sizePoints());
    }
}

bool WorkshopCard::print(QPagedPaintDevice& device) const {
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
    bool isWhole = true;
    paint(painter, {card.topLeft() * perMillimetre, card.size() * perMillimetre}, [&] {
        isWhole = isWhole && device.newPage();
        return isWhole;
    });
    return painter.end() && isWhole;
}

QString WorkshopCard::writePdf(const QString& path) const {
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
