#include "workshop/workshop_card.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QPagedPaintDevice>
#include <QSettings>
#include <algorithm>
#include <array>

#include "bob-weights/fields.h"
#include "shop/model/verdict.h"
#include "text/usual_paper.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "workshop/plane_drawing.h"
#include "workshop/plugs/model/v8_text.h"
#include "workshop/plugs/plug_drawing.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

const QString paperKey = QStringLiteral("workshop/paper");  ///< upright, in points
const QString shopKey = QStringLiteral("workshop/shop-name");

const QString ink = QStringLiteral("#111111");
const QString grey = QStringLiteral("#555555");
const QString amber = QStringLiteral("#9a6700");  ///< what does not count
const QString red = QStringLiteral("#b02020");    ///< STOP

constexpr int largest = 35;  ///< type, 1/96 inch

/// What is left to be written by hand.
const QString byHand = QStringLiteral("…………………");

/// @param text  plain
/// @param side  of the page or cell
QString lines(const QString& text, int pixels, bool isBold = false, const QString& colour = ink,
              const QString& side = QStringLiteral("left")) {
    return text.isEmpty()
               ? QString()
               : QStringLiteral(
                     "<p style=\"font-size: %1px; font-weight: %2; color: %3; text-align: %4; "
                     "margin-top: 2px\">%5</p>\n")
                     .arg(QString::number(pixels),
                          isBold ? QStringLiteral("700") : QStringLiteral("400"), colour, side,
                          text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br/>")));
}

void embolden(QStringList& row) {
    for (QString& cell : row) {
        cell = QStringLiteral("<b>%1</b>").arg(cell);
    }
}

/// A table of the card, and what is to be said of it.
struct Block {
    QString heading;
    QVector<int> widths;      ///< of its columns, percent
    Results table;            ///< without headings where all are empty
    QString notes = {};       ///< HTML
    QVector<int> left = {0};  ///< columns of words
    bool hasSum = false;      ///< in its last row

    void say(const QString& text, const QString& colour = ink) {
        notes += lines(text, 11, colour == amber, colour);
    }
    /// Nothing of a table without rows.
    QString html() const {
        if (table.rows.isEmpty()) {
            return {};
        }
        paper::Table shown = paper::tableOf(table);
        shown.widths = widths;
        shown.numbers = QVector<bool>(widths.size(), true);
        for (const int column : left) {
            shown.numbers[column] = false;
        }
        if (hasSum) {
            embolden(shown.rows.last());
        }
        return paper::heading(heading, 2) + paper::table(shown) + notes;
    }
};

/// Columns of a table that has one for each cylinder.
QVector<int> byCylinder(std::size_t cylinders) {
    constexpr int name = 20;
    QVector<int> widths(static_cast<qsizetype>(cylinders) + 1,
                        (100 - name) / static_cast<int>(cylinders));
    widths.front() = name;
    return widths;
}

/// Where the planes are, and where the machine reads.
Block planeBlock(const Words& words, const WorkshopModel& model) {
    const Correction& correction = *model.input().correction;
    const auto& permissible = model.solution().permissible;
    Block block{words.translate("BobWeights", "Correction planes"),
                {16, 14, 12, 20, 18, 20},
                {{words.translate("BobWeights", "Plane"), words.name(field::plane_position),
                  words.name(field::plane_radius), words.name(field::reading_position),
                  words.translate("BobWeights", "Drilled from … to"),
                  words.translate("BobWeights", "Permissible residual")}}};
    const QString none = QStringLiteral("–");
    // What is blank may be a rejected entry then, or what is wrong.
    const bool isStopped = model.withheld().limits;
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
            length(read || isStopped ? read : plane.position),
            plane.from_angle && plane.to_angle
                ? angle(*plane.from_angle) + QStringLiteral(" … ") + angle(*plane.to_angle)
            : isStopped || plane.has_half_sector() ? none
                                                   : words.text(field::from_angle.placeholder),
            permissible && !isStopped ? words.number((*permissible)[i], units::gram_mm, 1) : none};
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
                {18, 16, 16, 16, 16, 18},
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
void addMatching(std::vector<Block>& blocks, const Words& words, const WorkshopModel& model) {
    constexpr std::size_t maxCylinders = 16;
    const auto cylinders = static_cast<std::size_t>(model.input().engine.cylinders);
    if (cylinders > maxCylinders) {
        return;
    }
    const std::size_t first = blocks.size();
    const auto add = [&](const QString& heading, const Results& results) {
        if (!results.rows.isEmpty()) {
            blocks.push_back({heading, byCylinder(cylinders), results});
        }
    };
    const bool moves = model.placing() != nullptr && model.placing()->moved > 0;
    if (moves || model.canMoveBack()) {
        add(moves ? words.translate("Matching", "Matched parts: suggested, not yet applied")
                  : words.translate("Matching", "Matched parts: applied, the masses are moved"),
            model.assignmentResults(words));
    }
    add((blocks.size() == first
             ? words.translate("Matching", "To match the lightest part, if required: take off, %1")
             : words.translate(
                   "Matching",
                   "To match the lightest part, only if moving is not enough: take off, %1"))
            .arg(words.unit(units::gram)),
        model.takeOffResults(words));
    if (blocks.size() > first) {
        blocks.back().say(words.translate("Matching",
                                          "The bob weight is for the parts as weighed: weigh parts "
                                          "again after making them lighter."));
    }
}

/// The weights of the sheet, as many cylinders in a table as are read well.
void addWeights(std::vector<Block>& blocks, const Words& words, const WorkshopModel& model) {
    const Engine& engine = model.input().engine;
    const auto sheet = fitted(model.input()).weigh_in;
    if (!sheet || sheet->is_empty()) {
        return;
    }
    constexpr std::size_t maximum = 12;
    const auto cylinders = static_cast<std::size_t>(engine.cylinders);
    const std::size_t tables = (cylinders + maximum - 1) / maximum;
    const std::size_t each = (cylinders + tables - 1) / tables;
    for (std::size_t first = 0; first < cylinders; first += each) {
        const std::size_t end = std::min(first + each, cylinders);
        Block block{words.translate("JobCard", "Masses of the parts by cylinder, %1")
                        .arg(words.unit(units::gram)),
                    byCylinder(each),
                    {{words.translate("Matching", "Cylinder")}}};
        for (std::size_t i = first; i < end; ++i) {
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
}

/// All that follows from the weights.
void addWeighed(std::vector<Block>& blocks, const Words& words, const WorkshopModel& model) {
    const std::size_t first = blocks.size();
    addMatching(blocks, words, model);
    addWeights(blocks, words, model);
    if (blocks.size() == first) {
        return;
    }
    const QString again = model.weighAgain(words);
    blocks[first].say(model.assignmentText(words), again.isEmpty() ? ink : amber);
    const Results effects = model.effectResults(words);
    if (effects.rows.size() > 1) {  // the spread is in the summary
        blocks.insert(
            blocks.begin() + static_cast<std::ptrdiff_t>(first) + 1,
            {words.translate("Matching", "Effect of the matching"), {44, 28, 28}, effects});
    }
}

/// The options of the plugs, and the values of the engine.
void addPlugs(std::vector<Block>& blocks, const Words& words, const WorkshopModel& model) {
    const v8_plugs::Input& input = *model.plugsInput();
    const v8_plugs::Result& result = *model.plugs();
    Block options{
        words.translate("JobCard", "Options by cost"),
        {34, 12, 15, 13, 26},
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
                                    ? words.translate("JobCard", "works, shift included")
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
    Block values{words.translate("JobCard", "Engine"), {34, 16, 34, 16}, {}};
    values.left = {0, 2};
    const auto add = [&](const QString& name, const QString& value) {
        ResultRows& rows = values.table.rows;
        if (rows.isEmpty() || rows.constLast().size() > 2) {
            rows << ResultRow{name, value};
        } else {
            rows.last() << name << value;
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
    if (!model.withheld().limits) {  // as every limit
        add(words.name(v8_plugs::field::tolerance),
            words.plainWithUnit(input.tolerance, units::gram_mm, 2));
    }
    blocks.push_back(std::move(options));
    blocks.push_back(std::move(values));
}

/// A row across the page, or several; cells are HTML.
QString rowOf(const QStringList& cells, const QString& style) {
    QString html;
    for (const QString& cell : cells) {
        html += QStringLiteral("<td width=\"%1%\" style=\"%2\">%3</td>")
                    .arg(QString::number(100 / cells.size()), style, cell);
    }
    return QStringLiteral("<tr>%1</tr>\n").arg(html);
}
QString across(const QString& rows) {
    return QStringLiteral("<table width=\"100%\">%1</table>\n").arg(rows);
}

class Card {
  public:
    /// @param rejected  entries that no result depends on
    Card(const WorkshopModel& model, const Words& words, const QStringList& rejected)
        : model_(model), words_(words), rejected_(rejected) {}

    Paper make() {
        paper_.title = stop(QStringLiteral(". ")) +
                       words_.translate("BobWeights", "Job card: balancing") + QLatin1Char(' ') +
                       QString::fromStdString(model_.input().job.engine_number);
        paper_.foot = QSettings().value(shopKey).toString();
        paper_.isWrittenOn = true;
        paper_.pageOf = words_.translate("JobCard", "Page %1 of %2");
        paper_.body = head() + answer();
        forTheMachine();
        ofParts();
        return std::move(paper_);
    }

  private:
    /// "STOP" with what follows it; empty where nothing is withheld.
    QString stop(const QString& end = {}) const {
        return model_.withheld().any() ? words_.translate("Workshop", "STOP") + end : QString();
    }

    /// Whose job it is.
    QString head() const {
        const workshop::Input& input = model_.input();
        const QString engine = input.plugs && !input.plugs->engine.name.empty()
                                   ? words_.translate("JobCard", "V-8 engine: %1")
                                         .arg(v8_text::engineName(words_, input.plugs->engine.name))
                                   : WorkshopModel::engineName(words_, input.engine);
        const JournalJob job = JobDesk::entryOf(input.job);
        const auto row = [](const std::array<std::pair<QString, QString>, 3>& blanks) {
            QStringList cells;
            for (const auto& [caption, value] : blanks) {
                cells << lines(caption, 9, false, grey) +
                             lines(value.isEmpty() ? QString(QChar::Nbsp) : value, 12, true);
            }
            return rowOf(cells, QStringLiteral("border-bottom: 1px solid #999999"));
        };
        return lines(paper_.foot, 12, true) +
               across(rowOf({lines(words_.translate("BobWeights", "Job card: balancing"), 19, true),
                             lines(engine, 13, true, ink, QStringLiteral("right"))},
                            QStringLiteral("border-bottom: 2px solid #111111"))) +
               across(
                   row({{{words_.translate("JobCard", "Engine number"), job.engineNumber},
                         {words_.translate("JobCard", "Crankshaft number"), job.crankshaftNumber},
                         {words_.translate("JobCard", "Date"),
                          words_.day(QString::fromStdString(input.job.date))}}}) +
                   row({{{words_.translate("JobCard", "Customer"), job.customer},
                         {words_.translate("JobCard", "Technician"), job.technician},
                         {words_.translate("BobWeights", "Balanced"),
                          words_.text(
                              balance_words[static_cast<std::size_t>(input.balance)].label)}}}));
    }

    /// What to do in the largest type, and what is wrong.
    QString answer() const {
        constexpr int large = 27;  // 20 pt
        const workshop::Withheld withheld = model_.withheld();
        const QString verdict =
            withheld.any() ? QString() : verdictText(words_, model_.verdictNow());
        const QString colour = withheld.any() ? red : ink;
        const RunResult* newest = model_.solution().newest();
        const bool isKnown = model_.solution().bob_weight.has_value();
        QStringList more{isKnown && !model_.hasPlugs() ? model_.factorText(words_) : QString(),
                         model_.boringText(words_)};
        if (model_.isMean()) {
            more << model_.placedText(words_);
        }
        more.removeAll(QString());
        QString content;
        if (withheld.any() && (!withheld.bob_weight || (newest != nullptr && newest->is_read()))) {
            content = lines(words_.translate("ravnoves::WorkshopModel", "STOP: do not drill yet"),
                            largest, true, colour);
        }
        content += lines(model_.headline(words_),
                         withheld.bob_weight ? largest
                         : isKnown           ? large
                                             : 16,
                         true, withheld.bob_weight ? colour : ink) +
                   lines(model_.hangText(words_), 15) + lines(verdict, large, true) +
                   lines(model_.adviceText(words_), 16, true) +
                   lines(more.join(QLatin1Char(' ')), 11);
        for (const QString& each : model_.troubles(words_, true)) {
            content += lines(each, 13, true, amber);
        }
        return across(rowOf({content}, QStringLiteral("background-color: #eeeeee; "
                                                      "padding: 4px 11px; border: %1px solid %2")
                                           .arg(colour == ink ? 1 : 4)
                                           .arg(colour)));
    }

    /// Each plane as a clock with its holes below.
    QString clocks() {
        QStringList names;
        QStringList pictures;
        QStringList holes;
        for (std::size_t plane = 0; plane < 2; ++plane) {
            names << lines(model_.planeName(plane, words_), 14, true);
            const QSize size(320, 164);
            const auto draw = [input = model_.input(), shaft = model_.solution(), plane,
                               size](QPainter& painter) {
                const QColor black(ink);
                drawPlane(painter, QRectF(QPointF(), size), {input, shaft, plane},
                          {.line = black,
                           .thin = QColor(0x99, 0x99, 0x99),
                           .text = black,
                           .hole = black,
                           .slug = QColor(grey),
                           .reading = QColor(amber),
                           .limit = QColor(grey),
                           .fits = black,
                           .exceeds = QColor(amber),
                           .font = Theme::font(9),
                           .lineWidth = 1.1});
            };
            pictures << paper_.picture({{}, {}, size, draw});
            Results found = model_.holeResults(words_, plane);
            paper::Table table = paper::tableOf(found);
            table.widths = {36, 26, 16, 22};
            std::ranges::for_each(table.rows, embolden);
            holes << paper::table(table);
        }
        const QString none = QStringLiteral("border: none");
        return across(rowOf(names, QStringLiteral("border-bottom: 1px solid #111111")) +
                      rowOf(pictures, none) + rowOf(holes, none)) +
               // By another convention, or from another zero, a hole is drilled on the wrong side.
               lines(model_.machineText(words_), 12, true) +
               (model_.input().machine.zero.empty()
                    ? lines(words_.translate("BobWeights", "0°: %1.").arg(byHand), 12, true)
                    : QString());
    }

    /// The first page, with room to write on and lines to sign on.
    void forTheMachine() {
        const Result& shaft = model_.solution();
        const bool hasMetal = std::any_of(shaft.runs.begin(), shaft.runs.end(),
                                          [](const RunResult& run) { return run.is_drilled(); });
        const bool hasClocks = shaft.correction || hasMetal;
        if (hasClocks) {
            paper_.body += clocks();
        }
        std::vector<Block> blocks;
        if (hasMetal) {
            blocks.push_back({words_.translate("BobWeights", "Already drilled"),
                              {12, 30, 14, 26, 18},
                              model_.drilledResults(words_)});
            blocks.back().left = {0, 1};
        }
        if (shaft.correction) {
            blocks.push_back(
                {words_.translate("BobWeights", "Correction: measured → after correction"),
                 {34, 33, 33},
                 model_.planeResults(words_)});
            blocks.back().say(model_.holeNote(words_) + QLatin1Char(' ') +
                              model_.metalsText(words_));
        }
        blocks.push_back(runBlock(words_, model_));
        blocks.back().say(model_.limitText(words_));
        const std::optional<Correction>& correction = model_.input().correction;
        if (correction && correction->planes.size() == 2 && correction->readings.size() == 2) {
            blocks.push_back(planeBlock(words_, model_));
        }
        for (const Block& block : blocks) {
            paper_.body += block.html();
        }
        if (!rejected_.isEmpty()) {
            paper_.body +=
                lines(words_.translate("JobCard", "Not accepted, the previous value is used: %1")
                          .arg(rejected_.join(QLatin1Char(' '))),
                      11, true, amber);
        }
        paper_.body += paper::heading(words_.translate("JobCard", "Notes"), 2) +
                       lines(QString::fromStdString(model_.input().job.notes).simplified(), 11) +
                       paper::blankLines;
        QStringList captions{words_.translate("JobCard", "Technician, signature"),
                             words_.translate("JobCard", "Inspector, signature"),
                             words_.translate("JobCard", "Date")};
        for (QString& caption : captions) {
            caption = lines(caption, 9, false, grey);
        }
        paper_.body +=
            across(rowOf(QStringList(3, lines(QString(QChar::Nbsp), 18)),
                         QStringLiteral("border-bottom: 1px solid #111111")) +
                   rowOf(captions, QStringLiteral("border: none"))) +
            lines(words_.translate("BobWeights", "Ravnoves %1 · ISO 21940-11")
                          .arg(QStringLiteral(RAVNOVES_VERSION)) +
                      (hasClocks ? QString() : QStringLiteral(" · ") + model_.machineText(words_)),
                  9, false, grey);
    }

    void ofParts() {
        QString parts;
        if (model_.solution().bob_weight) {
            Block weight{words_.translate("BobWeights", "Bob weight, line by line"),
                         {40, 20, 20, 20},
                         model_.lineResults(words_)};
            weight.hasSum = true;
            parts = weight.html();
            if (const QString drawing = plug(); !drawing.isEmpty()) {
                const QString cells = QStringLiteral(
                    "<tr><td width=\"64%\" style=\"border: none\">%1</td>"
                    "<td width=\"36%\" style=\"border: none\">%2</td></tr>");
                parts = across(cells.arg(
                    parts, paper::heading(words_.translate("JobCard", "Plug"), 2) + drawing));
            }
        }
        std::vector<Block> blocks;
        if (model_.plugs() != nullptr) {
            addPlugs(blocks, words_, model_);
        }
        addWeighed(blocks, words_, model_);
        for (const Block& block : blocks) {
            parts += block.html();
        }
        if (!parts.isEmpty()) {
            paper_.body += paper::endOfFirstPage + lines(stop(), largest, true, red) + parts;
        }
    }

    /// Nothing of one that cannot be made: a drawing with sizes would be machined.
    QString plug() {
        const auto planned = plannedPlug(model_);
        if (!planned || planned->impossible) {
            return {};
        }
        const QSize size(225, 166);
        return paper_.figure({{}, {}, size, [planned, words = words_, size](QPainter& painter) {
                                  const QColor black(ink);
                                  drawPlug(painter, QRectF(QPointF(), size), *planned,
                                           {black, QColor(0x99, 0x99, 0x99), black,
                                            QColor(0xB0, 0x30, 0x10), Theme::font(10), 1.3},
                                           words);
                              }});
    }

    const WorkshopModel& model_;
    Words words_;
    QStringList rejected_;
    Paper paper_;
};

}  // namespace

Paper jobCard(const WorkshopModel& model, const Words& words, const QStringList& rejected,
              const QStringList& ofResult) {
    if (ofResult.isEmpty()) {
        return Card(model, words, rejected).make();
    }
    QStringList others = rejected;
    others.removeIf([&](const QString& each) { return ofResult.contains(each); });
    const auto stopped = model.stoppedBy(
        words
            .translate("JobCard",
                       "No bob weight, holes or plug work are printed until these entries are "
                       "corrected: %1")
            .arg(ofResult.join(QLatin1Char(' '))));
    return Card(*stopped, words, others).make();
}

QPageSize cardPaper() {
    const QPageSize kept(QSettings().value(paperKey).toSize());
    return kept.isValid() ? kept : QPageSize(usualPaper());
}

void keepCardPaper(const QPagedPaintDevice& device) {
    const QPageSize chosen = device.pageLayout().pageSize();
    if (chosen.isValid() && chosen != cardPaper()) {  // the usual one may change with the country
        QSettings().setValue(paperKey, chosen.sizePoints());
    }
}

void askShopName(QWidget* parent) {
    QInputDialog dialog(parent);
    dialog.setWindowTitle(
        QCoreApplication::translate("ravnoves::ShopDialog", "Shop on the job card"));
    dialog.setLabelText(QCoreApplication::translate("ravnoves::ShopDialog", "&Name of the shop"));
    dialog.setTextValue(QSettings().value(shopKey).toString());
    dialog.resize(Theme::withText(420),
                  dialog.sizeHint().height());  // a name is longer than a word
    if (dialog.exec() == QDialog::Accepted) {
        QSettings().setValue(shopKey, dialog.textValue().trimmed());
    }
}

}  // namespace ravnoves
