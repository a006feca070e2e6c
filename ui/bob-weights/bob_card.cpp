#include "bob-weights/bob_card.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "bob-weights/fields.h"
#include "bob-weights/model/bob_text.h"
#include "workshop/card_blocks.h"
#include "workshop/model/verdict.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

constexpr double cardLeft = CardPage::left;
constexpr double cardWidth = CardPage::full;
constexpr double headingHeight = 5.0;  // mm
constexpr double notePoints = 8.0;
constexpr double aboveNote = 0.6;  // mm

struct Note {
    QString text;
    QColor colour = CardPage::ink;

    bool isWarning() const { return colour == CardPage::amber; }
};

/// A table of the card, or two beside each other, and what is to be said of it.
struct Block {
    QString heading;
    std::vector<CardTable::Column> columns;
    QStringList head;
    ResultRows rows;
    bool lastIsBold = false;
    ResultRows beside{};  ///< of the same columns
    std::vector<Note> notes{};

    double lines() const { return 1.0 + static_cast<double>(std::max(rows.size(), beside.size())); }
    void say(const QString& text, const QColor& colour = CardPage::ink) {
        if (!text.isEmpty()) {
            notes.push_back({text, colour});
        }
    }
    double notesHeight(const CardPage& page) const {
        double height = 0.0;
        for (const Note& note : notes) {
            height += aboveNote + page.heightOf(note.text, notePoints, cardWidth, note.isWarning());
        }
        return height;
    }
};

/// @return where it ends, mm
double drawBlock(CardPage& page, const Block& block, double y, double rowHeight) {
    page.heading(cardLeft, y, cardWidth, block.heading);
    y += headingHeight;
    const double points = std::clamp((rowHeight - 0.2) / page.lineHeight(1.0), 6.0, 8.5);
    double x = cardLeft;
    double height = 0.0;
    for (const auto* rows : {&block.rows, &block.beside}) {
        if (rows->isEmpty()) {
            continue;
        }
        CardTable table(block.columns, points, rowHeight);
        table.head(block.head);
        for (qsizetype i = 0; i < rows->size(); ++i) {
            const ResultRows& others = rows == &block.rows ? block.beside : block.rows;
            const bool bold = block.lastIsBold && i + 1 == rows->size();
            table.add({rows->at(i).texts(), bold, bold, others.value(i).texts()});
        }
        height = std::max(height, table.draw(page, x, y));
        x = cardLeft + cardWidth / 2.0 + 1.5;
    }
    y += height;
    for (const Note& note : block.notes) {
        y += aboveNote;
        y += page.paragraph(cardLeft, y, cardWidth, note.text, notePoints, note.isWarning(),
                            note.colour);
    }
    return y;
}

Block lineBlock(const Words& words, const Result& result) {
    return {words.translate("BobWeights", "Bob weight, line by line"),
            {{62, Qt::AlignLeft}, {40}, {40}, {40}},
            bob_text::lineHead(words),
            bob_text::lines(words, result),
            result.bob_weight.has_value()};
}

/// Where the planes are, and where the machine reads.
Block planeBlock(const Words& words, const Correction& correction, const Result& result) {
    Block block{words.translate("BobWeights", "Correction planes"),
                {{38, Qt::AlignLeft}, {28}, {28}, {28}, {34}, {26}},
                {words.translate("BobWeights", "Plane"), words.name(field::plane_position),
                 words.name(field::plane_radius), words.name(field::reading_position),
                 words.translate("BobWeights", "Drilled from … to"),
                 words.translate("BobWeights", "May remain")},
                {}};
    const QString none = QStringLiteral("–");
    const auto length = [&](const std::optional<double>& value) {
        return value ? words.plainWithUnit(*value, units::mm, 2) : none;
    };
    for (std::size_t i = 0; i < 2; ++i) {
        const Plane& plane = correction.planes.at(i);
        const auto angle = [&](double value) {
            return words.plainWithUnit(value, units::degree, 1);
        };
        const auto& read = correction.readings.at(i).position;
        block.rows << ResultRow{
            bob_text::planeName(words, i),
            length(plane.position),
            length(plane.radius),
            length(read ? read : plane.position),
            plane.from_angle && plane.to_angle
                ? angle(*plane.from_angle) + QStringLiteral(" … ") + angle(*plane.to_angle)
                : words.text(field::from_angle.placeholder),
            result.permissible ? words.number((*result.permissible)[i], units::gram_mm, 1) : none};
    }
    return block;
}

/// What the machine read, run by run, and lines for what it will read.
Block runBlock(const Words& words, const std::optional<Correction>& correction,
               const Result& result) {
    const QString unit = words.unit(units::gram_mm);
    Block block{
        words.translate("BobWeights", "Readings of the balancing machine"),
        {{32, Qt::AlignLeft},
         {30, Qt::AlignHCenter},
         {30, Qt::AlignHCenter},
         {30, Qt::AlignHCenter},
         {30, Qt::AlignHCenter},
         {30, Qt::AlignHCenter}},
        {words.translate("BobWeights", "Run"), words.translate("BobWeights", "front, %1").arg(unit),
         words.translate("BobWeights", "front, °"),
         words.translate("BobWeights", "rear, %1").arg(unit),
         words.translate("BobWeights", "rear, °"), words.translate("BobWeights", "Measured")},
        {}};
    const auto add = [&](std::size_t run, const auto& readings) {
        ResultRow row{bob_text::runName(words, run)};
        for (const auto& reading : readings) {
            row << (reading.unbalance ? words.digits(*reading.unbalance, units::gram_mm, 1)
                                      : byHand)
                << (reading.unbalance && !has_direction(*reading.unbalance) ? QStringLiteral("–")
                    : reading.angle ? words.digits(*reading.angle, units::degree, 1)
                                    : byHand);
        }
        const QString verdict =
            run < result.runs.size()
                ? verdictText(words, readWord(result.runs[run], result.runs[run].passes()))
                : QString();
        row << (verdict.isEmpty() ? byHand : verdict);
        block.rows << row;
    };
    std::size_t run = 0;
    if (correction) {
        for (; run < correction->earlier_runs.size(); ++run) {
            add(run, correction->earlier_runs[run].readings);
        }
        add(run++, correction->readings);
    }
    constexpr std::size_t rows = 4;
    const std::array<EarlierReading, 2> none{};
    for (const std::size_t end = std::min(std::max(rows, run + 1), most_runs); run < end; ++run) {
        add(run, none);
    }
    return block;
}

/// Which set goes to which cylinder, and apart from it what to take off the parts who want them
/// closer; nothing where nothing is to be done, or there are more cylinders than columns.
std::vector<Block> matchingBlocks(const Words& words, const Input& input, const Result& result) {
    constexpr std::size_t mostCylinders = 16;
    constexpr double nameWidth = 42.0;
    const auto cylinders = static_cast<std::size_t>(input.engine.cylinders);
    const auto sheet = fitted(input).weigh_in;
    if (!sheet || cylinders > mostCylinders) {
        return {};
    }
    std::vector<CardTable::Column> columns{{nameWidth, Qt::AlignLeft}};
    columns.insert(columns.end(), cylinders,
                   {(cardWidth - nameWidth) / static_cast<double>(cylinders)});
    std::vector<Block> blocks;
    const auto add = [&](const QString& heading, const ResultRows& rows) {
        if (!rows.isEmpty()) {
            blocks.push_back(
                {heading, columns, matching_text::cylinderHead(words, cylinders), rows});
        }
    };
    const bool isDoubted = !bob_text::weighAgain(words, input).isEmpty();
    const auto* placing = result.placing && !isDoubted ? &*result.placing : nullptr;
    const bool moves = placing != nullptr && placing->moved > 0;
    if (sheet->is_moved() || moves) {
        add(moves ? words.translate("Matching", "Matched parts: suggested, not applied yet")
                  : words.translate("Matching", "Matched parts: applied, the weights are moved"),
            matching_text::setsOfCylinders(words, sheet->piston_sets, sheet->rod_sets, cylinders,
                                           placing));
    }
    add((blocks.empty()
             ? words.translate("Matching",
                               "To match the lightest, if the parts are to be closer: take off, %1")
             : words.translate("Matching",
                               "To match the lightest, only if moving is not enough: take off, %1"))
            .arg(words.unit(units::gram)),
        matching_text::takeOff(words, cylinders, masses_of(*sheet)).rows);
    if (!blocks.empty()) {
        blocks.back().say(words.translate(
            "Matching",
            "The bob weight is that of the parts as weighed: where one is made lighter, weigh "
            "again."));
    }
    return blocks;
}

/// The weights of the sheet, as many cylinders in a table as are read well.
std::vector<Block> weightBlocks(const Words& words, const Input& input) {
    const auto sheet = fitted(input).weigh_in;
    if (!sheet || sheet->is_empty()) {
        return {};
    }
    constexpr std::size_t most = 12;
    constexpr double nameWidth = 34.0;
    const auto cylinders = static_cast<std::size_t>(input.engine.cylinders);
    const std::size_t tables = (cylinders + most - 1) / most;
    const std::size_t each = (cylinders + tables - 1) / tables;
    std::vector<Block> blocks;
    for (std::size_t first = 0; first < cylinders; first += each) {
        const std::size_t end = std::min(first + each, cylinders);
        Block block{words.translate("JobCard", "Weights of the parts by cylinder, %1")
                        .arg(words.unit(units::gram)),
                    {{nameWidth, Qt::AlignLeft}},
                    {words.translate("Matching", "Cylinder")},
                    {}};
        for (std::size_t i = first; i < end; ++i) {
            block.columns.push_back({(cardWidth - nameWidth) / static_cast<double>(each)});
            block.head << QString::number(i + 1);
        }
        for (const shop::Part part : shop::all_parts) {
            const auto& column = (*sheet)[part];
            if (column.is_empty()) {
                continue;
            }
            ResultRow row{words.text(shop::part_word(part).label)};
            for (std::size_t i = first; i < end; ++i) {
                const auto& mass = column.mass[i];
                row << (mass ? words.cell(*mass, units::gram, 2) : ResultCell(QStringLiteral("–")));
            }
            block.rows << row;
        }
        blocks.push_back(std::move(block));
    }
    const QStringList pins = bob_text::cylindersOfCrankpins(input);
    if (input.engine.rods_on_crankpin() > 1 && !pins.isEmpty()) {
        blocks.back().say(words.translate("BobWeights", "Cylinders that share a crankpin: %1.")
                              .arg(pins.join(QStringLiteral("; "))));
    }
    return blocks;
}

/// What is drilled and pressed in.
Block holeBlock(const Words& words, const Input& input, const Result& result) {
    const auto front = bob_text::holes(words, result, 0);
    const auto rear = bob_text::holes(words, result, 1);
    Block block{words.translate("BobWeights", "Holes and slugs"),
                {{42, Qt::AlignLeft}, {16}, {13}, {18}},
                bob_text::holeHead(words),
                front,
                false,
                rear};
    const bool hasSlugs =
        result.correction &&
        std::any_of(result.correction->begin(), result.correction->end(),
                    [](const PlaneResult& plane) { return !plane.slugs.empty(); });
    if (hasSlugs) {
        // What names a slug is too long for half the width.
        block.columns = {{82, Qt::AlignLeft}, {30}, {30}, {40}};
        block.rows = front + rear;
        block.beside.clear();
    }
    block.say(bob_text::holeNote(words, result) + QLatin1Char(' ') +
              bob_text::metals(words, input, result));
    return block;
}

}  // namespace

BobCard::BobCard(Input input, Result solution, Words words)
    : JobCard(std::move(words)), input_(std::move(input)), solution_(std::move(solution)) {}

QString BobCard::title() const {
    return words().translate("BobWeights", "Job card: bob weights and correction") +
           QLatin1Char(' ') + QString::fromStdString(input_.job.engine_number);
}

void BobCard::draw(CardPage& page) const {
    constexpr double gap = 2.5;
    constexpr double signaturesTop = 273.5;
    page.setFoot(signaturesTop, [&] {
        cardSignatures(page, words(),
                       words()
                           .translate("BobWeights",
                                      "Ravnoves %1 · ISO 21940-11 · angles from the machine's zero "
                                      "mark, in one sense for readings and holes")
                           .arg(QStringLiteral(RAVNOVES_VERSION)),
                       signaturesTop);
    });
    double y = cardHead(
        page, words(),
        {words().translate("BobWeights", "Job card: bob weights and correction"),
         bob_text::engineName(words(), input_.engine), input_.job,
         words().translate("BobWeights", "Balanced"), bob_text::balance(words(), input_.balance)},
        CardPage::top);
    const bool known = solution_.bob_weight.has_value();
    const auto broken = bob_text::brokenRule(words(), input_, solution_);
    const bool hasPlanes = input_.correction && input_.correction->planes.size() == 2 &&
                           input_.correction->readings.size() == 2;
    QStringList wrong{refusedText(), bob_text::otherReadings(words(), solution_)};
    wrong << bob_text::doubts(words(), input_, solution_)
          << bob_text::shortfalls(words(), solution_);
    wrong.removeAll(QString());
    using Of = bob_text::BrokenRule::Of;
    QStringList caution{broken.of == Of::Parts ? broken.text : QString(),
                        bob_text::notGiven(words(), solution_)};
    caution.removeAll(QString());
    QStringList more;
    if (bob_text::isMean(words(), solution_)) {
        more << bob_text::weighIn(words(), input_, solution_) + QLatin1Char(' ') +
                    bob_text::placedWeighIn(words(), input_, solution_);
    }
    more << (known ? bob_text::factor(words(), input_, solution_) : QString()) + QLatin1Char(' ') +
                bob_text::verdict(words(), solution_);
    y = cardAnswer(
        page,
        {known ? bob_text::hang(words(), input_.engine) : QString(),
         bob_text::headline(words(), input_, solution_), more.join(QChar::LineSeparator).trimmed(),
         caution.join(QLatin1Char(' ')), wrong.join(QLatin1Char(' '))},
        y + gap);

    std::vector<Block> blocks{lineBlock(words(), solution_)};
    if (hasPlanes) {
        blocks.push_back(planeBlock(words(), *input_.correction, solution_));
    }
    Block runs = runBlock(words(), input_.correction, solution_);
    Block& planes = hasPlanes ? blocks.back() : runs;
    planes.say(bob_text::limits(words(), input_, solution_));
    if (broken.of != Of::Parts) {
        (broken.of == Of::Planes ? planes : runs).say(broken.text, CardPage::amber);
    }
    runs.say(bob_text::runWarnings(words(), input_, solution_).join(QLatin1Char(' ')),
             CardPage::amber);
    blocks.push_back(std::move(runs));
    if (auto drilled = bob_text::drilled(words(), solution_); !drilled.isEmpty()) {
        blocks.push_back({words().translate("BobWeights", "Already drilled"),
                          {{22, Qt::AlignLeft}, {62, Qt::AlignLeft}, {20}, {54}, {24}},
                          bob_text::drilledHead(words()),
                          std::move(drilled)});
        blocks.back().say(bob_text::drilledNote(words(), solution_));
    }
    if (solution_.correction) {
        blocks.push_back({words().translate("BobWeights", "Correction: measured → after it"),
                          {{38, Qt::AlignLeft}, {32}, {24}, {28}, {30}, {30, Qt::AlignHCenter}},
                          bob_text::planeHead(words()),
                          bob_text::planes(words(), solution_)});
        if (!bob_text::holes(words(), solution_).isEmpty()) {
            blocks.push_back(holeBlock(words(), input_, solution_));
        }
    }
    std::vector<Block> parts = matchingBlocks(words(), input_, solution_);
    for (Block& block : weightBlocks(words(), input_)) {
        parts.push_back(std::move(block));
    }
    if (const auto matched = bob_text::matchingShown(input_, solution_);
        matched && !parts.empty()) {
        parts.front().say((matching_text::summary(words(), *matched) + QLatin1Char(' ') +
                           matching_text::felt(words(), *matched))
                              .trimmed());
    }
    if (!parts.empty()) {
        parts.front().say(bob_text::weighAgain(words(), input_), CardPage::amber);
    }
    blocks.insert(blocks.end(), std::make_move_iterator(parts.begin()),
                  std::make_move_iterator(parts.end()));
    // What the tables have room for.
    const QString typed = QString::fromStdString(input_.job.notes).simplified();
    const QString others = otherRefusedText();
    double room = page.end() - y - cardNotesHeight(page, typed) - gap -
                  page.heightOf(others, notePoints, cardWidth);
    double lines = 0.0;
    for (const Block& block : blocks) {
        room -= headingHeight + gap + block.notesHeight(page);
        lines += block.lines();
    }
    // Where even low rows do not fit on one sheet they are as high as is read well.
    constexpr double lowest = 3.3;
    constexpr double usual = 4.2;
    const double rowHeight = room / lines < lowest ? usual : std::min(room / lines, 4.8);
    for (const Block& block : blocks) {
        y = page.place(y + gap, [&](double at) { return drawBlock(page, block, at, rowHeight); });
    }
    y = page.flow(y + 1.0, others, notePoints, CardPage::amber);
    cardNotes(page, words(), typed, y + gap);
    page.finishSheet();
}

}  // namespace ravnoves
