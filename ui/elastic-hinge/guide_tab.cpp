#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <array>
#include <cmath>

#include "elastic-hinge/hinge_plots.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Guide;
using elastic_hinge::GuidePoint;
using elastic_hinge::Hinge;
using elastic_hinge::PlanePoint;

namespace {

constexpr double mm = 1e3;
constexpr double um = 1e6;
constexpr std::array branches{Branch::compressed, Branch::stretched};
constexpr std::array colours{2, 1};
// Curves: a circle and a guide for each branch, the profile between them.
constexpr int profile = 2;
constexpr int firstGuide = 3;

const std::vector<double>& radii(const Guide& guide, std::size_t branch) {
    return branch == 0 ? guide.radius_compressed : guide.radius_stretched;
}

class GuideTab : public HingePlotTab {
  public:
    GuideTab(ElasticHingeModel* model, QWidget* parent);

  private:
    void showGuides();
    void showMarks();
    void buildBar();
    double start(std::size_t branch) const;
    /// A radius as the picture draws it, mm.
    double drawn(double radius, double start) const {
        return (start + model_->exaggeration() * (radius - start)) * mm;
    }
    void showCircle(std::size_t branch);
    void showGuide(std::size_t branch);
    void showProfile();
    /// Sets a curve of the guides' plot and remembers how far it reaches.
    void setPath(int curve, std::vector<double> x, std::vector<double> y);
    void showReach();
    void showRelief();

    ElasticHingeModel* model_;
    PlotView* guide_ = nullptr;
    PlotView* relief_ = nullptr;
    QComboBox* hingeChoice_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    ValueSlider* exaggeration_ = nullptr;
    double reach_ = 0.0;
    double shownReach_ = 0.0;
    bool narrow_ = false;  ///< the relief plot counts in µm
};

GuideTab::GuideTab(ElasticHingeModel* model, QWidget* parent)
    : HingePlotTab(model, parent), model_(model) {
    refresh = [this] { showGuides(); };
    showPresent = [this] { showMarks(); };
    buildBar();
    guide_ = addPlot(HingePlots::tr("Guides"), {HingePlots::tr("x, mm"), -130.0, 130.0},
                     HingePlots::tr("y, mm"), 5);
    guide_->setEqualScale(true);
    guide_->addCurve({.name = HingePlots::tr("ρ₀"), .width = 1.0, .inLegend = false});
    guide_->addCurve({.name = HingePlots::tr("ℓ₀ − ρ₀"), .width = 1.0, .inLegend = false});
    guide_->addCurve({.name = {},
                      .colour = 3,
                      .width = 1.4,
                      .toolTip = HingePlots::tr(
                          "What the roller touches: the path of its centre offset by its radius"),
                      .gaps = true,
                      .closed = true});
    relief_ = addAnglePlot(HingePlots::tr("ρ over the turn, from its value at 0°"), {}, 3);
    const std::array names{HingePlots::tr("compressed"), HingePlots::tr("stretched")};
    const std::array tips{HingePlots::tr("Guide of the compressed spring, minus in (3)"),
                          HingePlots::tr("Guide of the stretched spring, plus in (3)")};
    for (std::size_t i = 0; i < branches.size(); ++i) {
        guide_->addCurve({.name = names[i],
                          .colour = colours[i],
                          .width = 1.8,
                          .toolTip = tips[i],
                          .gaps = true,
                          .closed = true});
        relief_->addCurve(
            {.name = names[i], .colour = colours[i], .width = i == 0 ? 1.8 : 1.4, .gaps = true});
    }
}

void GuideTab::buildBar() {
    QHBoxLayout* row = addBar();
    hingeChoice_ = new QComboBox(this);
    hingeChoice_->setObjectName(QStringLiteral("guide_shown"));
    hingeChoice_->addItems({HingePlots::tr("crank, for M"), HingePlots::tr("crank, for M₁"),
                            HingePlots::tr("rod, for M₁₂")});
    hingeChoice_->setAccessibleName(HingePlots::tr("Which guide is shown"));
    hingeChoice_->setToolTip(HingePlots::tr(
        "The hinge between frame and crank alone (M), the same beside the rod's hinge (M₁), or "
        "the hinge between crank and rod, whose guide goes by θ = φ + ψ"));
    connect(hingeChoice_, &QComboBox::activated, this,
            [this](int index) { model_->setShownHinge(static_cast<Hinge>(index)); });
    row->addWidget(hingeChoice_);
    exaggeration_ = new ValueSlider(HingePlots::tr("&Relief ×"), 1.0, 1e5, 1.0, 10.0, 0, {}, this);
    exaggeration_->setLogarithmic(12, 2);
    exaggeration_->slider()->setObjectName(QStringLiteral("exaggeration_slider"));
    exaggeration_->setHint(
        HingePlots::tr("The pictures enlarge the guide's relief by this factor; 1 is to scale"));
    connect(exaggeration_, &ValueSlider::valueEdited, this,
            [this](double factor) { model_->setExaggeration(factor); });
    row->addWidget(exaggeration_, 1);
    automatic_ = new QCheckBox(HingePlots::tr("a&uto"), this);
    automatic_->setObjectName(QStringLiteral("exaggeration_auto"));
    automatic_->setToolTip(HingePlots::tr("Choose the factor by the relief"));
    connect(automatic_, &QCheckBox::clicked, this, [this](bool on) {
        model_->setExaggeration(on ? std::nullopt : std::optional(model_->exaggeration()));
    });
    row->addWidget(automatic_);
}

double GuideTab::start(std::size_t branch) const {
    const auto& shape = model_->shownGuide().shape;
    return shape ? shape->spring().start_radius(branches[branch]) : 0.0;
}

void GuideTab::showGuides() {
    const double factor = model_->exaggeration();
    hingeChoice_->setCurrentIndex(static_cast<int>(model_->shownHinge()));
    exaggeration_->setValue(factor);
    automatic_->setChecked(model_->hasAutomaticExaggeration());
    guide_->setTitle(
        factor == 1.0
            ? HingePlots::tr("Guides, to scale")
            : HingePlots::tr("Guides, relief × %1").arg(formNumber(factor, QLocale(), 6)));
    reach_ = 0.0;
    for (std::size_t branch = 0; branch < branches.size(); ++branch) {
        showCircle(branch);
        showGuide(branch);
    }
    showProfile();
    showReach();
    showRelief();
}

void GuideTab::setPath(int curve, std::vector<double> x, std::vector<double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double radius = std::hypot(x[i], y[i]);
        if (std::isfinite(radius)) {
            reach_ = std::max(reach_, radius);
        }
    }
    guide_->setCurve(curve, std::move(x), std::move(y));
}

void GuideTab::showCircle(std::size_t branch) {
    const double radius = start(branch) * mm;
    std::vector<double> x;
    std::vector<double> y;
    if (!model_->shownGuide().polar_angle.empty() && radius > 0.0) {
        for (int i = 0; i <= 120; ++i) {
            x.push_back(radius * std::cos(two_pi * i / 120));
            y.push_back(radius * std::sin(two_pi * i / 120));
        }
    }
    guide_->setCurve(static_cast<int>(branch), std::move(x), std::move(y));
}

void GuideTab::showGuide(std::size_t branch) {
    const Guide& guide = model_->shownGuide();
    std::vector<double> x = radii(guide, branch);
    std::vector<double> y(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double radius = drawn(x[i], start(branch));
        x[i] = radius * std::cos(guide.polar_angle[i]);
        y[i] = radius * std::sin(guide.polar_angle[i]);
    }
    setPath(firstGuide + static_cast<int>(branch), std::move(x), std::move(y));
}

void GuideTab::showProfile() {
    // Of the design's branch, for a roller that has a size.
    const Guide& guide = model_->shownGuide();
    const double roller = model_->input().roller_radius;
    std::vector<double> x;
    std::vector<double> y;
    if (guide.feasible && roller > 0.0) {
        const bool compressed = guide.branch == Branch::compressed;
        const double offset = compressed ? roller : -roller;
        constexpr int points = 361;
        for (int i = 0; i < points; ++i) {
            const PlanePoint p = elastic_hinge::offset_point(
                guide.shape->at(guide.branch, two_pi * i / (points - 1)), offset);
            const double radius = std::hypot(p.x, p.y);
            const double far = drawn(radius, start(compressed ? 0 : 1) + offset);
            x.push_back(far * p.x / radius);
            y.push_back(far * p.y / radius);
        }
    }
    guide_->setCurveName(profile, x.empty() ? QString() : HingePlots::tr("profile"));
    setPath(profile, std::move(x), std::move(y));
}

void GuideTab::showReach() {
    if (reach_ > 0.0 && (reach_ > shownReach_ || reach_ < 0.6 * shownReach_)) {
        shownReach_ = 1.12 * reach_;
        if (!guide_->isZoomed()) {
            guide_->setXAxis({HingePlots::tr("x, mm"), -shownReach_, shownReach_});
        }
        guide_->setYRange(PlotView::Side::Left, -shownReach_, shownReach_);
    }
}

void GuideTab::showRelief() {
    const Guide& guide = model_->shownGuide();
    const std::vector<double>& phi = model_->result().crank_angle_deg;
    double finest = 0.0;
    std::array<std::vector<double>, 2> rises{radii(guide, 0), radii(guide, 1)};
    for (std::size_t branch = 0; branch < rises.size(); ++branch) {
        for (double& rise : rises[branch]) {
            rise -= start(branch);
            finest = std::isfinite(rise) ? std::max(finest, std::abs(rise)) : finest;
        }
    }
    if (finest > 0.0) {
        narrow_ = finest < (narrow_ ? 0.6e-3 : 0.4e-3);  // does not flicker at the border
    }
    relief_->setYAxis(PlotView::Side::Left,
                      {narrow_ ? HingePlots::tr("ρ − ρ(0), µm") : HingePlots::tr("ρ − ρ(0), mm")});
    for (std::size_t branch = 0; branch < rises.size(); ++branch) {
        for (double& rise : rises[branch]) {
            rise *= narrow_ ? um : mm;
        }
        relief_->setCurve(static_cast<int>(branch), phi, std::move(rises[branch]));
    }
    std::vector<PlotView::Band> bands;
    QColor shade = Theme::instance().error();
    shade.setAlphaF(0.12F);
    for (std::size_t i = 0; i < guide.radius_stretched.size(); ++i) {
        if (std::isfinite(guide.radius_stretched[i])) {
            continue;
        }
        if (bands.empty() || bands.back().to < phi[i - 1]) {
            bands.push_back({phi[i], phi[i], shade, HingePlots::tr("no guide")});
        }
        bands.back().to = phi[i];
    }
    relief_->setBands(std::move(bands));
}

void GuideTab::showMarks() {
    std::vector<PlotView::Mark> marks;
    const auto& shape = model_->shownGuide().shape;
    for (std::size_t branch = 0; shape && branch < branches.size(); ++branch) {
        const GuidePoint point = shape->at(branches[branch], model_->crankAngleDeg() * degree);
        const double far = drawn(point.radius, start(branch));
        if (std::isfinite(far) && point.radius > 0.0) {
            marks.push_back(
                {far * std::cos(point.angle), far * std::sin(point.angle), {}, colours[branch]});
        }
    }
    guide_->setMarks(std::move(marks));
}

}  // namespace

HingePlotTab* makeGuideTab(ElasticHingeModel* model, QWidget* parent) {
    return new GuideTab(model, parent);
}

}  // namespace ravnoves
