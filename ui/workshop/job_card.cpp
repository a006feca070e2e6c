#include "workshop/job_card.h"

#include <QCoreApplication>
#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <algorithm>

#include "workshop/card_page.h"

namespace ravnoves {

void JobCard::paint(QPainter& painter, const QRectF& page) const {
    painter.save();
    painter.fillRect(page, Qt::white);
    CardPage sheet(painter, page);
    draw(sheet);
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
    const double perMillimetre = device.logicalDpiX() / 25.4;
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
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return QCoreApplication::translate("JobCard", "%1 cannot be written: %2")
            .arg(path, file.errorString());
    }
    bool painted = false;
    {
        QPdfWriter writer(&file);
        writer.setResolution(1200);
        writer.setCreator(QStringLiteral("Ravnoves " RAVNOVES_VERSION));
        writer.setTitle(title());
        setPage(writer);
        painted = print(writer);
    }
    if (!painted || !file.commit()) {
        return QCoreApplication::translate("JobCard", "%1 cannot be written: %2")
            .arg(path, file.errorString());
    }
    return {};
}

}  // namespace ravnoves
