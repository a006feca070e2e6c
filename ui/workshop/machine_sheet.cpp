#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <utility>

#include "bob-weights/fields.h"
#include "model/editable_table.h"
#include "shop/balance_grade.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "workshop/fields.h"
#include "workshop/sheets.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

/// "left / right" as two names; empty where they are not two.
QString planeNames(const QString& typed) {
    QString text = typed;
    const QStringList names = text.replace(QLatin1Char(','), QLatin1Char('/'))
                                  .replace(QLatin1Char(';'), QLatin1Char('/'))
                                  .split(QLatin1Char('/'));
    return names.size() == 2 && !names[0].trimmed().isEmpty() && !names[1].trimmed().isEmpty()
               ? names[0].trimmed() + QStringLiteral(" / ") + names[1].trimmed()
               : QString();
}

}  // namespace

MachineSheet::MachineSheet(WorkshopModel* model, QWidget* parent) : WorkshopSheet(model, parent) {
    buildRuns();
    // Beside the readings: by another convention a hole is drilled on the wrong side.
    QLabel* convention = line(Theme::baseSize, [this] { return model_->machineText(); });
    convention->setObjectName(QStringLiteral("machine_convention"));
    addHold();
    buildPlanes();
    buildTolerance();
    buildMachine();
    finish();
}

QWidget* MachineSheet::nextReading() const {
    const auto next = std::find_if(readings_.begin(), readings_.end(), [](NumberField* each) {
        return !each->isHidden() && each->isEnabled() && !each->value();
    });
    return next == readings_.end() ? readings_.first() : *next;
}

/// Headings of columns that are of planes follow their names: first those of the front plane.
void MachineSheet::followNames(QGridLayout* grid, const QStringList& units) {
    follow([this, grid, units] {
        for (qsizetype i = 0; i < 2 * units.size(); ++i) {
            auto* heading =
                static_cast<QLabel*>(grid->itemAtPosition(0, static_cast<int>(i) + 1)->widget());
            const QString name = model_->planeName(static_cast<std::size_t>(i / units.size()));
            heading->setText(titleWithUnit(name, units[i % units.size()]));
        }
    });
}

bool MachineSheet::isDoubtful() const {
    return !model_->otherRunText().isEmpty();
}

/// What is wrong with readings, and a button that says that they hold for the crankshaft and the
/// bob weight of now.
void MachineSheet::addHold() {
    QLabel* said = line(Theme::baseSize, [this] { return model_->otherRunText(); });
    said->setObjectName(QStringLiteral("other_bob_weight"));
    colourText(said, &Theme::warning);
    hold_ = button("readings_hold", tr("Readings are still &valid"),
                   tr("The readings are of this crankshaft, with the present bob weight."), [this] {
                       // The button goes with what it says: under the focus it would hand it on to
                       // what follows, and the sheet would scroll there.
                       nextReading()->setFocus(Qt::OtherFocusReason);
                       model_->confirmReadings();
                       if (hold_->isVisible()) {
                           hold_->setFocus(Qt::OtherFocusReason);  // others do not hold
                       }
                   });
    showWhile(hold_, [this] { return isDoubtful(); });
}

void MachineSheet::buildPlanes() {
    section(tr("Planes"));
    const auto sheet = this->grid({QString(), QString(), QString()});
    followNames(sheet.first, {QString()});
    QGridLayout* const grid = sheet.first;
    TroubleLine* const trouble = sheet.second;
    std::array<QList<NumberField*>, 2> fields;
    using Value = std::optional<double>;
    const auto row = [&](const char* key, const char* list, const Field& field, auto get) {
        const int at = grid->rowCount();
        const QString unit = shownUnit(field.unit).name;
        auto* label = new QLabel(titleWithUnit(fieldName(field), unit));
        label->setFont(Theme::font(Theme::smallSize));
        grid->addWidget(label, at, 0);
        for (std::size_t plane = 0; plane < 2; ++plane) {
            const auto name = [this, plane, &field](const Words& words) {
                return model_->planeName(plane, words) + QStringLiteral(": ") + words.name(field);
            };
            NumberField* made =
                cell(field, QStringLiteral("%1_%2").arg(QLatin1String(key)).arg(plane + 1), name,
                     [place = list + std::to_string(plane) + '/' + std::string(field.key)] {
                         return place;
                     });
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
                        name({}), [&](Correction& correction) { get(correction, plane) = value; });
                });
            trouble->watch(made);
            grid->addWidget(made, at, static_cast<int>(plane) + 1);
            fields[plane] << made;
        }
    };
    const char* const planes = "/correction/planes/";
    row("position", planes, field::plane_position,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].position; });
    row("radius", planes, field::plane_radius,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].radius; });
    row("read_at", "/correction/readings/", field::reading_position,
        [](Correction& c, std::size_t i) -> Value& { return c.readings[i].position; });
    row("from", planes, field::from_angle,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].from_angle; });
    row("to", planes, field::to_angle,
        [](Correction& c, std::size_t i) -> Value& { return c.planes[i].to_angle; });
    for (const auto& column : fields) {
        // Half a sector is not the whole rim.
        follow([from = column[column.size() - 2], to = column.last(),
                rim = column.last()->placeholderText()] {
            const QString shown = from->value() || to->value() ? QString() : rim;
            from->setPlaceholderText(shown);
            to->setPlaceholderText(shown);
        });
        for (NumberField* field : column) {  // Enter goes down the columns, plane by plane
            ordered(field);
        }
    }
    followArrows(grid);
}

void MachineSheet::buildRuns() {
    using Shows = workshop::Machine::Shows;
    section(tr("Readings: before, and after each drilling"));
    const Words words;
    const QString unit = words.unit(units::gram_mm);
    const QString degrees = QStringLiteral("°");
    const auto [grid, trouble] = this->grid({QString(), unit, degrees, unit, degrees});
    followNames(grid, {unit, degrees});
    for (std::size_t run = 0; run < max_runs; ++run) {
        const int at = grid->rowCount();
        auto* label = new QLabel(WorkshopModel::runName(words, run));
        label->setFont(Theme::font(Theme::smallSize));
        grid->addWidget(label, at, 0);
        QList<QWidget*> row{label};
        for (std::size_t plane = 0; plane < 2; ++plane) {
            for (const bool isAngle : {false, true}) {
                const Field& field = isAngle ? field::angle : field::unbalance;
                const auto name = [this, run, plane, isAngle](const Words& words) {
                    return WorkshopModel::runName(words, run) + QStringLiteral(", ") +
                           model_->planeName(plane, words) + QStringLiteral(": ") +
                           (isAngle ? model_->spotName(words) : words.name(field::unbalance));
                };
                const QString key =
                    QStringLiteral("%1_%2")
                        .arg(isAngle ? QStringLiteral("angle") : QStringLiteral("unbalance"))
                        .arg(plane + 1);
                NumberField* made = ordered(
                    cell(field, run == 0 ? key : QStringLiteral("run_%1_").arg(run) + key, name,
                         [this, run, plane, &field] {
                             return model_->readingPlace(run, plane) + std::string(field.key);
                         }));
                readings_ << made;
                if (!isAngle) {
                    made->setLever([this, plane]() -> std::optional<double> {
                        const auto& correction = model_->input().correction;
                        return correction && plane < correction->planes.size()
                                   ? correction->planes[plane].radius
                                   : std::nullopt;
                    });
                }
                made->setMinimumWidth(Theme::withText(60));
                if (run > 0) {
                    made->setPlaceholderText({});
                }
                const auto read = [this, run, plane, isAngle] {
                    const Reading reading = model_->reading(run, plane);
                    return isAngle ? reading.angle : reading.unbalance;
                };
                bind(made, field, read,
                     [this, run, plane, isAngle, name](std::optional<double> value) {
                         model_->editReading(name({}), run, plane, isAngle, value);
                     });
                // What is typed again is read again, be it the same number.
                connect(made, &QLineEdit::textEdited, this, [=, this] {
                    if (made->isDoubtful() && made->trouble().isEmpty()) {
                        model_->editReading(name({}), run, plane, isAngle, read());
                    }
                });
                doubt(made, [this, run, made] {
                    const RunResult* result = model_->runResult(run);
                    return result != nullptr && !result->holds() && made->value();
                });
                if (isAngle) {
                    follow([this, run, plane, made, empty = made->placeholderText()] {
                        const auto unbalance = model_->reading(run, plane).unbalance;
                        const bool isMissing = !unbalance || has_direction(*unbalance);
                        made->setPlaceholderText(isMissing ? empty : QStringLiteral("–"));
                    });
                    follow([this, made, was = Shows::heavy]() mutable {
                        const Shows shows = model_->input().machine.shows;
                        if (std::exchange(was, shows) != shows) {
                            made->setHint(fieldHint(shows == Shows::light ? workshop::field::shows
                                                                          : field::angle));
                        }
                    });
                }
                trouble->watch(made);
                grid->addWidget(made, at, static_cast<int>(2 * plane) + (isAngle ? 2 : 1));
                row << made;
            }
        }
        // One empty line waits for the next run; those of two runs keep their place.
        follow([this, row, run] {
            constexpr std::size_t always = 2;
            const bool isFollowed =
                model_->isPlanned() || (model_->isRunRead() && model_->withheld().any());
            const bool isOpen = run <= model_->newestRun() + (isFollowed ? 1 : 0);
            for (QWidget* each : row) {
                each->setEnabled(isOpen);
                each->setVisible(isOpen || run <= always);
            }
        });
    }
    followArrows(grid);
}

void MachineSheet::buildTolerance() {
    section(tr("Permissible residual"));
    box(
        QStringLiteral("own_limit"), tr("&Own limit for each plane, instead of a grade"),
        tr("On: permissible residual in each plane. Off: by grade, mass and speed."),
        [this] { return model_->input().tolerance && !model_->input().tolerance->by_grade; },
        [this](bool on) {
            model_->editTolerance(tr("Kind of limit"), [on](Tolerance& it) { it.by_grade = !on; });
        });
    number("/tolerance/g_mm")->setLever([this]() -> std::optional<double> {
        const auto& correction = model_->input().correction;
        const bool isOne = correction && correction->planes.size() == 2 &&
                           correction->planes[0].radius == correction->planes[1].radius;
        return isOne ? correction->planes[0].radius : std::nullopt;
    });
    QComboBox* grades = ordered(new QComboBox(current()));
    grades->setObjectName(QStringLiteral("grade_list"));
    grades->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const shop::BalanceGrade& grade : shop::balance_grades()) {
        grades->addItem(QStringLiteral("G %1: %2")
                            .arg(formNumber(grade.mm_per_s, QLocale()), shownText(grade.use)),
                        grade.mm_per_s);
        grades->setItemData(grades->count() - 1, shownText(grade.use), Qt::ToolTipRole);
    }
    grades->setPlaceholderText(tr("own grade"));
    enlarge(grades);
    bind(
        grades,
        [this, grades] {
            const auto& tolerance = model_->input().tolerance;
            return tolerance && tolerance->by_grade && tolerance->grade
                       ? grades->findData(from_si(field::grade, *tolerance->grade))
                       : -1;
        },
        [this, grades](int place) {
            model_->editTolerance(fieldName(field::grade), [&](Tolerance& it) {
                it.by_grade = true;
                it.grade = grades->itemData(place).toDouble() * field::grade.unit;
            });
        });
    wide(grades, 250);  // beside it stand the widest labels
    current()->addWidget(tr("&For"), grades, {},
                         tr("Balance quality grades of ISO 21940-11 and their uses."));
    number("/tolerance/grade_mm_s");
    doubt(number("/tolerance/rotor_mass_kg"), "rotor-mass");
    doubt(number("/tolerance/service_speed_rpm"), "service-speed");
    const auto doubtPlace = [this](const char* place, BearingPlaces wrong) {
        doubt(number(place),
              [this, wrong] { return places_of_bearings(model_->input()) == wrong; });
    };
    doubtPlace("/tolerance/centre_of_mass_mm", BearingPlaces::centre_beyond);
    doubtPlace("/tolerance/front_bearing_mm", BearingPlaces::reversed);
    doubtPlace("/tolerance/rear_bearing_mm", BearingPlaces::reversed);
    number("/tolerance/front_share");
}

/// How the balancing machine is set up.
void MachineSheet::buildMachine() {
    section(tr("Balancing machine"));
    checked(
        workshop::field::plane_names,
        {planeNames, [](const QString&) { return tr("Type two names, such as left / right."); },
         [this] {
             const auto& names = model_->input().machine.planes;
             return planeNames(QString::fromStdString(names[0]) + QLatin1Char('/') +
                               QString::fromStdString(names[1]));
         },
         [this](const QString& step, const QString& typed) {
             const QStringList names = typed.split(QStringLiteral(" / "));
             model_->edit(step, [&](workshop::Input& job) {
                 job.machine.planes = {names.value(0).toStdString(), names.value(1).toStdString()};
             });
         }});
    wide(choice("/machine/counts"), 240);
    wide(choice("/machine/shows"), 240);
    text("/machine/zero");
    QPushButton* keep =
        button("keep_machine", tr("Save as shop default (&machine)"),
               tr("New jobs begin with this set-up."), [this] { model_->keepMachine(); });
    showWhile(keep, [this] { return !model_->isShopsMachine(); });
}

}  // namespace ravnoves
