#include "elastic-hinge/hinge_plots.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "elastic-hinge/rod_hinge_moment.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/panel.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Guide;
using elastic_hinge::GuidePoint;
using elastic_hinge::Hinge;
using elastic_hinge::Kinematics;
using elastic_hinge::MechanismCurves;
using elastic_hinge::Motion;
using elastic_hinge::PlanePoint;
using elastic_hinge::Result;

namespace {

constexpr double mm = 1e3;
constexpr double um = 1e6;

QString number(double value, int digits = 4) {
    return formNumber(value, QLocale(), digits);
}

}  // namespace

PlotView::CurveStyle HingePlots::profileStyle(const QString& name) {
    return {.name = name,
            .colour = 3,
            .width = 1.4,
            .toolTip = tr("What the roller touches: the path of its centre offset by its radius")};
}

HingePlots::HingePlots(ElasticHingeModel* model, QWidget* parent)
    : QTabWidget(parent), model_(model) {
    setDocumentMode(true);
    addTab(buildGuides(), tr("&Guides"));
    addTab(buildRodHinge(), tr("R&od hinge"));
    addTab(buildSideForce(), tr("Sid&e force"));
    addTab(buildCrankMoment(), tr("Crank &moment"));
    addTab(buildMotion(), tr("Mo&tion"));
    for (PlotView* plot : plots()) {
        if (plot != guide_ && plot != speed_) {
            connect(plot, &PlotView::cursorMoved, model_, [this](double phi) {
                model_->setMotionTime(std::nullopt);
                model_->setCrankAngleDeg(phi);
            });
        }
    }
    connect(this, &QTabWidget::currentChanged, this, &HingePlots::refresh);
    connect(model_, &SceneModel::changed, this, &HingePlots::refresh);
    connect(model_, &ElasticHingeModel::viewChanged, this, &HingePlots::refresh);
    connect(model_, &ElasticHingeModel::motionsChanged, this, [this] {
        if (currentWidget()->objectName() == QLatin1String("motion")) {
            showMotion();
        }
    });
    connect(model_, &ElasticHingeModel::crankAngleChanged, this, &HingePlots::showPresent);
    refresh();
}

QList<PlotView*> HingePlots::plots() const {
    return {guide_,      relief_,      rodMoment_,   rodSpeeds_, sideLambdas_,
            sideSpeeds_, crankMoment_, crankSpeeds_, speed_};
}

QList<PlotView*> HingePlots::frontPlots() const {
    return currentWidget()->findChildren<PlotView*>();
}

void HingePlots::resetZoom() {
    for (PlotView* plot : plots()) {
        plot->resetZoom();
    }
}

PlotView* HingePlots::makePlot(const QString& title, QWidget* parent) {
    auto* plot = new PlotView(title, parent);
    plot->setXAxis({tr("φ, °"), 0.0, 360.0, true});
    return plot;
}

HingePlots::Pieces HingePlots::addPieces(PlotView* plot, const PlotView::CurveStyle& style) {
    Pieces pieces;
    for (std::size_t i = 0; i < Pieces::most; ++i) {
        PlotView::CurveStyle own = style;
        own.inLegend = style.inLegend && i == 0;
        pieces.curves[i] = plot->addCurve(own);
    }
    // All pieces go with the one in the legend.
    connect(plot, &PlotView::curveToggled, plot, [plot, pieces](int curve, bool shown) {
        if (curve == pieces.curves[0]) {
            for (std::size_t i = 1; i < Pieces::most; ++i) {
                plot->setCurveShown(pieces.curves[i], shown);
            }
        }
    });
    return pieces;
}

void HingePlots::setPieces(PlotView* plot, const Pieces& pieces, const std::vector<double>& x,
                           const std::vector<double>& y, bool closed) {
    // The runs of finite points.
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    const std::size_t n = std::min(x.size(), y.size());
    for (std::size_t i = 0; i < n; ++i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
            continue;
        }
        if (runs.empty() || runs.back().second != i) {
            runs.emplace_back(i, i);
        }
        runs.back().second = i + 1;
    }
    std::vector<std::pair<std::vector<double>, std::vector<double>>> curves;
    for (const auto& [from, to] : runs) {
        const auto a = static_cast<std::ptrdiff_t>(from);
        const auto b = static_cast<std::ptrdiff_t>(to);
        curves.emplace_back(std::vector(x.begin() + a, x.begin() + b),
                            std::vector(y.begin() + a, y.begin() + b));
    }
    // In a closed curve the last run goes on in the first.
    if (closed && runs.size() > 1 && runs.front().first == 0 && runs.back().second == n) {
        auto& [firstX, firstY] = curves.front();
        auto& [lastX, lastY] = curves.back();
        lastX.insert(lastX.end(), firstX.begin(), firstX.end());
        lastY.insert(lastY.end(), firstY.begin(), firstY.end());
        curves.erase(curves.begin());
    }
    for (std::size_t i = 0; i < Pieces::most; ++i) {
        if (i < curves.size()) {
            plot->setCurve(pieces.curves[i], std::move(curves[i].first),
                           std::move(curves[i].second));
        } else {
            plot->setCurve(pieces.curves[i], {}, {});
        }
    }
}

HingePlots::Family HingePlots::addFamily(PlotView* plot) {
    Family family;
    for (std::size_t i = 0; i < Family::most; ++i) {
        family.curves[i] = plot->addCurve(
            {.name = QString(), .colour = static_cast<int>(i + 1), .width = 1.4, .shown = false});
    }
    return family;
}

QWidget* HingePlots::makeTab(const QString& name, QWidget* bar, PlotView* upper, int upperShare,
                             PlotView* lower, int lowerShare) {
    auto* page = new QWidget(this);
    page->setObjectName(name);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, Theme::gap, 0, 0);
    column->setSpacing(Theme::space);
    if (bar != nullptr) {
        column->addWidget(bar);
    }
    column->addWidget(upper, upperShare);
    if (lower != nullptr) {
        column->addWidget(lower, lowerShare);
    }
    return page;
}

// ---------------------------------------------------------------------------------------- build

QWidget* HingePlots::buildGuides() {
    auto* bar = new Panel(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    row->setSpacing(Theme::space);
    hingeChoice_ = new QComboBox(bar);
    hingeChoice_->setObjectName(QStringLiteral("guide_shown"));
    hingeChoice_->addItems({tr("crank, for M"), tr("crank, for M₁"), tr("rod, for M₁₂")});
    hingeChoice_->setAccessibleName(tr("Which guide is shown"));
    hingeChoice_->setToolTip(
        tr("The hinge between frame and crank alone (M), the same beside the rod's hinge (M₁), or "
           "the hinge between crank and rod, whose guide goes by θ = φ + ψ"));
    connect(hingeChoice_, &QComboBox::activated, this,
            [this](int index) { model_->setShownHinge(static_cast<Hinge>(index)); });
    row->addWidget(hingeChoice_);
    exaggeration_ = new ValueSlider(tr("&Relief ×"), 1.0, 1e5, 1.0, 10.0, 0, {}, bar);
    exaggeration_->setLogarithmic(12, 2);
    exaggeration_->slider()->setObjectName(QStringLiteral("exaggeration_slider"));
    exaggeration_->setHint(
        tr("The pictures enlarge the guide's relief by this factor; 1 is to scale"));
    connect(exaggeration_, &ValueSlider::valueEdited, this,
            [this](double factor) { model_->setExaggeration(factor); });
    row->addWidget(exaggeration_, 1);
    automatic_ = new QCheckBox(tr("a&uto"), bar);
    automatic_->setObjectName(QStringLiteral("exaggeration_auto"));
    automatic_->setToolTip(tr("Choose the factor by the relief"));
    connect(automatic_, &QCheckBox::clicked, this, [this](bool on) {
        model_->setExaggeration(on ? std::nullopt : std::optional(model_->exaggeration()));
    });
    row->addWidget(automatic_);

    guide_ = makePlot(tr("Guides"), this);
    guide_->setEqualScale(true);
    guide_->setXAxis({tr("x, mm"), -130.0, 130.0});
    guide_->setYAxis(PlotView::Side::Left, {tr("y, mm")});
    circleCompressed_ =
        guide_->addCurve({.name = tr("ρ₀"), .colour = 0, .width = 1.0, .inLegend = false});
    circleStretched_ =
        guide_->addCurve({.name = tr("ℓ₀ − ρ₀"), .colour = 0, .width = 1.0, .inLegend = false});
    profile_ = addPieces(guide_, profileStyle({}));
    guideCompressed_ =
        addPieces(guide_, {.name = tr("compressed"),
                           .colour = 2,
                           .width = 1.8,
                           .toolTip = tr("Guide of the compressed spring, minus in (3)")});
    guideStretched_ =
        addPieces(guide_, {.name = tr("stretched"),
                           .colour = 1,
                           .width = 1.8,
                           .toolTip = tr("Guide of the stretched spring, plus in (3)")});

    relief_ = makePlot(tr("ρ over the turn, from its value at 0°"), this);
    reliefCompressed_ = addPieces(relief_, {.name = tr("compressed"), .colour = 2, .width = 1.8});
    reliefStretched_ = addPieces(relief_, {.name = tr("stretched"), .colour = 1, .width = 1.4});
    return makeTab(QStringLiteral("guides"), bar, guide_, 5, relief_, 3);
}

QWidget* HingePlots::buildRodHinge() {
    rodMoment_ = makePlot(tr("M₁₂ and its potential part"), this);
    rodMoment_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    m12_ = rodMoment_->addCurve({.name = tr("M₁₂"),
                                 .colour = 2,
                                 .width = 1.8,
                                 .toolTip = tr("Moment on the rod that makes the side force zero, "
                                               "(4), with a counterweight (9)")});
    m12Potential_ = rodMoment_->addCurve({.name = tr("potential part"),
                                          .colour = 1,
                                          .width = 1.6,
                                          .pen = Qt::DashLine,
                                          .toolTip = tr("M₁₂ less its mean, (5)")});
    m12Other_ =
        rodMoment_->addCurve({.name = tr("series"),
                              .colour = 4,
                              .width = 1.4,
                              .pen = Qt::DotLine,
                              .toolTip = tr("M₁₂ by the other kinematics, for comparison")});
    rodSpeeds_ = makePlot(tr("M₁₂ at several ω"), this);
    rodSpeeds_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    m12Speeds_ = addFamily(rodSpeeds_);
    return makeTab(QStringLiteral("rod-hinge"), nullptr, rodMoment_, 1, rodSpeeds_, 1);
}

QWidget* HingePlots::buildSideForce() {
    sideLambdas_ = makePlot(tr("Side force with rod hinge, several λ"), this);
    sideLambdas_->setYAxis(PlotView::Side::Left, {tr("N")});
    withLambdas_ = addFamily(sideLambdas_);
    sideSpeeds_ = makePlot(tr("Side force without hinge, several ω"), this);
    sideSpeeds_->setYAxis(PlotView::Side::Left, {tr("N")});
    tenfold_ = sideSpeeds_->addCurve(
        {.name = tr("10 × with hinge"),
         .colour = 0,
         .width = 1.8,
         .toolTip = tr("Ten times the side force with the rod's hinge: the same at every ω")});
    withoutSpeeds_ = addFamily(sideSpeeds_);
    return makeTab(QStringLiteral("side-force"), nullptr, sideLambdas_, 1, sideSpeeds_, 1);
}

QWidget* HingePlots::buildCrankMoment() {
    crankMoment_ = makePlot(tr("Moment that keeps the crank's speed"), this);
    crankMoment_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    m_ = crankMoment_->addCurve({.name = tr("M"),
                                 .colour = 2,
                                 .width = 1.8,
                                 .toolTip = tr("Without the rod's hinge, d(T + V)/dφ")});
    m1_ = crankMoment_->addCurve({.name = tr("M₁"),
                                  .colour = 1,
                                  .width = 1.8,
                                  .toolTip = tr("With the rod's hinge, M + M₁₂ (1 + ψ′), (8); "
                                                "with a counterweight M₁*, (11)")});
    crankSpeeds_ = makePlot(tr("M₁ at several ω"), this);
    crankSpeeds_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    m1Speeds_ = addFamily(crankSpeeds_);
    return makeTab(QStringLiteral("crank-moment"), nullptr, crankMoment_, 1, crankSpeeds_, 1);
}

QWidget* HingePlots::buildMotion() {
    speed_ = new PlotView(tr("Crank speed"), this);
    speed_->setXAxis({tr("turns"), 0.0, 5.0});
    speed_->setYAxis(PlotView::Side::Left, {tr("rad/s")});
    without_ = speed_->addCurve({.name = tr("without hinge"),
                                 .colour = 0,
                                 .width = 1.4,
                                 .toolTip = tr("The bare mechanism, from the design speed")});
    crank_ = speed_->addCurve({.name = tr("crank hinge"),
                               .colour = 2,
                               .width = 2.0,
                               .toolTip = tr("With the crank's hinge, from the design speed")});
    both_ = speed_->addCurve(
        {.name = tr("both hinges"),
         .colour = 3,
         .width = 1.6,
         .pen = Qt::DashLine,
         .toolTip = tr("With the rod's hinge and the crank's beside it, from the design speed")});
    off_ = speed_->addCurve({.name = tr("off design"),
                             .colour = 1,
                             .width = 1.4,
                             .toolTip = tr("With the crank's hinge, from another speed: the hinge "
                                           "is exact at one speed only")});

    auto* bar = new Panel(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    row->setSpacing(Theme::space);
    motionText_ = captionLabel({}, bar);
    motionText_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(motionText_, 1);
    progress_ = new QProgressBar(bar);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedWidth(110);
    progress_->setAccessibleName(tr("Part of the motion computed"));
    row->addWidget(progress_);
    cancel_ = new QPushButton(tr("Cancel"), bar);
    cancel_->setToolTip(tr("Stop computing the motion"));
    row->addWidget(cancel_);
    // Their place stays, so that nothing jumps when a run starts.
    for (QWidget* widget : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)}) {
        QSizePolicy policy = widget->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        widget->setSizePolicy(policy);
    }
    const auto showRunning = [this](bool running) {
        progress_->setVisible(running);
        cancel_->setVisible(running);
        progress_->setValue(0);
    };
    showRunning(model_->runner()->isRunning());
    connect(model_->runner(), &MotionRunner::runningChanged, this, showRunning);
    connect(model_->runner(), &MotionRunner::progress, this, [this](double part) {
        progress_->setValue(static_cast<int>(std::lround(1000 * part)));
    });
    connect(cancel_, &QPushButton::clicked, model_->runner(), &MotionRunner::cancel);
    return makeTab(QStringLiteral("motion"), bar, speed_, 1, nullptr, 0);
}

// ----------------------------------------------------------------------------------------- show

void HingePlots::refresh() {
    const QString name = currentWidget()->objectName();
    if (name == QLatin1String("guides")) {
        showGuides();
    } else if (name == QLatin1String("rod-hinge")) {
        showRodHinge();
    } else if (name == QLatin1String("side-force")) {
        showSideForce();
    } else if (name == QLatin1String("crank-moment")) {
        showCrankMoment();
    } else {
        showMotion();
    }
    showPresent();
}

void HingePlots::showGuides() {
    const Guide& guide = model_->shownGuide();
    const double factor = model_->exaggeration();
    hingeChoice_->setCurrentIndex(static_cast<int>(model_->shownHinge()));
    exaggeration_->setValue(factor);
    automatic_->setChecked(model_->hasAutomaticExaggeration());
    guide_->setTitle(factor == 1.0 ? tr("Guides, to scale")
                                   : tr("Guides, relief × %1").arg(number(factor, 6)));

    const std::size_t n = guide.polar_angle.size();
    double reach = 0.0;
    double finest = 0.0;
    const auto path = [&](const std::vector<double>& radius, double start, const Pieces& pieces) {
        std::vector<double> x(radius.size());
        std::vector<double> y(radius.size());
        for (std::size_t i = 0; i < radius.size(); ++i) {
            const double drawn = (start + factor * (radius[i] - start)) * mm;
            x[i] = drawn * std::cos(guide.polar_angle[i]);
            y[i] = drawn * std::sin(guide.polar_angle[i]);
            if (std::isfinite(drawn)) {
                reach = std::max(reach, std::abs(drawn));
            }
        }
        setPieces(guide_, pieces, x, y, true);
    };
    const auto circle = [&](double radius, int curve) {
        std::vector<double> x;
        std::vector<double> y;
        if (n > 0 && radius > 0.0) {
            for (int i = 0; i <= 120; ++i) {
                x.push_back(radius * mm * std::cos(two_pi * i / 120));
                y.push_back(radius * mm * std::sin(two_pi * i / 120));
            }
        }
        guide_->setCurve(curve, std::move(x), std::move(y));
    };
    double startCompressed = 0.0;
    double startStretched = 0.0;
    if (guide.shape) {
        startCompressed = guide.shape->spring().start_radius(Branch::compressed);
        startStretched = guide.shape->spring().start_radius(Branch::stretched);
    }
    circle(startCompressed, circleCompressed_);
    circle(startStretched, circleStretched_);
    path(guide.radius_compressed, startCompressed, guideCompressed_);
    path(guide.radius_stretched, startStretched, guideStretched_);

    // The profile of the design's branch, for a roller that has a size.
    const double roller = model_->input().roller_radius;
    std::vector<double> x;
    std::vector<double> y;
    if (guide.feasible && roller > 0.0) {
        const double side = guide.branch == Branch::compressed ? 1.0 : -1.0;
        const double start =
            (guide.branch == Branch::compressed ? startCompressed : startStretched) + side * roller;
        constexpr int points = 361;
        for (int i = 0; i < points; ++i) {
            const PlanePoint p = elastic_hinge::offset_point(
                guide.shape->at(guide.branch, two_pi * i / (points - 1)), side * roller);
            const double radius = std::hypot(p.x, p.y);
            const double drawn = (start + factor * (radius - start)) * mm;
            x.push_back(drawn * p.x / radius);
            y.push_back(drawn * p.y / radius);
            reach = std::max(reach, std::abs(drawn));
        }
    }
    setPieces(guide_, profile_, x, y, true);
    const QString profileName = x.empty() ? QString() : tr("profile");
    if (guide_->curveName(profile_.curves[0]) != profileName) {
        guide_->setCurveStyle(profile_.curves[0], profileStyle(profileName));
    }
    if (reach > 0.0 && (reach > guideReach_ || reach < 0.6 * guideReach_)) {
        guideReach_ = 1.12 * reach;
        const auto shown = guide_->isZoomed();
        if (!shown) {
            guide_->setXAxis({tr("x, mm"), -guideReach_, guideReach_});
        }
        guide_->setYRange(PlotView::Side::Left, -guideReach_, guideReach_);
    }

    // The relief alone.
    const std::vector<double>& phi = model_->result().crank_angle_deg;
    for (const auto* radius : {&guide.radius_compressed, &guide.radius_stretched}) {
        const double start = radius == &guide.radius_compressed ? startCompressed : startStretched;
        for (const double value : *radius) {
            if (std::isfinite(value)) {
                finest = std::max(finest, std::abs(value - start));
            }
        }
    }
    if (finest > 0.0) {
        narrow_ = finest < (narrow_ ? 0.6e-3 : 0.4e-3);  // does not flicker at the border
    }
    relief_->setYAxis(PlotView::Side::Left, {narrow_ ? tr("ρ − ρ(0), µm") : tr("ρ − ρ(0), mm")});
    const auto relief = [&](const std::vector<double>& radius, double start, const Pieces& pieces) {
        std::vector<double> rise(radius.size());
        for (std::size_t i = 0; i < radius.size(); ++i) {
            rise[i] = (radius[i] - start) * (narrow_ ? um : mm);
        }
        setPieces(relief_, pieces, phi, rise, false);
    };
    relief(guide.radius_compressed, startCompressed, reliefCompressed_);
    relief(guide.radius_stretched, startStretched, reliefStretched_);
    std::vector<PlotView::Band> bands;
    QColor shade = Theme::instance().error();
    shade.setAlphaF(0.12F);
    for (std::size_t i = 0; i < guide.radius_stretched.size(); ++i) {
        if (std::isfinite(guide.radius_stretched[i])) {
            continue;
        }
        if (bands.empty() || bands.back().to < phi[i - 1]) {
            bands.push_back({phi[i], phi[i], shade, tr("no guide")});
        }
        bands.back().to = phi[i];
    }
    relief_->setBands(std::move(bands));
}

namespace {

/// Fills the curves of a family; members beyond the curves are left out.
template <typename Members, typename Values>
void fill(PlotView* plot, const std::array<int, 6>& curves, const Members& members,
          const std::vector<double>& phi, const QString& pattern, const Values& values) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const bool there = i < members.size() && !values(members[i].curves).empty();
        const QString name =
            there ? pattern.arg(formNumber(members[i].parameter, QLocale(), 5)) : QString();
        const bool before = plot->curveName(curves[i]) != QString();
        if (plot->curveName(curves[i]) != name) {
            plot->setCurveStyle(
                curves[i],
                {.name = name, .colour = static_cast<int>(i + 1), .width = 1.4, .inLegend = true});
        }
        if (there) {
            plot->setCurve(curves[i], phi, values(members[i].curves));
            if (!before) {
                plot->setCurveShown(curves[i], true);
            }
        } else {
            plot->setCurve(curves[i], {}, {});
            plot->setCurveShown(curves[i], false);
        }
    }
}

}  // namespace

void HingePlots::showRodHinge() {
    const Result& result = model_->result();
    const std::vector<double>& phi = result.crank_angle_deg;
    const bool series = model_->input().kinematics == Kinematics::series;
    rodMoment_->setCurve(m12_, phi, result.curves.rod_hinge_moment);
    rodMoment_->setCurve(m12Potential_, phi, result.curves.rod_hinge_moment_potential);
    // M₁₂ by the other kinematics.
    std::vector<double> other;
    if (result.design->has_exact_kinematics()) {
        const auto& mechanism = result.design->mechanism();
        const double omega = model_->input().angular_speed;
        other.reserve(phi.size());
        for (const double angle : phi) {
            const double s = std::sin(angle * degree);
            const double c = std::cos(angle * degree);
            const auto rod = elastic_hinge::rod_angle(
                series ? Kinematics::exact : Kinematics::series, mechanism.lambda, s, c);
            other.push_back(elastic_hinge::rod_hinge_moment(
                                mechanism, result.design->static_moment(), s, c, rod)
                                .value(omega));
        }
    }
    const QString name = series ? tr("exact") : tr("series");
    if (rodMoment_->curveName(m12Other_) != name) {
        rodMoment_->setCurveStyle(m12Other_,
                                  {.name = name,
                                   .colour = 4,
                                   .width = 1.4,
                                   .pen = Qt::DotLine,
                                   .toolTip = tr("M₁₂ by the other kinematics, for comparison")});
    }
    rodMoment_->setCurve(m12Other_, other.empty() ? std::vector<double>() : phi, other);
    fill(rodSpeeds_, m12Speeds_.curves, result.by_speed, phi, tr("%1 rad/s"),
         [](const MechanismCurves& curves) -> const std::vector<double>& {
             return curves.rod_hinge_moment;
         });
}

void HingePlots::showSideForce() {
    const Result& result = model_->result();
    const std::vector<double>& phi = result.crank_angle_deg;
    fill(sideLambdas_, withLambdas_.curves, result.by_lambda, phi, QStringLiteral("λ = %1"),
         [](const MechanismCurves& curves) -> const std::vector<double>& {
             return curves.side_force_with_hinge;
         });
    // A counterweight by (10) leaves rounding only: a flat line at 0, not its noise enlarged.
    const bool nothingLeft =
        result.largest_side_force_with <= 1e-9 * result.largest_side_force_without;
    if (nothingLeft) {
        sideLambdas_->setYRange(PlotView::Side::Left, -1.0, 1.0);
    } else {
        sideLambdas_->followData(PlotView::Side::Left);
    }
    fill(sideSpeeds_, withoutSpeeds_.curves, result.by_speed, phi, tr("%1 rad/s"),
         [](const MechanismCurves& curves) -> const std::vector<double>& {
             return curves.side_force_without_hinge;
         });
    std::vector<double> ten = result.curves.side_force_with_hinge;
    for (double& force : ten) {
        force *= 10.0;
    }
    sideSpeeds_->setCurve(tenfold_, phi, std::move(ten));
}

void HingePlots::showCrankMoment() {
    const Result& result = model_->result();
    const std::vector<double>& phi = result.crank_angle_deg;
    const auto set = [&](int curve, const std::vector<double>& values) {
        crankMoment_->setCurve(curve, values.empty() ? std::vector<double>() : phi, values);
    };
    set(m_, result.curves.crank_moment);
    set(m1_, result.curves.crank_moment_with_rod_hinge);
    const bool starred = result.has_counterweight;
    const QString name = starred ? tr("M₁*") : tr("M₁");
    if (crankMoment_->curveName(m1_) != name) {
        crankMoment_->setCurveStyle(m1_,
                                    {.name = name,
                                     .colour = 1,
                                     .width = 1.8,
                                     .toolTip = tr("With the rod's hinge, M + M₁₂ (1 + ψ′), (8); "
                                                   "with a counterweight M₁*, (11)")});
        crankSpeeds_->setTitle(starred ? tr("M₁* at several ω") : tr("M₁ at several ω"));
    }
    fill(crankSpeeds_, m1Speeds_.curves, result.by_speed, phi, tr("%1 rad/s"),
         [](const MechanismCurves& curves) -> const std::vector<double>& {
             return curves.crank_moment_with_rod_hinge;
         });
}

void HingePlots::showMotion() {
    const HingeMotions* motions = model_->motions();
    motionText_->setText(model_->motionsText());
    const double turns = model_->input().motion.value_or(elastic_hinge::MotionWish{}).turns;
    if (turns != shownTurns_) {
        shownTurns_ = turns;
        speed_->setXAxis({tr("turns"), 0.0, turns});
    }
    const auto set = [&](int curve, const std::optional<Motion>* motion) {
        std::vector<double> x;
        std::vector<double> y;
        if (motion != nullptr && *motion) {
            const Motion& m = **motion;
            x.reserve(m.crank_angle.size());
            for (const double angle : m.crank_angle) {
                x.push_back(std::abs(angle - m.crank_angle.front()) / two_pi);
            }
            y = m.speed;
        }
        speed_->setCurve(curve, std::move(x), std::move(y));
    };
    set(without_, motions != nullptr ? &motions->without : nullptr);
    set(crank_, motions != nullptr ? &motions->crank : nullptr);
    set(both_, motions != nullptr ? &motions->both : nullptr);
    set(off_, motions != nullptr ? &motions->offDesign : nullptr);
}

void HingePlots::showPresent() {
    const double phi = model_->crankAngleDeg();
    for (PlotView* plot : frontPlots()) {
        if (plot == speed_) {
            const Motion* motion = model_->animatedMotion();
            const auto time = model_->motionTime();
            speed_->setPresentX(
                motion != nullptr && time
                    ? std::optional(
                          std::abs(motion->angle_at(*time) - motion->crank_angle.front()) / two_pi)
                    : std::nullopt);
        } else if (plot == guide_) {
            std::vector<PlotView::Mark> marks;
            const Guide& guide = model_->shownGuide();
            if (guide.shape) {
                const double factor = model_->exaggeration();
                for (const Branch branch : {Branch::compressed, Branch::stretched}) {
                    const GuidePoint point = guide.shape->at(branch, phi * degree);
                    const double start = guide.shape->spring().start_radius(branch);
                    const double drawn = (start + factor * (point.radius - start)) * mm;
                    if (std::isfinite(drawn) && point.radius > 0.0) {
                        marks.push_back({drawn * std::cos(point.angle),
                                         drawn * std::sin(point.angle),
                                         {},
                                         branch == Branch::compressed ? 2 : 1});
                    }
                }
            }
            guide_->setMarks(std::move(marks));
        } else {
            plot->setPresentX(phi);
        }
    }
}

}  // namespace ravnoves
