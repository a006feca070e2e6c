#include "workshop/workshop_card.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "bob-weights/fields.h"
#include "shop/card_page.h"
#include "shop/model/verdict.h"
#include "v8-plugs/fields.h"
#include "workshop/plane_drawing.h"
#include "workshop/plugs/model/v8_text.h"
#include "workshop/plugs/plug_drawing.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

constexpr double cardLeft = CardPage::left;
constexpr double cardWidth = CardPage::full;
constexpr double cardRight = CardPage::right;
constexpr double headingHeight = 5.0;  // mm
/// What is left to be written by hand.
const QString byHand = QStringLiteral("…………………");
constexpr double notePoints = 8.0;
constexpr double aboveNote = 0.6;  // mm

struct Note {
    QString text;
    QColor colour = CardPage::ink;

    bool isWarning() const { return colour == CardPage::amber; }
};

/// A table of the card, and what is to be said of it.
struct Block {
    QString heading;
    std::vector<CardTable::Column> columns;
    Results table;  ///< without headings where all are empty
    CardTable::Bold bold = CardTable::Bold::None;
    std::vector<Note> notes{};

    void say(const QString& text, const QColor& colour = CardPage::ink) {
        if (!text.isEmpty()) {
            notes.push_back({text, colour});
        }
    }
};

/// @return where it ends, mm
double drawBlock(CardPage& page, const Block& block, double y, double rowHeight) {
    const double points = std::clamp((rowHeight - 0.2) / page.lineHeight(1.0), 6.0, 8.5);
    const CardTable table(block.columns, points, rowHeight, block.bold);
    page.heading(cardLeft, y, table.tableWidth(), block.heading);
    y += headingHeight;
    y += table.draw(page, block.table, cardLeft, y);
    for (const Note& note : block.notes) {
        y += aboveNote;
        y += page.paragraph(cardLeft, y, cardWidth, note.text, notePoints, note.isWarning(),
                            note.colour);
    }
    return y;
}

/// Where the planes are, and where the machine reads.
Block planeBlock(const Words& words, const WorkshopModel& model) {
    const Correction& correction = *model.input().correction;
    const auto& permissible = model.solution().permissible;
    Block block{words.translate("BobWeights", "Correction planes"),
                {{38, Qt::AlignLeft}, {28}, {28}, {28}, {34}, {26}},
                {{words.translate("BobWeights", "Plane"), words.name(field::plane_position),
                  words.name(field::plane_radius), words.name(field::reading_position),
                  words.translate("BobWeights", "Drilled from … to"),
                  words.translate("BobWeights", "Permissible residual")}}};
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
        block.table.rows << ResultRow{
            model.planeName(i, words),
            length(plane.position),
            length(plane.radius),
            length(read ? read : plane.position),
            plane.from_angle && plane.to_angle
                ? angle(*plane.from_angle) + QStringLiteral(" … ") + angle(*plane.to_angle)
                : words.text(field::from_angle.placeholder),
            permissible && !model.withheld().verdict
                ? words.number((*permissible)[i], units::gram_mm, 1)
                : none};
    }
    return block;
}

/// What the machine read, run by run, and lines for what it will read.
Block runBlock(const Words& words, const WorkshopModel& model) {
    const std::optional<Correction>& correction = model.input().correction;
    const auto& runs = model.solution().runs;
    const std::size_t first = first_run(correction);
    const QString unit = words.unit(units::gram_mm);
    const auto name = [&](std::size_t plane, const QString& of) {
        return model.planeName(plane, words) + QStringLiteral(", ") + of;
    };
    const QString degrees = QStringLiteral("°");
    Block block{words.translate("BobWeights", "Readings of the balancing machine"),
                {{32, Qt::AlignLeft},
                 {30, Qt::AlignHCenter},
                 {30, Qt::AlignHCenter},
                 {30, Qt::AlignHCenter},
                 {30, Qt::AlignHCenter},
                 {30, Qt::AlignHCenter}},
                {{words.translate("BobWeights", "Run"), name(0, unit), name(0, degrees),
                  name(1, unit), name(1, degrees), words.translate("BobWeights", "Verdict")}}};
    const auto add = [&](std::size_t run, const auto& readings) {
        ResultRow row{WorkshopModel::runName(words, run - first)};
        for (const auto& reading : readings) {
            row << (reading.unbalance ? words.digits(*reading.unbalance, units::gram_mm, 1)
                                      : byHand)
                << (reading.unbalance && !has_direction(*reading.unbalance) ? QStringLiteral("–")
                    : reading.angle ? words.digits(*reading.angle, units::degree, 1)
                                    : byHand);
        }
        const QString verdict = run < runs.size()
                                    ? verdictText(words, readWord(runs[run], runs[run].passes()))
                                    : QString();
        row << (verdict.isEmpty() ? byHand : verdict);
        block.table.rows << row;
    };
    std::size_t run = first;
    if (correction) {
        for (; run < correction->earlier_runs.size(); ++run) {
            add(run, correction->earlier_runs[run].readings);
        }
        if (correction->readings.size() == 2) {
            add(run++, correction->readings);
        }
    }
    const std::size_t rows = first + 4;
    const std::array<Reading, 2> none{};
    for (const std::size_t end = std::min(std::max(rows, run + 1), first + max_runs); run < end;
         ++run) {
        add(run, none);
    }
    return block;
}

/// Which set goes to which cylinder, and apart from it what to take off the parts who want them
/// closer; nothing where nothing is to be done, or there are more cylinders than columns.
std::vector<Block> matchingBlocks(const Words& words, const WorkshopModel& model) {
    constexpr std::size_t maxCylinders = 16;
    constexpr double nameWidth = 42.0;
    const auto cylinders = static_cast<std::size_t>(model.input().engine.cylinders);
    if (cylinders > maxCylinders) {
        return {};
    }
    std::vector<CardTable::Column> columns{{nameWidth, Qt::AlignLeft}};
    columns.insert(columns.end(), cylinders,
                   {(cardWidth - nameWidth) / static_cast<double>(cylinders)});
    std::vector<Block> blocks;
    const auto add = [&](const QString& heading, const Results& results) {
        if (!results.rows.isEmpty()) {
            blocks.push_back({heading, columns, results});
        }
    };
    const bool moves = model.placing() != nullptr && model.placing()->moved > 0;
    if (moves || model.canMoveBack()) {
        add(moves ? words.translate("Matching", "Matched parts: suggested, not yet applied")
                  : words.translate("Matching", "Matched parts: applied, the masses are moved"),
            model.assignmentResults(words));
    }
    add((blocks.empty()
             ? words.translate("Matching", "To match the lightest part, if required: take off, %1")
             : words.translate(
                   "Matching",
                   "To match the lightest part, only if moving is not enough: take off, %1"))
            .arg(words.unit(units::gram)),
        model.takeOffResults(words));
    if (!blocks.empty()) {
        blocks.back().say(words.translate("Matching",
                                          "The bob weight is for the parts as weighed: weigh parts "
                                          "again after making them lighter."));
    }
    return blocks;
}

/// The weights of the sheet, as many cylinders in a table as are read well.
std::vector<Block> weightBlocks(const Words& words, const WorkshopModel& model) {
    const Engine& engine = model.input().engine;
    const auto sheet = fitted(model.input()).weigh_in;
    if (!sheet || sheet->is_empty()) {
        return {};
    }
    constexpr std::size_t maximum = 12;
    constexpr double nameWidth = 34.0;
    const auto cylinders = static_cast<std::size_t>(engine.cylinders);
    const std::size_t tables = (cylinders + maximum - 1) / maximum;
    const std::size_t each = (cylinders + tables - 1) / tables;
    std::vector<Block> blocks;
    for (std::size_t first = 0; first < cylinders; first += each) {
        const std::size_t end = std::min(first + each, cylinders);
        Block block{words.translate("JobCard", "Masses of the parts by cylinder, %1")
                        .arg(words.unit(units::gram)),
                    {{nameWidth, Qt::AlignLeft}},
                    {{words.translate("Matching", "Cylinder")}}};
        for (std::size_t i = first; i < end; ++i) {
            block.columns.push_back({(cardWidth - nameWidth) / static_cast<double>(each)});
            block.table.columns.push_back(QString::number(i + 1));
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
            block.table.rows << row;
        }
        blocks.push_back(std::move(block));
    }
    const QStringList pins = model.cylindersOfCrankpins();
    if (engine.rods_on_crankpin() > 1 && !pins.isEmpty()) {
        blocks.back().say(words.translate("BobWeights", "Cylinders that share a crankpin: %1.")
                              .arg(pins.join(QStringLiteral("; "))));
    }
    return blocks;
}

/// All that follows from the weights.
std::vector<Block> weighedBlocks(const Words& words, const WorkshopModel& model) {
    std::vector<Block> blocks = matchingBlocks(words, model);
    std::ranges::move(weightBlocks(words, model), std::back_inserter(blocks));
    if (blocks.empty()) {
        return blocks;
    }
    const QString again = model.weighAgain(words);
    blocks.front().say(model.assignmentText(words),
                       again.isEmpty() ? CardPage::ink : CardPage::amber);
    const Results effects = model.effectResults(words);
    if (effects.rows.size() > 1) {  // the spread is in the summary
        blocks.insert(blocks.begin() + 1, {words.translate("Matching", "Effect of the matching"),
                                           {{80, Qt::AlignLeft}, {51}, {51}},
                                           effects});
    }
    return blocks;
}

/// The options of the plugs, and the values of the engine.
std::vector<Block> plugBlocks(const Words& words, const WorkshopModel& model) {
    const v8_plugs::Input& input = *model.plugsInput();
    const v8_plugs::Result& result = *model.plugs();
    Block options{
        words.translate("JobCard", "Options by cost"),
        {{54, Qt::AlignLeft}, {26}, {26}, {26}, {50}},
        {{QString(), words.translate("JobCard", "take off each, %1").arg(words.unit(units::gram)),
          words.translate("JobCard", "maximum each, %1").arg(words.unit(units::gram)),
          words.translate("JobCard", "remains, %1").arg(words.unit(units::gram_mm)),
          words.translate("JobCard", "verdict")}}};
    for (const v8_plugs::OptionId id : v8_plugs::all_options) {
        const auto& option = result.option(id);
        if (!option) {
            continue;
        }
        const QString verdict = !option->works() ? words.translate("JobCard", "does not work")
                                : option->by_method_alone()
                                    ? words.translate("JobCard", "only by the method")
                                    : words.translate("JobCard", "works");
        options.table.rows << ResultRow{
            v8_text::optionName(words, id), words.cell(option->take_off(), units::gram, 3),
            words.cell(option->max_reduction, units::gram, 3),
            words.cell(option->residual_unbalance, units::gram_mm, 1),
            model.isFitted(id)
                ? verdict
                : words.translate("JobCard", "other crankshaft") + QStringLiteral(": ") + verdict};
    }
    options.say(model.shiftText(words));
    Block values{words.translate("JobCard", "Engine"),
                 {{62, Qt::AlignLeft}, {27}, {4}, {62, Qt::AlignLeft}, {27}},
                 {}};
    const auto add = [&](const QString& name, const QString& value) {
        ResultRows& rows = values.table.rows;
        if (rows.isEmpty() || rows.constLast().size() > 2) {
            rows << ResultRow{name, value};
        } else {
            rows.last() << QString() << name << value;
        }
    };
    for (const v8_plugs::EngineField& each : v8_plugs::engine_fields()) {
        if (const auto& value = input.engine.*each.member) {
            add(words.name(each.field), words.plainWithUnit(*value, each.field.unit, 4));
        }
    }
    for (const v8_plugs::MassChangeField& each : v8_plugs::mass_change_fields()) {
        if (input.changes_known()) {
            add(words.name(each.field),
                words.plainWithUnit(result.changes.*each.member, units::gram, 3));
        }
    }
    add(words.name(v8_plugs::field::tolerance),
        words.plainWithUnit(input.tolerance, units::gram_mm, 2));
    std::vector<Block> blocks;
    if (!options.table.rows.isEmpty()) {
        blocks.push_back(std::move(options));
    }
    blocks.push_back(std::move(values));
    return blocks;
}

}  // namespace

QString WorkshopCard::title() const {
    return words_.translate("BobWeights", "Job card: balancing") + QLatin1Char(' ') +
           QString::fromStdString(model_.input().job.engine_number);
}

/// Whose job it is.
double WorkshopCard::head(CardPage& page, double y) const {
    const workshop::Input& input = model_.input();
    page.text(cardLeft, y, cardWidth * 0.7, words_.translate("BobWeights", "Job card: balancing"),
              14, Qt::AlignLeft, true);
    const QString engine = input.plugs && !input.plugs->engine.name.empty()
                               ? words_.translate("JobCard", "V-8 engine: %1")
                                     .arg(v8_text::engineName(words_, input.plugs->engine.name))
                               : WorkshopModel::engineName(words_, input.engine);
    const double x = cardLeft + cardWidth * 0.7;
    double end = y + 7.5;
    if (page.textWidth(engine, CardPage::smallestType, true) <= cardRight - x) {
        page.text(x, y + 1.2, cardRight - x, engine, 10, Qt::AlignRight, true);
    } else {
        end = std::max(
            end, y + page.paragraph(x, y, cardRight - x, engine, CardPage::smallestType, true));
    }
    y = end;
    page.line(cardLeft, y, cardRight, y, 0.5, CardPage::ink);
    y += 1.5;
    const double third = cardWidth / 3.0;
    const JournalJob job = JobDesk::entryOf(input.job);
    const auto row = [&](const std::array<std::pair<QString, QString>, 3>& blanks) {
        double height = 0.0;
        for (std::size_t i = 0; i < blanks.size(); ++i) {
            const auto& [caption, value] = blanks.at(i);
            height = std::max(height, page.blank(cardLeft + static_cast<double>(i) * third, y,
                                                 i == 2 ? third + 3 : third, caption, value));
        }
        y += height + 1.3;
    };
    row({{{words_.translate("JobCard", "Engine number"), job.engineNumber},
          {words_.translate("JobCard", "Crankshaft number"), job.crankshaftNumber},
          {words_.translate("JobCard", "Date"),
           words_.day(QString::fromStdString(input.job.date))}}});
    row({{{words_.translate("JobCard", "Customer"), job.customer},
          {words_.translate("JobCard", "Technician"), job.technician},
          {words_.translate("BobWeights", "Balanced"),
           words_.text(balance_words[static_cast<std::size_t>(input.balance)].label)}}});
    return y - 1.0;
}

/// What the technician typed, all of it; on the first sheet lines to write on fill its room.
double WorkshopCard::notes(CardPage& page, double y) const {
    const QString notes = QString::fromStdString(model_.input().job.notes).simplified();
    constexpr double lineStep = 6.5;
    constexpr double minToWrite = 9.0;
    // More than a line is set smaller.
    const double points = page.textWidth(notes, 8.5) <= cardWidth ? 8.5 : 7.2;
    if (notes.isEmpty() && (page.number() > 1 || page.end() - y < minToWrite)) {
        return y;
    }
    // The heading is not left alone.
    if (y + headingHeight + page.lineHeight(points) > page.end()) {
        y = page.nextSheet();
    }
    page.heading(cardLeft, y, cardWidth, words_.translate("JobCard", "Notes"));
    y = page.flow(y + headingHeight, notes, points);
    if (page.number() > 1) {
        return y;
    }
    const int ruled = static_cast<int>(std::max(0.0, std::ceil((page.end() - y) / lineStep) - 1.0));
    for (int line = 1; line <= ruled; ++line) {
        page.line(cardLeft, y + line * lineStep, cardRight, y + line * lineStep);
    }
    return page.end();
}

/// Lines to sign on, and the method in small print.
void WorkshopCard::signatures(CardPage& page, double y) const {
    const double third = cardWidth / 3.0;
    const QStringList captions{words_.translate("JobCard", "Technician, signature"),
                               words_.translate("JobCard", "Inspector, signature"),
                               words_.translate("JobCard", "Date")};
    for (int i = 0; i < 3; ++i) {
        const double x = cardLeft + i * third;
        page.line(x, y + 7.0, x + third - 6.0, y + 7.0, 0.2, CardPage::ink);
        page.text(x, y + 7.3, third - 6.0, captions.at(i), 7, Qt::AlignLeft, false, CardPage::grey);
    }
    page.text(cardLeft, y + 13.0, cardWidth,
              words_.translate("BobWeights", "Ravnoves %1 · ISO 21940-11 · %2")
                  .arg(QStringLiteral(RAVNOVES_VERSION), model_.machineText(words_)),
              6.5, Qt::AlignLeft, false, CardPage::grey);
}

/// What to do in the largest type, and what is wrong.
double WorkshopCard::answer(CardPage& page, double y) const {
    constexpr double large = 20.0;
    constexpr double largest = 26.0;
    const workshop::Withheld withheld = model_.withheld();
    const bool isDoubtful = withheld.any() || !rejectedText().isEmpty();
    const QString verdict = withheld.any() ? QString() : verdictText(words_, model_.verdictNow());
    const QColor& colour = withheld.any() ? CardPage::red
                           : isDoubtful   ? CardPage::amber
                                          : CardPage::ink;
    const bool isKnown = model_.solution().bob_weight.has_value();
    const double inner = cardLeft + 3.0;
    const double room = cardWidth - 6.0;
    QStringList more{isKnown && !model_.hasPlugs() ? model_.factorText(words_) : QString(),
                     model_.boringText(words_)};
    if (model_.isMean()) {
        more << model_.placedText(words_);
    }
    more.removeAll(QString());
    QStringList warnings = QStringList{rejectedText()} + model_.troubles(words_, true);
    warnings.removeAll(QString());
    const auto content = [&](double from) {
        double at = from;
        if (withheld.any() && !withheld.bob_weight) {
            at += page.paragraph(inner, at, room, words_.translate("Workshop", "STOP"), largest,
                                 true, colour);
        }
        at += page.paragraph(inner, at, room, model_.headline(words_),
                             withheld.bob_weight ? largest
                             : isKnown           ? large
                                                 : 12.0,
                             true, colour);
        at += page.paragraph(inner, at, room, model_.hangText(words_), 11);
        at += page.paragraph(inner, at + 0.4, room, verdict, large, true);
        at += page.paragraph(inner, at + 0.4, room, model_.adviceText(words_), 12, true) + 0.4;
        at += page.paragraph(inner, at + 0.4, room, more.join(QLatin1Char(' ')), 8.5);
        return at + page.paragraph(inner, at + 0.4, room,
                                   warnings.join(QChar(QChar::LineSeparator)), 10, true,
                                   CardPage::amber);
    };
    const double height = page.heightOf(content) + 3.6;
    page.box(cardLeft, y, cardWidth, height, CardPage::shade, colour, isDoubtful ? 1.2 : 0.3);
    content(y + 1.6);
    return y + height;
}

/// Each plane as a clock with its holes below.
double WorkshopCard::clocks(CardPage& page, double y) const {
    constexpr double gap = 4.0;
    constexpr double clock = 46.0;
    const double width = (cardWidth - gap) / 2.0;
    const Result& shaft = model_.solution();
    double end = y;
    for (std::size_t plane = 0; plane < 2; ++plane) {
        const double x = cardLeft + static_cast<double>(plane) * (width + gap);
        page.heading(x, y, width, model_.planeName(plane, words_));
        double at = y + headingHeight;
        if (!page.isMeasuring()) {
            const QColor amber = CardPage::amber;
            drawPlane(page.painter(), page.rect(x, at, width, clock),
                      {model_.input(), shaft, plane},
                      {.line = CardPage::ink,
                       .thin = CardPage::hair,
                       .text = CardPage::ink,
                       .hole = CardPage::ink,
                       .slug = CardPage::grey,
                       .reading = amber,
                       .limit = CardPage::grey,
                       .fits = CardPage::ink,
                       .exceeds = amber,
                       .font = page.font(7.0),
                       .lineWidth = 0.3 * page.unit()});
        }
        at += clock + 1.0;
        const CardTable holes({{38, Qt::AlignLeft}, {20}, {15}, {15}}, 9.0, 5.2,
                              CardTable::Bold::All);
        at += holes.draw(page, model_.holeResults(words_, plane), x, at);
        end = std::max(end, at);
    }
    // By another convention a hole is drilled on the wrong side.
    return end + 0.8 +
           page.paragraph(cardLeft, end + 0.8, cardWidth, model_.machineText(words_), 9.0, true);
}

/// To the right of the lines of the bob weight.
void WorkshopCard::drawPlugBeside(CardPage& page, double y) const {
    constexpr double x = cardLeft + 122.0;
    constexpr double width = cardWidth - 122.0;
    constexpr double height = 44.0;
    page.heading(x, y, width, words_.translate("JobCard", "Plug"));
    if (!page.isMeasuring()) {
        static const QColor cut(0xB0, 0x30, 0x10);
        drawPlug(
            page.painter(), page.rect(x, y + headingHeight, width, height),
            plannedPlug(*model_.plugsInput(), *model_.plugs()),
            {CardPage::ink, CardPage::hair, CardPage::ink, cut, page.font(7.5), 0.35 * page.unit()},
            words_);
    }
}

void WorkshopCard::draw(CardPage& page) const {
    constexpr double gap = 2.5;
    constexpr double signaturesTop = 273.5;
    constexpr double rowHeight = 4.4;
    const Result& shaft = model_.solution();
    page.setFoot(signaturesTop, [&] { signatures(page, signaturesTop); });
    double y = head(page, CardPage::top);
    y = answer(page, y + gap);
    const bool hasMetal = std::any_of(shaft.runs.begin(), shaft.runs.end(),
                                      [](const RunResult& run) { return run.is_drilled(); });
    if (shaft.correction || hasMetal) {
        y = page.place(y + gap, [&](double at) { return clocks(page, at); });
    }
    std::vector<Block> machine;
    if (hasMetal) {
        machine.push_back({words_.translate("BobWeights", "Already drilled"),
                           {{22, Qt::AlignLeft}, {62, Qt::AlignLeft}, {20}, {54}, {24}},
                           model_.drilledResults(words_)});
    }
    if (shaft.correction) {
        machine.push_back(
            {words_.translate("BobWeights", "Correction: measured → after correction"),
             {{62, Qt::AlignLeft}, {60}, {60}},
             model_.planeResults(words_)});
        machine.back().say(model_.holeNote(words_) + QLatin1Char(' ') + model_.metalsText(words_));
    }
    machine.push_back(runBlock(words_, model_));
    machine.back().say(model_.limitText(words_));
    if (model_.input().correction && model_.input().correction->planes.size() == 2 &&
        model_.input().correction->readings.size() == 2) {
        machine.push_back(planeBlock(words_, model_));
    }
    for (const Block& block : machine) {
        y = page.place(y + gap, [&](double at) { return drawBlock(page, block, at, rowHeight); });
    }
    y = page.flow(y + 1.0, otherRejectedText(), notePoints, CardPage::amber);
    y = notes(page, y + gap);

    std::vector<Block> parts;
    const bool hasPlug = shaft.bob_weight && model_.plugs() != nullptr;
    if (shaft.bob_weight) {
        std::vector<CardTable::Column> columns{{62, Qt::AlignLeft}, {40}, {40}, {40}};
        if (hasPlug) {
            columns = {{58, Qt::AlignLeft}, {18}, {20}, {20}};
        }
        parts.push_back({words_.translate("BobWeights", "Bob weight, line by line"),
                         std::move(columns), model_.lineResults(words_), CardTable::Bold::Last});
    }
    if (model_.plugs() != nullptr) {
        for (Block& block : plugBlocks(words_, model_)) {
            parts.push_back(std::move(block));
        }
    }
    for (Block& block : weighedBlocks(words_, model_)) {
        parts.push_back(std::move(block));
    }
    if (!parts.empty() && page.number() == 1) {
        y = page.nextSheet();  // the first page goes to the machine
    }
    for (const Block& block : parts) {
        y = page.place(y + gap, [&](double at) {
            if (hasPlug && &block == &parts.front()) {
                drawPlugBeside(page, at);
            }
            return drawBlock(page, block, at, rowHeight);
        });
    }
    page.finishSheet();
}

}  // namespace ravnoves
