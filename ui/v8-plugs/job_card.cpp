#include "v8-plugs/job_card.h"

#include <QCoreApplication>
#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>

#include "v8-plugs/card_painter.h"

namespace ravnoves {

using namespace v8_plugs;

JobCard::JobCard(Input input, Words words)
    : input_(std::move(input)), solution_(solve(input_)), words_(std::move(words)) {}

void JobCard::paint(QPainter& painter, const QRectF& page) const {
    painter.save();
    painter.fillRect(page, Qt::white);
    CardPage sheet(painter, page);
    CardPainter(sheet, input_, solution_, words_).paint();
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
    // The sheet in device pixels. A printer that keeps margins of its own and was not set to the
    // full page begins inside it.
    const double perMillimetre = device.logicalDpiX() / 25.4;
    const QPageLayout layout = device.pageLayout();
    const QMarginsF margins = layout.mode() == QPageLayout::FullPageMode
                                  ? QMarginsF()
                                  : layout.margins(QPageLayout::Millimeter);
    const QRectF page(-margins.left() * perMillimetre, -margins.top() * perMillimetre,
                      CardPage::width * perMillimetre, CardPage::height * perMillimetre);
    paint(painter, page);
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
        writer.setTitle(words_.translate("JobCard", "Job card: crankpin plugs and bob weights") +
                        QLatin1Char(' ') + QString::fromStdString(input_.job.engine_number));
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
