#include "bob-weights/bob_sheets.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <array>

#include "bob-weights/fields.h"
#include "bob-weights/model/bob_text.h"
#include "model/editable_table.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"
#include "theme/theme.h"

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
        for (NumberField* angle : {bank, split}) {
            angle->setEnabled(chosen == EngineType::v);
            if (!angle->isEnabled()) {
                angle->setPlaceholderText(QStringLiteral("–"));
            }
        }
        rods->setEnabled(chosen != EngineType::in_line);
    });
    section(tr("Factor"));
    doubt(number("/factor/reciprocating_percent"),
          [this] { return is_share_of_one(model_->input().factor); });
    number("/factor/overbalance_percent");
    line(Theme::smallSize, [this] { return model_->reasonText(); });
    addJob();
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
            field->setEnabled(!is_weighed(model_->input(), part));
            if (!field->isEnabled() && mass) {
                field->setValue(from_si(part.field, *mass));
            }
        });
    }
    QLabel* grey = line(Theme::smallSize, [this] {
        return model_->replacedInputs().empty()
                   ? QString()
                   : tr("Those in grey are the means of the weigh-in sheet.");
    });
    grey->setTextInteractionFlags(Qt::NoTextInteraction);  // of the form: no report has it
    section(tr("Crankshaft"));
    wide(choice("/balance"));
    line(Theme::smallSize, [this] {
        return model_->input().balance == Balance::external
                   ? tr("Balance it with its damper and its flywheel in place, each in the "
                        "position in which it stays.")
                   : QString();
    });
    section(tr("Notes on the job card"));
    text("/job/notes", longestNotes);
    finish();
}

BobWeighInSheet::BobWeighInSheet(BobWeightsModel* model, QWidget* parent)
    : MatchingSheet(model, parent) {
    section({});
    QComboBox* pairs = wide(choice("/weigh_in/cylinder_numbering"), 250);
    const auto noPairs = [model] {
        return model->input().engine.type == EngineType::in_line
                   ? tr("In line each cylinder has a crankpin of its own: there is nothing to "
                        "choose.")
                   : QString();
    };
    follow([pairs, noPairs, hint = pairs->toolTip()] {
        const QString why = noPairs();
        pairs->setEnabled(why.isEmpty());
        pairs->setToolTip(why.isEmpty() ? hint : why);
    });
    line(Theme::smallSize, noPairs);
    line(Theme::smallSize, [model] {
        const int cylinders = model->input().engine.cylinders;
        return cylinders > mostRows
                   ? tr("The sheet shows %1 of %2 cylinders. A column of a spreadsheet pasted at "
                        "the first has room for all, or type the means on sheet 2.")
                         .arg(mostRows)
                         .arg(cylinders)
                   : QString();
    });
    addWeights(new WeighInTable(
                   WeighInTable::sourceOf(model, field::part_mass, false,
                                          [model] { return model->input().engine.cylinders; }),
                   this),
               mostRows, [model](shop::Part part) { return model->columnNote(part); });
    section({});
    line(Theme::baseSize, [model] { return model->weighInText(); });
    addGoal(true);
    addFindings();
    finish();
}

BobMachineSheet::BobMachineSheet(BobWeightsModel* model, QWidget* parent)
    : BobSheet(model, parent) {
    buildPlanes();
    buildRuns();
    addHold([this] { return model_->otherRunText(); }, [this] { model_->confirmReadings(); },
            readings_);
    buildTolerance();
    finish();
}

std::pair<QGridLayout*, TroubleLine*> BobMachineSheet::grid(const QStringList& headings) {
    auto* holder = new QWidget(current());
    auto* made = new QGridLayout(holder);
    made->setContentsMargins(0, 0, 0, 0);
    made->setHorizontalSpacing(Theme::gap);
    made->setVerticalSpacing(Theme::gap);
    current()->addWide(holder);
    auto* trouble = new TroubleLine(current());
    current()->addWide(trouble);
    for (int column = 0; column < headings.size(); ++column) {
        auto* heading = new QLabel(headings.at(column), holder);
        heading->setFont(Theme::font(Theme::smallSize, true));
        heading->setAlignment(Qt::AlignCenter);
        heading->setWordWrap(true);
        made->addWidget(heading, 0, column);
        made->setColumnStretch(column, column == 0 ? 0 : 1);
    }
    return {made, trouble};
}

NumberField* BobMachineSheet::cell(const Field& field, const QString& name, const QString& spoken) {
    auto* made = new NumberField(field, current());
    made->setObjectName(name);
    made->setAccessibleName(spoken);
    made->setOptional(true);
    enlarge(made);
    makeCell(made);
    return made;
}

void BobMachineSheet::buildPlanes() {
    section(tr("Planes"));
    const std::array names{bob_text::planeName(Words(), 0), bob_text::planeName(Words(), 1)};
    const auto sheet = this->grid({QString(), names[0], names[1]});
    QGridLayout* const grid = sheet.first;
    TroubleLine* const trouble = sheet.second;
    std::array<QList<NumberField*>, 2> fields;
    using Value = std::optional<double>;
    const auto row = [&](const char* key, const Field& field, auto get) {
        const int at = grid->rowCount();
        const QString unit = shownUnit(field.unit).name;
        auto* label = new QLabel(titleWithUnit(fieldName(field), unit));
        label->setFont(Theme::font(Theme::smallSize));
        grid->addWidget(label, at, 0);
        for (std::size_t plane = 0; plane < 2; ++plane) {
            const QString name = names[plane] + QStringLiteral(": ") + fieldName(field);
            NumberField* made =
                cell(field, QStringLiteral("%1_%2").arg(QLatin1String(key)).arg(plane + 1), name);
            bind(
                made, field,
                [this, get, plane] {
                    Correction shown = model_->input().correction.value_or(Correction{});
                    shown.planes.resize(2);
                    shown.readings.resize(2);
                    return Value(get(shown, plane));
                },
                [this, get, plane, name](Value value) {
                    model_->editCorrection(
                        name, [&](Correction& correction) { get(correction, plane) = value; });
                });
            trouble->watch(made);
            grid->addWidget(made, at, static_cast<int>(plane) + 1);
            fields[plane] << made;
        }
    };
    row("position", field::plane_position,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].position; });
    row("radius", field::plane_radius,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].radius; });
    row("read_at", field::reading_position,
        [](Correction& c, std::size_t i) -> Value& { return c.readings[i].position; });
    row("from", field::from_angle,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].from_angle; });
    row("to", field::to_angle,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].to_angle; });
    for (const auto& column : fields) {  // Enter goes down the columns, plane by plane
        for (NumberField* field : column) {
            ordered(field);
        }
    }
    QList<QList<QWidget*>> rows;
    for (qsizetype at = 0; at < fields[0].size(); ++at) {
        rows << QList<QWidget*>{fields[0][at], fields[1][at]};
    }
    addGrid(rows);
}

void BobMachineSheet::buildRuns() {
    section(tr("Readings: before, and after each drilling"));
    const Words words;
    const QString unit = words.unit(units::gram_mm);
    const auto [grid, trouble] =
        this->grid({QString(), words.translate("BobWeights", "front, %1").arg(unit),
                    words.translate("BobWeights", "front, °"),
                    words.translate("BobWeights", "rear, %1").arg(unit),
                    words.translate("BobWeights", "rear, °")});
    QList<QList<QWidget*>> rows;
    for (std::size_t run = 0; run < most_runs; ++run) {
        const int at = grid->rowCount();
        auto* label = new QLabel(bob_text::runName(words, run));
        label->setFont(Theme::font(Theme::smallSize));
        grid->addWidget(label, at, 0);
        QList<QWidget*> row{label};
        for (std::size_t plane = 0; plane < 2; ++plane) {
            for (const bool isAngle : {false, true}) {
                const Field& field = isAngle ? field::angle : field::unbalance;
                const QString name = bob_text::runName(words, run) + QStringLiteral(", ") +
                                     bob_text::planeName(words, plane) + QStringLiteral(": ") +
                                     fieldName(field);
                const QString key =
                    QStringLiteral("%1_%2")
                        .arg(isAngle ? QStringLiteral("angle") : QStringLiteral("unbalance"))
                        .arg(plane + 1);
                NumberField* made = ordered(
                    cell(field, run == 0 ? key : QStringLiteral("run_%1_").arg(run) + key, name));
                readings_ << made;
                made->setMinimumWidth(Theme::withText(60));
                if (run > 0) {
                    made->setPlaceholderText({});
                }
                bind(
                    made, field,
                    [this, run, plane, isAngle] { return model_->reading(run, plane, isAngle); },
                    [this, run, plane, isAngle, name](std::optional<double> value) {
                        model_->editReading(name, run, plane, isAngle, value);
                    });
                doubt(made, [this, run, made] {
                    const auto& runs = model_->solution().runs;
                    return run < runs.size() && !runs[run].holds() && made->value();
                });
                if (isAngle) {
                    follow([this, run, plane, made, hint = made->placeholderText()] {
                        const auto unbalance = model_->reading(run, plane, false);
                        const bool isMissing = !unbalance || has_direction(*unbalance);
                        made->setPlaceholderText(isMissing ? hint : QStringLiteral("–"));
                    });
                }
                trouble->watch(made);
                grid->addWidget(made, at, static_cast<int>(2 * plane) + (isAngle ? 2 : 1));
                row << made;
            }
        }
        rows << row.mid(1);
        // One empty line waits for the next run.
        follow([this, row, run] {
            const bool isNext = run == model_->newestRun() + 1 && model_->isRunRead();
            for (QWidget* each : row) {
                each->setVisible(run <= model_->newestRun() || isNext);
            }
        });
    }
    addGrid(rows);
}

void BobMachineSheet::buildTolerance() {
    section(tr("What may remain"));
    auto* own = box(
        QStringLiteral("own_limit"), tr("&A limit of your own for each plane, no grade"),
        tr("On: so much unbalance may remain in each plane. Off: by grade, mass and speed."),
        [this] { return model_->input().tolerance && !model_->input().tolerance->by_grade; },
        [this](bool on) {
            model_->editTolerance(tr("Kind of limit"), [on](Tolerance& it) { it.by_grade = !on; });
        });
    ordered(own);
    number("/tolerance/g_mm");
    grades_ = ordered(new QComboBox(current()));
    grades_->setObjectName(QStringLiteral("grade_list"));
    grades_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const shop::BalanceGrade& grade : shop::balance_grades()) {
        grades_->addItem(QStringLiteral("G %1: %2")
                             .arg(formNumber(grade.mm_per_s, QLocale()), shownText(grade.use)),
                         grade.mm_per_s);
        grades_->setItemData(grades_->count() - 1, shownText(grade.use), Qt::ToolTipRole);
    }
    grades_->setPlaceholderText(tr("grade of your own"));
    enlarge(grades_);
    bind(
        grades_,
        [this] {
            const auto& tolerance = model_->input().tolerance;
            return tolerance && tolerance->by_grade && tolerance->grade
                       ? grades_->findData(from_si(field::grade, *tolerance->grade))
                       : -1;
        },
        [this](int place) {
            model_->editTolerance(fieldName(field::grade), [&](Tolerance& it) {
                it.by_grade = true;
                it.grade = grades_->itemData(place).toDouble() * field::grade.unit;
            });
        });
    wide(grades_, 250);  // beside it stand the widest labels
    current()->addWidget(tr("&For"), grades_, {},
                         tr("Balance quality grades of ISO 21940-11, and what each is for."));
    line(Theme::smallSize, [this] {
        return grades_->currentIndex() < 0
                   ? QString()
                   : grades_->itemData(grades_->currentIndex(), Qt::ToolTipRole).toString();
    });
    number("/tolerance/grade_mm_s");
    doubt(number("/tolerance/rotor_mass_kg"), [this] {
        const auto& limit = model_->input().tolerance;
        return limit && limit->by_grade && shop::is_mass_in_grams(limit->rotor_mass);
    });
    doubt(number("/tolerance/service_speed_rpm"),
          [this] { return shop::is_odd_speed(service_speed(model_->input())); });
    const auto doubtPlace = [this](const char* place, BearingPlaces wrong) {
        doubt(number(place),
              [this, wrong] { return places_of_bearings(model_->input()) == wrong; });
    };
    doubtPlace("/tolerance/centre_of_mass_mm", BearingPlaces::centre_beyond);
    doubtPlace("/tolerance/front_bearing_mm", BearingPlaces::reversed);
    doubtPlace("/tolerance/rear_bearing_mm", BearingPlaces::reversed);
    line(Theme::baseSize, [this] { return model_->limitText(); });
}

BobDrillsSheet::BobDrillsSheet(BobWeightsModel* model, QWidget* parent) : BobSheet(model, parent) {
    section(tr("Drills at hand"));
    numberList(
        field::diameters,
        [this] {
            const auto& correction = model_->input().correction;
            return correction ? correction->drill.diameters_mm : std::vector<double>();
        },
        [this](const QString& name, const std::vector<double>& diameters) {
            model_->editCorrection(
                name, [&](Correction& correction) { correction.drill.diameters_mm = diameters; });
        });
    // How several are written.
    findChild<QLineEdit*>(QString::fromStdString(std::string(field::diameters.key)))
        ->setPlaceholderText(numberListText({8, 10}, field::diameters) + QStringLiteral("; …"));
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
            [this, member] {
                const auto& correction = model_->input().correction;
                return correction && correction->slug ? *correction->slug.*member : std::nullopt;
            },
            [this, member, name = fieldName(field)](std::optional<double> value) {
                model_->editSlug(name, [&](Slug& it) { it.*member = value; });
            });
        made->setObjectName(QStringLiteral("slug_") + made->objectName());
        return made;
    };
    slug(field::slug_diameter, &Slug::diameter);
    NumberField* density = slug(field::slug_density, &Slug::density);
    follow([this, density, needed = density->placeholderText()] {
        const auto& correction = model_->input().correction;
        const bool hasSlugs = correction && correction->slug && correction->slug->diameter;
        density->setPlaceholderText(hasSlugs ? needed : QStringLiteral("–"));
    });
    finish();
}

}  // namespace ravnoves
