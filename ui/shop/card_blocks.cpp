#include "shop/card_blocks.h"

#include "shop/model/job_desk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ravnoves {

namespace {

constexpr double left = CardPage::left;
constexpr double full = CardPage::full;
constexpr double right = CardPage::right;
constexpr double headingHeight = 5.2;

/// More than a line is set smaller.
double notesPoints(const CardPage& page, const QString& notes) {
    return page.textWidth(notes, 8.5) <= full ? 8.5 : 7.2;
}

}  // namespace

double cardHead(CardPage& page, const Words& words, const CardHead& head, double y) {
    page.text(left, y, full * 0.7, head.title, 14, Qt::AlignLeft, true);
    const double x = left + full * 0.7;
    double end = y + 7.5;
    if (page.textWidth(head.engine, CardPage::smallestType, true) <= right - x) {
        page.text(x, y + 1.2, right - x, head.engine, 10, Qt::AlignRight, true);
    } else {
        end = std::max(
            end, y + page.paragraph(x, y, right - x, head.engine, CardPage::smallestType, true));
    }
    y = end;
    page.line(left, y, right, y, 0.5, CardPage::ink);
    y += 1.5;
    const double third = full / 3.0;
    const JournalJob job = JobDesk::entryOf(head.job);
    const auto row = [&](const std::array<std::pair<QString, QString>, 3>& blanks) {
        double height = 0.0;
        for (std::size_t i = 0; i < blanks.size(); ++i) {
            const auto& [caption, value] = blanks.at(i);
            height = std::max(height, page.blank(left + static_cast<double>(i) * third, y,
                                                 i == 2 ? third + 3 : third, caption, value));
        }
        y += height + 1.3;
    };
    row({{{words.translate("JobCard", "Engine number"), job.engineNumber},
          {words.translate("JobCard", "Crankshaft number"), job.crankshaftNumber},
          {words.translate("JobCard", "Date"), words.day(QString::fromStdString(head.job.date))}}});
    row({{{words.translate("JobCard", "Customer"), job.customer},
          {words.translate("JobCard", "Technician"), job.technician},
          {head.lastCaption, head.last}}});
    return y - 1.0;
}

double cardNotesHeight(const CardPage& page, const QString& notes) {
    const double points = notesPoints(page, notes);
    return headingHeight + 2.6 +
           std::max(page.heightOf(notes, points, full), page.lineHeight(points));
}

double cardNotes(CardPage& page, const Words& words, const QString& notes, double y) {
    constexpr double lineStep = 6.5;
    constexpr double leastToWrite = 9.0;
    const double points = notesPoints(page, notes);
    if (notes.isEmpty() && page.end() - y < leastToWrite) {
        return y;
    }
    // The heading is not left alone.
    if (y + headingHeight + page.lineHeight(points) > page.end()) {
        y = page.nextSheet();
    }
    page.heading(left, y, full, words.translate("JobCard", "Notes"));
    y = page.flow(y + headingHeight, notes, points);
    if (page.number() > 1) {
        return y;
    }
    const int ruled = static_cast<int>(std::max(0.0, std::ceil((page.end() - y) / lineStep) - 1.0));
    for (int line = 1; line <= ruled; ++line) {
        page.line(left, y + line * lineStep, right, y + line * lineStep);
    }
    return page.end();
}

void cardSignatures(CardPage& page, const Words& words, const QString& method, double y) {
    const double third = full / 3.0;
    const QStringList captions{words.translate("JobCard", "Technician, signature"),
                               words.translate("JobCard", "Inspector, signature"),
                               words.translate("JobCard", "Date")};
    for (int i = 0; i < 3; ++i) {
        const double x = left + i * third;
        page.line(x, y + 7.0, x + third - 6.0, y + 7.0, 0.2, CardPage::ink);
        page.text(x, y + 7.3, third - 6.0, captions.at(i), 7, Qt::AlignLeft, false, CardPage::grey);
    }
    page.text(left, y + 13.0, full, method, 6.5, Qt::AlignLeft, false, CardPage::grey);
}

}  // namespace ravnoves
