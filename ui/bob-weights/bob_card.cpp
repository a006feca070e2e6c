#include "bob-weights/bob_card.h"

#include "bob-weights/fields.h"
#include "bob-weights/model/bob_text.h"
#include "workshop/card_blocks.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

constexpr double cardLeft = CardPage::left;
constexpr double cardWidth = CardPage::full;
constexpr double rowHeight = 5.0;  // mm

/// A table under its heading. @return where it ends, mm
double cardTable(CardPage& page, const QString& heading, std::vector<CardTable::Column> columns,
                 const QStringList& head, const QVector<QStringList>& rows, double y,
                 bool lastIsBold = false) {
    page.heading(cardLeft, y, cardWidth, heading);
    CardTable table(std::move(columns), 8.5, rowHeight);
    table.head(head);
    for (qsizetype i = 0; i < rows.size(); ++i) {
        const bool bold = lastIsBold && i + 1 == rows.size();
        table.add({rows.at(i), bold, bold});
    }
    return y + 5.0 + table.draw(page, cardLeft, y + 5.0);
}

}  // namespace

BobCard::BobCard(Input input, Words words)
    : JobCard(std::move(words)), input_(std::move(input)), solution_(solve(input_)) {}

QString BobCard::title() const {
    return words().translate("BobWeights", "Job card: bob weights and correction") +
           QLatin1Char(' ') + QString::fromStdString(input_.job.engine_number);
}

void BobCard::draw(CardPage& page) const {
    constexpr double gap = 3.0;
    constexpr double machineTop = 226.0;
    constexpr double signaturesTop = 273.5;
    const auto text = [](const std::string& value) { return QString::fromStdString(value); };
    const workshop::JobHeader& job = input_.job;
    double y = cardHead(
        page, words(),
        {words().translate("BobWeights", "Job card: bob weights and correction"),
         bob_text::engineName(words(), input_.engine), text(job.engine_number),
         text(job.crankshaft_number), text(job.date), text(job.customer), text(job.technician),
         words().translate("BobWeights", "Balanced"), bob_text::balance(words(), input_.balance)},
        CardPage::top);
    const bool known = solution_.bob_weight.has_value();
    y = cardAnswer(page,
                   {known ? bob_text::hang(words(), input_.engine) : QString(),
                    bob_text::headline(words(), input_, solution_),
                    known ? bob_text::factor(words(), input_, solution_) : QString(),
                    bob_text::shortfalls(words(), solution_).join(QLatin1Char(' '))},
                   y + gap);
    y = cardTable(page, words().translate("BobWeights", "Bob weight, line by line"),
                  {{62, Qt::AlignLeft}, {40}, {40}, {40}}, bob_text::lineHead(words()),
                  bob_text::lines(words(), solution_), y + gap, known);
    if (solution_.correction) {
        y = cardTable(page, words().translate("BobWeights", "Correction planes"),
                      {{38, Qt::AlignLeft}, {32}, {24}, {28}, {28}, {32, Qt::AlignHCenter}},
                      bob_text::planeHead(words()), bob_text::planes(words(), solution_), y + gap);
        y = cardTable(page, words().translate("BobWeights", "Holes and slugs"),
                      {{38, Qt::AlignLeft}, {44, Qt::AlignLeft}, {25}, {25}, {25}, {25}},
                      bob_text::holeHead(words()), bob_text::holes(words(), solution_), y + gap);
    }
    const QString limits = bob_text::limits(words(), solution_);
    if (!limits.isEmpty()) {
        y += page.paragraph(cardLeft, y + 1.0, cardWidth, limits, 8, 2) + 1.0;
    }
    cardNotes(page, words(), text(job.notes).simplified(), y + gap, machineTop - gap);

    const QString byHand = QStringLiteral("…………………");
    QVector<QStringList> runs;
    for (const QString& run : {words().translate("BobWeights", "First run"),
                               words().translate("BobWeights", "Second run"),
                               words().translate("BobWeights", "Last run")}) {
        runs << QStringList{run, byHand, byHand, byHand, byHand};
    }
    const QString unbalance = words().unit(units::gram_mm);
    cardTable(page, words().translate("BobWeights", "Balancing machine, by hand"),
              {{38, Qt::AlignLeft},
               {36, Qt::AlignHCenter},
               {36, Qt::AlignHCenter},
               {36, Qt::AlignHCenter},
               {36, Qt::AlignHCenter}},
              {QString(), words().translate("BobWeights", "front, %1").arg(unbalance),
               words().translate("BobWeights", "front, °"),
               words().translate("BobWeights", "rear, %1").arg(unbalance),
               words().translate("BobWeights", "rear, °")},
              runs, machineTop);
    cardSignatures(page, words(),
                   words()
                       .translate("BobWeights",
                                  "Ravnoves %1 · ISO 21940-11 · depths of the full diameter, the "
                                  "point of the drill beyond · angles from the machine's zero mark")
                       .arg(QStringLiteral(RAVNOVES_VERSION)),
                   signaturesTop);
}

}  // namespace ravnoves
