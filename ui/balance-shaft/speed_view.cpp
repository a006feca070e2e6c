#include "balance-shaft/speed_view.h"

#include <QComboBox>
#include <QGridLayout>
#include <QImage>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "balance-shaft/buildable_bands.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "model/background_job.h"
#include "plot/plot_view.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/panel.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using balance_shaft::Input;
using balance_shaft::SpeedBand;
using balance_shaft::SpeedStudy;
namespace field = balance_shaft::field;

namespace {

constexpr std::size_t mapAngles = 360;
constexpr int bandSpeeds = 60;

/// A colour of a dark-to-light scale that reads the same in grey, 0…1.
QRgb mapColour(double part) {
    static constexpr std::array<std::array<int, 3>, 5> stops{
        {{48, 18, 92}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
    const double place = std::clamp(part, 0.0, 1.0) * (stops.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double t = place - static_cast<double>(i);
    const auto mix = [&](std::size_t channel) {
        return static_cast<int>(
            std::lround(stops[i][channel] * (1 - t) + stops[i + 1][channel] * t));
    };
    return qRgb(mix(0), mix(1), mix(2));
}

/// The same for what cannot be built: nearer to light grey.
QRgb paled(QRgb colour) {
    const auto mix = [](int channel) { return (channel + 2 * 220) / 3; };
    return qRgb(mix(qRed(colour)), mix(qGreen(colour)), mix(qBlue(colour)));
}

}  // namespace

SpeedView::SpeedView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model), job_(new BackgroundJob(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, Theme::space, 0, 0);
    grid->setSpacing(Theme::space);

    auto* bar = new Panel(this);
    auto* barColumn = new QVBoxLayout(bar);
    barColumn->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    barColumn->setSpacing(Theme::gap);
    auto* sliders = new QHBoxLayout;
    sliders->setSpacing(Theme::margin);
    speed_ = new ValueSlider(tr("Speed &n"), 300.0, 9000.0, 10.0, 100.0, 0, tr("min⁻¹"), bar);
    speed_->setHint(tr("Speed of the engine; the inertia torque of a computed torque follows it."));
    connect(speed_, &ValueSlider::valueEdited, this,
            [this](double value) { model_->setSpeed(value * rpm); });
    sliders->addWidget(speed_, 1);
    load_ = new ValueSlider(tr("&Load, IMEP"), 0.0, 25.0, 0.05, 1.0, 2, tr("bar"), bar);
    load_->setHint(tr("Indicated mean effective pressure of the computed cycle."));
    connect(load_, &ValueSlider::valueEdited, this, [this](double value) {
        model_->drag(tr("Load"), [&](Input& input) {
            input.torque.cycle.imep = value * units::bar;
            input.torque.cycle.heat.reset();
        });
    });
    sliders->addWidget(load_, 1);
    for (ValueSlider* slider : {speed_, load_}) {
        connect(slider, &ValueSlider::released, model_, &SceneModel::finishDrag);
    }
    barColumn->addLayout(sliders);
    auto* study = new QHBoxLayout;
    study->setSpacing(Theme::space);
    from_ = new NumberField(field::band_from, bar);
    to_ = new NumberField(field::band_to, bar);
    from_->setObjectName(QStringLiteral("band_from_rpm"));
    to_->setObjectName(QStringLiteral("band_to_rpm"));
    from_->setAccessibleName(tr("Band from, min⁻¹"));
    to_->setAccessibleName(tr("Band to, min⁻¹"));
    from_->setHint(tr("The lowest speed of the study"));
    to_->setHint(tr("The highest speed of the study"));
    auto* trouble = new TroubleLine(bar);
    for (NumberField* numberField : {from_, to_}) {
        numberField->setMaximumWidth(64);
        numberField->setDigits(6);
        numberField->setModel(model_);
        trouble->watch(numberField);
        connect(numberField, &NumberField::valueEdited, this,
                [this, numberField](std::optional<double> value) {
                    model_->edit(tr("Speed band"), [&](Input& input) {
                        SpeedBand band = this->band();
                        (numberField == from_ ? band.from : band.to) = *value * rpm;
                        input.speed_band = band;
                    });
                });
    }
    const auto addLabelled = [&](const QString& text, QWidget* widget) {
        auto* label = new QLabel(text, bar);
        label->setBuddy(widget);
        study->addWidget(label);
        study->addWidget(widget);
    };
    addLabelled(tr("&Band"), from_);
    addLabelled(tr("&to"), to_);
    study->addWidget(new QLabel(tr("min⁻¹"), bar));
    criterion_ = new QComboBox(bar);
    criterion_->addItems({tr("range"), tr("RMS")});
    criterion_->setAccessibleName(tr("Criterion of the map"));
    criterion_->setToolTip(tr("What the map shows and the least bad α makes least"));
    addLabelled(tr("&Map of"), criterion_);
    connect(criterion_, &QComboBox::activated, this, &SpeedView::showStudy);
    progress_ = new QProgressBar(bar);
    progress_->setRange(0, 100);
    progress_->setMaximumWidth(90);
    progress_->setTextVisible(false);
    cancel_ = new QPushButton(tr("Cancel"), bar);
    study->addStretch();
    study->addWidget(progress_);
    study->addWidget(cancel_);
    barColumn->addLayout(study);
    barColumn->addWidget(trouble);
    grid->addWidget(bar, 0, 0, 1, 2);

    angles_ = new PlotView(tr("Best α over speed"), this);
    angles_->setYAxis(PlotView::Side::Left, {tr("α, °")});
    angles_->setYRange(PlotView::Side::Left, 0.0, 360.0);
    rangeAngle_ = angles_->addCurve({.name = tr("range"),
                                     .colour = 2,
                                     .width = 1.8,
                                     .toolTip = tr("α of the least range at each speed")});
    rmsAngle_ = angles_->addCurve({.name = tr("RMS"),
                                   .colour = 3,
                                   .width = 1.8,
                                   .toolTip = tr("α of the least RMS at each speed")});
    map_ = new PlotView(tr("Map over α and speed"), this);
    map_->setXAxis({tr("α, °"), 0.0, 360.0, true});
    map_->setYAxis(PlotView::Side::Left, {tr("n, min⁻¹")});
    map_->setPickable(true);
    bestLine_ = map_->addCurve({.name = tr("best α"), .colour = 7, .width = 2.0});
    connect(map_, &PlotView::pickedAt, this, [this](double angle, double speed) {
        model_->setShaftAngleDeg(std::round(angle * 10.0) / 10.0);
        if (model_->input().torque.is_computed()) {
            model_->setSpeed(std::round(speed / 10.0) * 10.0 * rpm);
        }
    });
    grid->addWidget(angles_, 1, 0);
    grid->addWidget(map_, 1, 1);

    auto* panel = new Panel(this);
    auto* row = new QHBoxLayout(panel);
    row->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    answer_ = new QLabel(panel);
    answer_->setWordWrap(true);
    answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(answer_, 1);
    goLeastBad_ = new QPushButton(tr("Go"), panel);
    goLeastBad_->setMaximumWidth(52);
    goLeastBad_->setAccessibleName(tr("Go to the α that is least bad over the band"));
    goLeastBad_->setToolTip(goLeastBad_->accessibleName());
    row->addWidget(goLeastBad_);
    grid->addWidget(panel, 2, 0, 1, 2);
    grid->setRowStretch(1, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);

    connect(goLeastBad_, &QPushButton::clicked, this, [this] {
        const auto& best = criterion_->currentIndex() == 0 ? study_.range : study_.rms;
        model_->finishDrag();
        model_->setShaftAngleDeg(best.shaft_angle / degree);
        model_->finishDrag();
    });
    connect(cancel_, &QPushButton::clicked, this, [this] {
        job_->cancel();
        answer_->setText(tr("Cancelled. Any change of the input solves again."));
    });
    connect(job_, &BackgroundJob::progress, this,
            [this](double part) { progress_->setValue(static_cast<int>(100.0 * part)); });
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) {
        study_ = {};
        showStudy();
        answer_->setText(why);
    });
    connect(job_, &BackgroundJob::runningChanged, this, [this](bool running) {
        progress_->setVisible(running);
        cancel_->setVisible(running);
    });
    progress_->hide();
    cancel_->hide();
    connect(model_, &SceneModel::changed, this, [this] {
        stale_ = true;
        if (isVisible()) {
            showInput();
            solveAgain();
        }
    });
    connect(model_, &BalanceShaftModel::shaftMoved, this,
            [this] { map_->setPresentX(model_->shaftAngleDeg()); });
    connect(&Theme::instance(), &Theme::changed, this, &SpeedView::showStudy);
}

void SpeedView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showInput();
    if (stale_) {
        solveAgain();
    }
}

SpeedBand SpeedView::band() const {
    if (model_->input().speed_band) {
        return *model_->input().speed_band;
    }
    // From idling to a little above the speed entered.
    SpeedBand band;
    band.from = 0.3 * model_->input().angular_speed;
    band.to = 1.1 * model_->input().angular_speed;
    band.speeds = bandSpeeds;
    return band;
}

void SpeedView::showInput() {
    const Input& input = model_->input();
    const SpeedBand shown = band();
    from_->setValue(from_si(field::band_from, shown.from));
    to_->setValue(from_si(field::band_to, shown.to));
    const double speed = input.angular_speed / rpm;
    speed_->setRange(std::min(300.0, std::floor(speed)), std::max(9000.0, std::ceil(speed)));
    speed_->setValue(speed);
    const bool cycle = input.torque.kind == balance_shaft::TorqueSource::Kind::cycle;
    load_->setEnabled(cycle);
    load_->setToolTip(cycle ? QString()
                            : tr("The load can be moved when the torque is a computed "
                                 "cycle (Torque tab)."));
    if (cycle && model_->result().indicated) {
        load_->setValue(std::clamp(model_->result().indicated->imep / units::bar, 0.0, 25.0));
    }
    map_->setPresentX(model_->shaftAngleDeg());
}

void SpeedView::solveAgain() {
    stale_ = false;
    Input input = model_->input();
    input.shaft_angle = 0.0;  // the study does not depend on it
    if (solvedInput_ && *solvedInput_ == input && study_.study) {
        return;
    }
    const SpeedBand range = band();
    job_->start([this, input, range](const BackgroundJob::Progress& progress) {
        auto result = std::make_shared<Study>();
        auto study = std::make_shared<SpeedStudy>(
            input, range, [&](double part) { return progress(0.3 * part); });
        if (study->reason().empty() && study->is_complete()) {
            result->map =
                study->map(mapAngles, [&](double part) { return progress(0.3 + 0.6 * part); });
            using Criterion = SpeedStudy::Criterion;
            constexpr auto relative = SpeedStudy::Measure::relative;
            result->range = study->least_bad_angle(Criterion::range, relative);
            result->rms = study->least_bad_angle(Criterion::rms, relative);
            result->rangeOfAll = result->range;
            result->rmsOfAll = result->rms;
            const auto& buildable = study->buildable().stretches;
            if (!buildable.empty()) {
                result->range = study->least_bad_angle(Criterion::range, relative, buildable);
                result->rms = study->least_bad_angle(Criterion::rms, relative, buildable);
            }
        }
        result->study = std::move(study);
        return [this, result, input] {
            study_ = *result;
            solvedInput_ = input;
            showStudy();
        };
    });
}

void SpeedView::showStudy() {
    const bool made = study_.study != nullptr && study_.study->reason().empty() && study_.map;
    goLeastBad_->setEnabled(made);
    if (!made) {
        for (const int curve : {rangeAngle_, rmsAngle_}) {
            angles_->setCurve(curve, {}, {});
        }
        map_->setCurve(bestLine_, {}, {});
        map_->setImage({}, {});
        map_->setBands({});
        angles_->setBands({});
        const SpeedBand asked = band();
        angles_->setXAxis({tr("n, min⁻¹"), asked.from / rpm, asked.to / rpm});
        map_->setYRange(PlotView::Side::Left, asked.from / rpm, asked.to / rpm);
        if (study_.study != nullptr && !study_.study->reason().empty()) {
            answer_->setText(messageText(study_.study->reason()) + QLatin1Char(' ') +
                             tr("Rebuild the torque (Torque tab) or choose a pressure trace or a "
                                "computed cycle."));
        }
        return;
    }
    std::vector<double> speed;
    std::vector<double> rangeAngle;
    std::vector<double> rmsAngle;
    for (const SpeedStudy::Point& point : study_.study->points()) {
        speed.push_back(point.angular_speed / rpm);
        rangeAngle.push_back(point.buildable_range_angle.value_or(point.best_range_angle) / degree);
        rmsAngle.push_back(point.buildable_rms_angle.value_or(point.best_rms_angle) / degree);
    }
    const bool byRange = criterion_->currentIndex() == 0;
    angles_->setXAxis({tr("n, min⁻¹"), speed.front(), speed.back()});
    angles_->setCurve(rangeAngle_, speed, rangeAngle);
    angles_->setCurve(rmsAngle_, speed, rmsAngle);
    const SpeedStudy::LeastBad& best = byRange ? study_.range : study_.rms;
    const QLocale locale;
    angles_->setLines({{best.shaft_angle / degree, Qt::Horizontal, 7,
                        tr("least bad %1°").arg(fixedNumber(best.shaft_angle / degree, 1, locale)),
                        PlotView::Side::Left}});
    angles_->setBands(unbuildableBands(study_.study->buildable(), Qt::Vertical));
    map_->setBands(unbuildableBands(study_.study->buildable()));
    map_->setYRange(PlotView::Side::Left, speed.front(), speed.back());
    map_->setCurve(bestLine_, byRange ? rangeAngle : rmsAngle, speed);
    showMap();
    const double change = 100.0 * (best.value - 1.0);
    const SpeedStudy::LeastBad& ofAll = byRange ? study_.rangeOfAll : study_.rmsOfAll;
    QString other;
    if (study_.study->buildable().stretches.empty()) {
        other = tr(" But nothing can be built.");
    } else if (best.value > ofAll.value + 1e-6) {
        other = tr(" %1° would gain %2 % more but cannot be built.")
                    .arg(fixedNumber(ofAll.shaft_angle / degree, 1, locale),
                         fixedNumber(100.0 * (best.value - ofAll.value), 1, locale));
    }
    answer_->setText(
        tr("Least bad α over the band, by the %1 against the engine without a shaft: %2°. At its "
           "worst speed, %3 min⁻¹, the %1 is %4 % %5.")
            .arg(byRange ? tr("range") : tr("RMS"),
                 fixedNumber(best.shaft_angle / degree, 1, locale),
                 fixedNumber(best.worst_speed / rpm, 0, locale),
                 fixedNumber(std::abs(change), 1, locale),
                 change > 0.0 ? tr("larger") : tr("smaller")) +
        other);
}

void SpeedView::showMap() {
    const bool byRange = criterion_->currentIndex() == 0;
    const std::vector<double>& values = byRange ? study_.map->range : study_.map->rms;
    const auto angles = static_cast<int>(study_.map->shaft_angle_deg.size());
    const auto speeds = static_cast<int>(study_.study->points().size());
    const auto cell = [angles](int speed, int angle) {
        return static_cast<std::size_t>(speed) * static_cast<std::size_t>(angles) +
               static_cast<std::size_t>(angle);
    };
    // Each speed against the engine without a shaft there, or the high speeds would drown the rest.
    std::vector<double> relative(values.size());
    for (int s = 0; s < speeds; ++s) {
        const SpeedStudy::Point& point = study_.study->points()[static_cast<std::size_t>(s)];
        const double without = byRange ? point.range_without : point.rms_without;
        for (int a = 0; a < angles; ++a) {
            const auto i = cell(s, a);
            relative[i] = without > 0.0 ? values[i] / without : 1.0;
        }
    }
    const auto [least, most] = std::minmax_element(relative.begin(), relative.end());
    const double span = std::max(*most - *least, 1e-12);
    std::vector<bool> canBuild;
    for (const double angle : study_.map->shaft_angle_deg) {
        canBuild.push_back(study_.study->buildable().contains(angle * degree));
    }
    QImage image(angles, speeds, QImage::Format_RGB32);
    for (int s = 0; s < speeds; ++s) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(speeds - 1 - s));
        for (int a = 0; a < angles; ++a) {
            const QRgb colour = mapColour((relative[cell(s, a)] - *least) / span);
            line[a] = canBuild[static_cast<std::size_t>(a)] ? colour : paled(colour);
        }
    }
    const auto& points = study_.study->points();
    const double from = points.front().angular_speed / rpm;
    const double to = points.back().angular_speed / rpm;
    map_->setImage(image, QRectF(0.0, from, 360.0, to - from));
    const QLocale locale;
    map_->setTitle(tr("%1 ÷ without: %2…%3")
                       .arg(byRange ? tr("Range") : tr("RMS"), fixedNumber(*least, 2, locale),
                            fixedNumber(*most, 2, locale)));
    map_->setToolTip(
        tr("The criterion with the shaft over that without it at the same speed; dark "
           "is small, light is large. Click to set α and, with a computed torque, the "
           "speed."));
}

QString SpeedView::answer() const {
    return answer_->text();
}

}  // namespace ravnoves
