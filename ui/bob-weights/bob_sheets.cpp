#include "bob-weights/bob_sheets.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <array>

#include "bob-weights/fields.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "workshop/journal_dialog.h"

namespace ravnoves {

using namespace bob_weights;

BobJobSheet::BobJobSheet(BobWeightsModel* model, QWidget* parent) : BobSheet(model, parent) {
    section(tr("Engine"));
    QComboBox* type = ordered(
        Form::choice("/engine/type", [this](int chosen) { return model_->chooseType(chosen); }));
    enlarge(type);
    number("/engine/cylinders");
    NumberField* bank = number("/engine/bank_angle_deg");
    QComboBox* rods = choice("/engine/rods_per_pin");
    NumberField* split = number("/engine/pin_split_deg");
    follow([this, bank, rods, split] {
        const EngineType chosen = model_->input().engine.type;
        bank->setEnabled(chosen == EngineType::v);
        split->setEnabled(chosen == EngineType::v);
        rods->setEnabled(chosen != EngineType::in_line);
    });
    section(tr("Factor"));
    number("/factor/reciprocating_percent");
    number("/factor/overbalance_percent");
    line(Theme::smallSize, [this] { return model_->reasonText(); });
    section(tr("Job"));
    text("/job/engine_number");
    text("/job/crankshaft_number");
    text("/job/customer");
    checked(field::date,
            {[](const QString& typed) { return readDay(typed).toString(Qt::ISODate); }, dayTrouble,
             [this] { return QString::fromStdString(model_->input().job.date); },
             [this](const QString& name, const QString& day) {
                 model_->edit(name, [&](Input& input) { input.job.date = day.toStdString(); });
             },
             [](const QString& day) { return Words().day(day); }});
    text("/job/technician");
    finish();
}

BobPartsSheet::BobPartsSheet(BobWeightsModel* model, QWidget* parent) : BobSheet(model, parent) {
    section(tr("Parts of one cylinder"));
    for (const PartField& part : part_fields()) {
        const std::string pointer = "/parts_g/" + std::string(part.field.key);
        NumberField* field = number(pointer.c_str());
        follow([this, field, part] {
            // What the weigh-in sheet of a case says goes before what is typed here.
            const auto mass = mass_of(model_->input(), part);
            field->setEnabled(mass == model_->input().parts.*part.member);
        });
    }
    line(Theme::smallSize, [this] {
        return model_->input().weigh_in ? tr("Those in grey are the means of the weigh-in sheet.")
                                        : QString();
    });
    section(tr("Crankshaft"));
    choice("/balance");
    line(Theme::smallSize, [this] {
        return model_->input().balance == Balance::external
                   ? tr("Balance it with its damper and its flywheel in place, each in the "
                        "position in which it stays.")
                   : QString();
    });
    section(tr("Notes on the job card"));
    text("/job/notes", 200);
    finish();
}

BobWeighInSheet::BobWeighInSheet(BobWeightsModel* model, QWidget* parent)
    : BobSheet(model, parent) {
    section({});
    choice("/weigh_in/cylinder_numbering");
    auto* holder = new QWidget(current());
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(Theme::gap);
    grid->setVerticalSpacing(2);
    current()->addWide(holder);
    auto* trouble = new TroubleLine(current());
    current()->addWide(trouble);
    for (int cylinder = 0; cylinder < mostRows; ++cylinder) {
        auto* number = new QLabel(QString::number(cylinder + 1), holder);
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(number, cylinder + 1, 0);
        follow([this, number, cylinder] {
            number->setVisible(cylinder < model_->input().engine.cylinders);
        });
    }
    int row = mostRows + 1;
    for (const QString& name : {tr("mean, g"), tr("spread, g")}) {
        auto* label = new QLabel(shownTitle(name).text, holder);
        label->setFont(Theme::font(Theme::smallSize));
        grid->addWidget(label, row++, 0);
    }
    for (int column = 0; column < static_cast<int>(workshop::all_parts.size()); ++column) {
        addColumn(grid, column, trouble);
    }
    line(Theme::baseSize, [this] { return model_->weighInText(); });
    finish();
}

void BobWeighInSheet::addColumn(QGridLayout* grid, int column, TroubleLine* trouble) {
    const workshop::Part part = workshop::all_parts[static_cast<std::size_t>(column)];
    const QString name = shownText(workshop::part_word(part).label);
    QWidget* holder = grid->parentWidget();
    auto* head = new QLabel(name, holder);
    head->setFont(Theme::font(Theme::smallSize, true));
    head->setWordWrap(true);
    head->setAlignment(Qt::AlignCenter);
    grid->addWidget(head, 0, column + 1);
    grid->setColumnStretch(column + 1, 1);
    for (int cylinder = 0; cylinder < mostRows; ++cylinder) {
        NumberField* cell = addCell(name, part, cylinder, holder);
        trouble->watch(cell);
        grid->addWidget(cell, cylinder + 1, column + 1);
    }
    auto* mean = new QLabel(holder);
    auto* spread = new QLabel(holder);
    int row = mostRows + 1;
    for (QLabel* label : {mean, spread}) {
        label->setAlignment(Qt::AlignRight);
        grid->addWidget(label, row++, column + 1);
    }
    const auto show = [this, part, mean, spread] {
        const auto [meanText, spreadText, counts] = model_->columnNote(part);
        mean->setText(meanText);
        spread->setText(spreadText);
        const Theme& theme = Theme::instance();
        colourText(mean, counts ? theme.text() : theme.warning());
        mean->setToolTip(counts ? QString() : tr("Counts once every cylinder is weighed."));
    };
    connect(&Theme::instance(), &Theme::changed, this, show);
    follow(show);
}

NumberField* BobWeighInSheet::addCell(const QString& name, workshop::Part part, int cylinder,
                                      QWidget* holder) {
    constexpr int cellHeight = 28;
    auto* cell = ordered(new NumberField(field::part_mass, holder));
    const std::string_view word = workshop::part_word(part).word;
    cell->setObjectName(
        QStringLiteral("mass_%1_%2")
            .arg(QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())))
            .arg(cylinder + 1));
    const QString title = shownTitle(tr("%1 of cylinder %2, g").arg(name).arg(cylinder + 1)).text;
    cell->setAccessibleName(title);
    cell->setHint(tr("%1 of cylinder %2 as the scale says.").arg(name).arg(cylinder + 1));
    cell->setOptional(true);
    cell->setMinimumWidth(Theme::withText(44));
    cell->setMinimumHeight(Theme::withText(cellHeight));
    const auto at = static_cast<std::size_t>(cylinder);
    bind(
        cell,
        [this, part, at]() -> std::optional<double> {
            const auto& sheet = model_->input().weigh_in;
            if (!sheet || at >= (*sheet)[part].mass.size() || !(*sheet)[part].mass[at]) {
                return std::nullopt;
            }
            return from_si(field::part_mass, *(*sheet)[part].mass[at]);
        },
        [this, part, at, title](std::optional<double> value) {
            model_->editWeights(title, [&](WeighIn& sheet) {
                sheet[part].mass.at(at) =
                    value ? std::optional(*value * field::part_mass.unit) : std::nullopt;
            });
        });
    makeCell(cell);
    follow(
        [this, cell, cylinder] { cell->setVisible(cylinder < model_->input().engine.cylinders); });
    return cell;
}

BobMachineSheet::BobMachineSheet(BobWeightsModel* model, QWidget* parent)
    : BobSheet(model, parent) {
    buildPlanes();
    buildTolerance();
    finish();
}

void BobMachineSheet::buildPlanes() {
    section(tr("Planes and readings"));
    auto* holder = new QWidget(current());
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(Theme::gap);
    grid->setVerticalSpacing(Theme::gap);
    current()->addWide(holder);
    auto* trouble = new TroubleLine(current());
    current()->addWide(trouble);
    const std::array names{Words().translate("BobWeights", "Front plane"),
                           Words().translate("BobWeights", "Rear plane")};
    const auto label = [&](int row, int column, const QString& text) {
        auto* made = new QLabel(text, holder);
        made->setFont(Theme::font(Theme::smallSize, row == 0));
        made->setAlignment(row == 0 ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignVCenter);
        grid->addWidget(made, row, column);
    };
    label(0, 1, names[0]);
    label(0, 2, names[1]);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    std::array<QList<NumberField*>, 2> fields;
    const auto row = [&](int at, const char* key, const Field& field, auto get) {
        const QString unit = shownUnit(field.unit).name;
        label(at, 0, fieldName(field) + QStringLiteral(", ") + unit);
        for (std::size_t plane = 0; plane < 2; ++plane) {
            auto* cell = new NumberField(field, holder);
            const QString name = names[plane] + QStringLiteral(": ") + fieldName(field);
            cell->setObjectName(QStringLiteral("%1_%2").arg(QLatin1String(key)).arg(plane + 1));
            cell->setAccessibleName(name);
            cell->setHint(shownText(field.hint));
            cell->setOptional(true);
            enlarge(cell);
            bind(
                cell,
                [this, get, plane, &field]() -> std::optional<double> {
                    Correction shown = model_->input().correction.value_or(Correction{});
                    const auto& value = get(shown, plane);
                    return value ? std::optional(from_si(field, *value)) : std::nullopt;
                },
                [this, get, plane, &field, name](std::optional<double> value) {
                    model_->editCorrection(name, [&](Correction& correction) {
                        get(correction, plane) =
                            value ? std::optional(*value * field.unit) : std::nullopt;
                    });
                });
            makeCell(cell);
            trouble->watch(cell);
            grid->addWidget(cell, at, static_cast<int>(plane) + 1);
            fields[plane] << cell;
        }
    };
    using Value = std::optional<double>;
    row(1, "position", field::plane_position,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].position; });
    row(2, "radius", field::plane_radius,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].radius; });
    row(3, "unbalance", field::unbalance,
        [](Correction& c, std::size_t i) -> Value& { return c.readings[i].unbalance; });
    row(4, "angle", field::angle,
        [](Correction& c, std::size_t i) -> Value& { return c.readings[i].angle; });
    row(5, "read_at", field::reading_position,
        [](Correction& c, std::size_t i) -> Value& { return c.readings[i].position; });
    row(6, "from", field::from_angle,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].from_angle; });
    row(7, "to", field::to_angle,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].to_angle; });
    for (const auto& column : fields) {  // down the columns, as one reads the machine
        for (NumberField* field : column) {
            ordered(field);
        }
    }
}

void BobMachineSheet::buildTolerance() {
    section(tr("What may remain"));
    auto* own = box(
        QStringLiteral("own_limit"), tr("&A limit of your own for each plane, no grade"),
        tr("On: so many g·mm may remain in each plane. Off: by grade, mass and speed."),
        [this] { return model_->input().tolerance && !model_->input().tolerance->by_grade; },
        [this](bool on) {
            model_->editTolerance(tr("Kind of limit"), [on](Tolerance& it) { it.by_grade = !on; });
        });
    ordered(own);
    number("/tolerance/g_mm");
    grades_ = ordered(new QComboBox(current()));
    grades_->setObjectName(QStringLiteral("grade_list"));
    grades_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const workshop::BalanceGrade& grade : workshop::balance_grades()) {
        grades_->addItem(QStringLiteral("G %1: %2")
                             .arg(formNumber(grade.mm_per_s, QLocale()), shownText(grade.use)),
                         grade.mm_per_s);
        grades_->setItemData(grades_->count() - 1, shownText(grade.use), Qt::ToolTipRole);
    }
    grades_->setPlaceholderText(tr("grade of your own"));
    enlarge(grades_);
    current()->addWidget(tr("&For"), grades_, {},
                         tr("Balance quality grades of ISO 21940-11, and what each is for."));
    connect(grades_, &QComboBox::activated, this, [this](int place) {
        model_->editTolerance(fieldName(field::grade), [&](Tolerance& it) {
            it.by_grade = true;
            it.grade = grades_->itemData(place).toDouble() * field::grade.unit;
        });
    });
    number("/tolerance/grade_mm_s");
    number("/tolerance/rotor_mass_kg");
    number("/tolerance/service_speed_rpm");
    number("/tolerance/centre_of_mass_mm");
    number("/tolerance/front_bearing_mm");
    number("/tolerance/rear_bearing_mm");
    follow([this] { showGrade(); });
    line(Theme::baseSize, [this] { return model_->limitText(); });
}

void BobMachineSheet::showGrade() {
    const QSignalBlocker block(grades_);
    const auto& tolerance = model_->input().tolerance;
    int place = -1;
    if (tolerance && tolerance->by_grade && tolerance->grade) {
        place = grades_->findData(from_si(field::grade, *tolerance->grade));
    }
    grades_->setCurrentIndex(place);
}

BobDrillsSheet::BobDrillsSheet(BobWeightsModel* model, QWidget* parent) : BobSheet(model, parent) {
    section(tr("Drills at hand"));
    checked(field::diameters,
            {[](const QString& typed) {
                 const auto drills = BobWeightsModel::readDrills(typed);
                 QStringList list;
                 for (const double diameter : drills.value_or(std::vector<double>{})) {
                     list << formNumber(diameter, QLocale());
                 }
                 return list.join(QStringLiteral("; "));
             },
             [](const QString& typed) {
                 return BobWeightsModel::readDrills(typed)
                            ? QString()
                            : tr("Diameters in millimetres, one after the other: 8; 10; 12.5");
             },
             [this] { return model_->drillsText(); },
             [this](const QString& name, const QString& normal) {
                 model_->editCorrection(name, [&](Correction& correction) {
                     correction.drill.diameters_mm =
                         BobWeightsModel::readDrills(normal).value_or(std::vector<double>{});
                 });
             }});
    number("/correction/drill/maximum_depth_mm");
    number("/correction/drill/point_angle_deg");
    number("/correction/drill/density_kg_m3");
    number("/correction/drill/depth_step_mm");
    section(tr("Several holes"));
    number("/correction/drill/maximum_holes");
    number("/correction/drill/minimum_wall_mm");
    number("/correction/drill/maximum_angle_deg");
    section(tr("Heavy metal"));
    const auto slug = [this](const Field& field, std::optional<double> Slug::*member) {
        NumberField* made = number(
            field,
            [this, member, &field]() -> std::optional<double> {
                const auto& correction = model_->input().correction;
                return correction && correction->slug && *correction->slug.*member
                           ? std::optional(from_si(field, *(*correction->slug.*member)))
                           : std::nullopt;
            },
            [this, member, &field](std::optional<double> value) {
                model_->editSlug(fieldName(field), [&](Slug& it) {
                    it.*member = value ? std::optional(*value * field.unit) : std::nullopt;
                });
            });
        made->setObjectName(QStringLiteral("slug_") + made->objectName());
    };
    slug(field::slug_diameter, &Slug::diameter);
    slug(field::slug_density, &Slug::density);
    finish();
}

}  // namespace ravnoves
