#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <array>
#include <cmath>

#include "elastic-hinge/hinge_plots.h"
#include "elastic-hinge/model/guide_picture.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Hinge;

namespace {

constexpr std::array branches{Branch::compressed, Branch::stretched};
constexpr std::array colours{2, 1};
// Curves: a circle and a guide for each branch, the profile between them.
constexpr int profile = 2;
constexpr int firstGuide = 3;

class GuideTab : public HingePlotTab {
  public:
    GuideTab(ElasticHingeModel* model, QWidget* parent);

  private:
    void showGuides();
    void showMarks();
    void buildBar();
    GuidePicture shown() const { return {model_->shownGuide(), model_->exaggeration()}; }
    /// The guides' curves of a plot's data to scale.
    void putToScale(PlotData& data) const;
    /// What is read at a point of a guide: its true place.
    QString pointText(Branch branch, std::size_t point) const;
    /// Sets a curve of the guides' plot and remembers how far it reaches.
    void setPath(int curve, GuidePicture::Path path);
    void showReach();
    void showRelief();
    void nameRelief();

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
    connect(model_, &SceneModel::rested, this, [this] {
        if (isVisible()) {
            showGuides();
        }
    });
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
    guide_->setTruth([this](PlotData& data) { putToScale(data); });
    relief_ = addAnglePlot(HingePlots::tr("ρ over the turn, from its value at 0°"), {}, 3);
    nameRelief();
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
        guide_->setPointText(
            firstGuide + static_cast<int>(i),
            [this, branch = branches[i]](std::size_t point) { return pointText(branch, point); });
        relief_->addCurve(
            {.name = names[i], .colour = colours[i], .width = i == 0 ? 1.8 : 1.4, .gaps = true});
    }
}

void GuideTab::buildBar() {
    auto* bar = new FoldingRow(0, this);
    addBar()->addWidget(bar);
    const auto addPart = [bar](int share) {
        auto* part = new QWidget(bar);
        QHBoxLayout* row = rowIn(part);
        bar->add(part, share);
        return row;
    };
    QHBoxLayout* row = addPart(0);
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
    auto* label = new QLabel(HingePlots::tr("&Guide"), this);
    label->setBuddy(hingeChoice_);
    row->addWidget(label);
    row->addWidget(hingeChoice_, 1);
    row = addPart(1);
    constexpr Range factors = ElasticHingeModel::exaggerationField.range;
    exaggeration_ = new ValueSlider(HingePlots::tr("&Relief ×"), factors.min, factors.max, 1.0,
                                    10.0, 0, {}, this);
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
    const GuidePicture picture = shown();
    for (const Branch branch : branches) {
        const int curve = static_cast<int>(branch);
        GuidePicture::Path circle = picture.circle(branch);
        guide_->setCurve(curve, std::move(circle.x), std::move(circle.y));
        setPath(firstGuide + curve, picture.path(branch));
    }
    GuidePicture::Path rollers = picture.profile(model_->input().roller_radius);
    guide_->setCurveName(profile, rollers.x.empty() ? QString() : HingePlots::tr("profile"));
    setPath(profile, std::move(rollers));
    showReach();
    showRelief();
}

void GuideTab::putToScale(PlotData& data) const {
    const GuidePicture toScale(model_->shownGuide(), 1.0);
    const auto put = [&data](int number, GuidePicture::Path path) {
        PlotCurve& curve = data.curve(number);
        curve.set(std::move(path.x), std::move(path.y), data.x, data.scale(curve.style.side));
    };
    for (const Branch branch : branches) {
        put(firstGuide + static_cast<int>(branch), toScale.path(branch));
    }
    put(profile, toScale.profile(model_->input().roller_radius));
}

QString GuideTab::pointText(Branch branch, std::size_t point) const {
    const elastic_hinge::Guide& guide = model_->shownGuide();
    const PlotCurve& curve = guide_->data().curve(firstGuide + static_cast<int>(branch));
    // The curve leaves out what does not exist and may begin after it.
    const GuidePicture::Path path = shown().path(branch);
    std::size_t i = 0;
    while (i < path.x.size() && (path.x[i] != curve.x[point] || path.y[i] != curve.y[point])) {
        ++i;
    }
    if (i == path.x.size()) {
        return curve.style.name;
    }
    const std::vector<double>& radius =
        branch == Branch::compressed ? guide.radius_compressed : guide.radius_stretched;
    return QStringList{curve.style.name,
                       QStringLiteral("φ = %1°").arg(
                           fixedNumber(model_->result().crank_angle_deg[i], 1, QLocale())),
                       QStringLiteral("ρ = ") + shownNumber(radius[i], units::mm, 4)}
        .join(QLatin1Char('\n'));
}

void GuideTab::setPath(int curve, GuidePicture::Path path) {
    reach_ = std::max(reach_, path.reach());
    guide_->setCurve(curve, std::move(path.x), std::move(path.y));
}

void GuideTab::showReach() {
    const double wanted = 1.12 * reach_;
    const bool isFar = model_->isMoved() ? reach_ > shownReach_ || reach_ < 0.6 * shownReach_
                                         : wanted != shownReach_;
    if (reach_ > 0.0 && isFar) {
        shownReach_ = wanted;
        if (!guide_->isZoomed()) {
            guide_->setXAxis({HingePlots::tr("x, mm"), -shownReach_, shownReach_});
        }
        guide_->setYRange(PlotView::Side::Left, -shownReach_, shownReach_);
    }
}

void GuideTab::showRelief() {
    const std::vector<double>& phi = model_->result().crank_angle_deg;
    const GuidePicture picture = shown();
    if (const double finest = picture.greatestRise(); finest > 0.0) {
        // No flicker at the border.
        const double border = !model_->isMoved() ? 0.5e-3 : narrow_ ? 0.6e-3 : 0.4e-3;
        const bool narrow = finest < border;
        if (narrow != narrow_) {
            narrow_ = narrow;
            nameRelief();
        }
    }
    for (std::size_t branch = 0; branch < branches.size(); ++branch) {
        relief_->setCurve(static_cast<int>(branch), phi,
                          picture.rise(branches[branch], narrow_ ? units::micrometre : units::mm));
    }
    std::vector<PlotView::Band> bands;
    QColor shade = Theme::instance().error();
    shade.setAlphaF(0.12F);
    for (const auto& [from, to] : picture.gaps(phi)) {
        bands.push_back({from, to, shade, HingePlots::tr("no guide")});
    }
    relief_->setBands(std::move(bands));
}

void GuideTab::nameRelief() {
    relief_->setYAxis(PlotView::Side::Left,
                      {narrow_ ? HingePlots::tr("ρ − ρ(0), µm") : HingePlots::tr("ρ − ρ(0), mm")});
}

void GuideTab::showMarks() {
    std::vector<PlotView::Mark> marks;
    for (const Branch branch : branches) {
        if (const auto at = shown().centre(branch, model_->crank()->degrees() * degree)) {
            marks.push_back({at->x, at->y, {}, colours[static_cast<std::size_t>(branch)]});
        }
    }
    guide_->setMarks(std::move(marks));
}

}  // namespace

HingePlotTab* makeGuideTab(ElasticHingeModel* model, QWidget* parent) {
    return new GuideTab(model, parent);
}

}  // namespace ravnoves
