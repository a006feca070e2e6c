#include "workshop/card_blocks.h"

#include "workshop/model/job_desk.h"

#include <algorithm>
#include <cmath>

namespace ravnoves {

namespace {

constexpr double left = CardPage::left;
constexpr double full = CardPage::full;
constexpr double right = CardPage::right;

/// More than a line is set smaller.
double notesPoints(const CardPage& page, const QString& notes) {
    return page.textWidth(notes, 8.5) <= full ? 8.5 : 7.2;
}

}  // namespace

double cardHead(CardPage& page, const Words& words, const CardHead& head, double y) {
    page.text(left, y, full * 0.7, head.title, 14, Qt::AlignLeft, true);
    page.text(left + full * 0.7, y + 1.2, full * 0.3, head.engine, 10, Qt::AlignRight, true);
    y += 7.5;
    page.line(left, y, right, y, 0.5, CardPage::ink);
    y += 1.5;
    const double third = full / 3.0;
    const JournalJob job = JobDesk::entryOf(head.job);
    page.blank(left, y, third, words.translate("JobCard", "Engine number"), job.engineNumber);
    page.blank(left + third, y, third, words.translate("JobCard", "Crankshaft number"),
               job.crankshaftNumber);
    page.blank(left + 2 * third, y, third + 3, words.translate("JobCard", "Date"),
               words.day(QString::fromStdString(head.job.date)));
    y += 9.5;
    page.blank(left, y, third, words.translate("JobCard", "Customer"), job.customer);
    page.blank(left + third, y, third, words.translate("JobCard", "Technician"), job.technician);
    page.blank(left + 2 * third, y, third + 3, head.lastCaption, head.last);
    return y + 8.5;
}

double cardAnswer(CardPage& page, const CardAnswer& answer, double y) {
    const bool doubtful = !answer.warning.isEmpty();
    const QColor& colour = doubtful ? CardPage::amber : CardPage::ink;
    const double inner = left + 3.0;
    const double room = full - 6.0;
    const auto content = [&](double from) {
        double at = from;
        at += page.paragraph(inner, at, room, answer.fact, 9, 1);
        at += page.paragraph(inner, at + 0.4, room, answer.action, 11.5, 4, true, colour) + 0.4;
        at += page.paragraph(inner, at + 0.4, room, answer.more, 9, 3, false, colour);
        return at + page.paragraph(inner, at + 0.4, room, answer.warning, 10, 7, true, colour);
    };
    page.setMeasuring(true);
    const double height = content(0.0) + 3.6;
    page.setMeasuring(false);
    page.box(left, y, full, height, CardPage::shade, colour, doubtful ? 0.8 : 0.3);
    content(y + 1.6);
    return y + height;
}

double cardNotesHeight(const CardPage& page, const QString& notes) {
    const double points = notesPoints(page, notes);
    const double lines = std::ceil(page.textWidth(notes, points) / full * 1.05);
    return 5.2 + 2.6 + std::clamp(lines, 1.0, 3.0) * page.lineHeight(points);
}

void cardNotes(CardPage& page, const Words& words, const QString& notes, double y, double end) {
    constexpr double lineStep = 6.5;
    if (end - y < 9.0) {
        return;
    }
    page.heading(left, y, full, words.translate("JobCard", "Notes"));
    y += 5.2;
    const double points = notesPoints(page, notes);
    const int lines = std::max(1, static_cast<int>((end - y) / page.lineHeight(points)));
    y += page.paragraph(left, y, full, notes, points, lines);
    const int ruled = static_cast<int>(std::max(0.0, std::ceil((end - y) / lineStep) - 1.0));
    for (int line = 1; line <= ruled; ++line) {
        page.line(left, y + line * lineStep, right, y + line * lineStep);
    }
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
