#include "inertia-moments/inertia_moments_page.h"

#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/cylinder_editor.h"
#include "inertia-moments/engine_forms.h"
#include "inertia-moments/engine_view.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "page/rejected_verdict.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"

namespace ravnoves {

namespace {

/// The tabs of plots, and of the pictures of firing order, shafts and counterweights.
class InertiaMomentsCharts final : public FittedTabs {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::InertiaMomentsCharts)

  public:
    InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent);

  private:
    /// @param name  of the tab for pictures
    void add(QWidget* view, const char* name, const QString& title);
    void addOrders();
    /// Two beside each other, or below one another.
    std::array<PartPlot*, 2> addPair(const char* left, const char* right, const char* name,
                                     const QString& title);
    /// Where the vectors are now, on their hodographs.
    void showCursor();

    InertiaMomentsModel* model_;
    std::array<PartPlot*, 2> hodographs_{};  ///< forces, moments
};

InertiaMomentsCharts::InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent)
    : FittedTabs(parent), model_(model) {
    setDocumentMode(true);
    beginGroup(tr("Analysis"));
    addOrders();
    hodographs_ = addPair("hodograph-forces", "hodograph-moments", "hodographs", tr("Hodographs"));
    addPair("forces-by-order", "moments-by-order", "orders", tr("Orders"));
    showCrankAngle(addPair("roll", "roll-by-order", "roll", tr("Roll"))[0], model_->crank());
    for (PartPlot* plot :
         addPair("forces-over-angle", "moments-over-angle", "over-angle", tr("Over φ"))) {
        showCrankAngle(plot, model_->crank());
    }
    setTabToolTip(count() - 1, tr("Forces and moments of all orders over two turns"));
    beginGroup(tr("Design"));
    add(firingWheel(model_, this), "firing", tr("Firing"));
    add(shaftView(model_, this), "shafts", tr("Shafts"));
    add(counterweightView(model_, this), "weights", tr("Weights"));
    for (const auto signal : {&SceneModel::changed, &SceneModel::viewChanged}) {
        connect(model_, signal, this, &InertiaMomentsCharts::showCursor);
    }
    connect(model_->crank(), &CrankAngle::changed, this, &InertiaMomentsCharts::showCursor);
    showCursor();
}

void InertiaMomentsCharts::add(QWidget* view, const char* name, const QString& title) {
    view->setObjectName(QLatin1String(name));
    addTab(view, title);
}

void InertiaMomentsCharts::addOrders() {
    auto* orders = new QWidget(this);
    QVBoxLayout* both = columnIn(orders);
    QList<PlotView*> plots;
    for (const char* part : {"order-1", "order-2"}) {
        plots << new PartPlot(model_, part, orders);
        showCrankAngle(plots.last(), model_->crank());
        both->addWidget(plots.last());
    }
    PlotView::stack(plots);
    add(orders, "first-orders", tr("Orders 1, 2"));
}

std::array<PartPlot*, 2> InertiaMomentsCharts::addPair(const char* left, const char* right,
                                                       const char* name, const QString& title) {
    constexpr int wide = 420;  // designed pixels of both beside each other
    auto* pair = new FoldingRow(wide, this);
    pair->setContentsMargins(0, Theme::gap, 0, 0);
    const std::array plots{new PartPlot(model_, left, pair), new PartPlot(model_, right, pair)};
    for (PartPlot* plot : plots) {
        pair->add(plot);
    }
    add(pair, name, title);
    return plots;
}

void InertiaMomentsCharts::showCursor() {
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        const auto first = model_->vectorNow(1, i == 0);
        const auto second = model_->vectorNow(2, i == 0);
        hodographs_[i]->setMarks({{first.real(), first.imag(), {}, Role::FirstOrder},
                                  {second.real(), second.imag(), {}, Role::SecondOrder}});
    }
}

}  // namespace

InertiaMomentsPage::InertiaMomentsPage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(adopt<InertiaMomentsModel>(kept)) {
    QTabWidget* inputs = makeInputs();
    auto* verdict = new VerdictLine(this);
    showVerdict(verdict, model_);
    QVBoxLayout* column = columnIn(this);
    column->addWidget(verdict);
    // The sliders over plots and picture: they need length.
    column->addWidget(
        new PageColumns({.inputs = inputs,
                         .tabs = inputs,
                         .plots = scrolled(new InertiaMomentsCharts(model_, this), this),
                         .results = buildAnswer(),
                         .resultShare = 3,
                         .top = new EngineSliders(model_, this)},
                        this),
        1);

    connect(model_, &SceneModel::rejected, this, &ScenePage::status);
    addShaftsAction();
}

QTabWidget* InertiaMomentsPage::makeInputs() {
    auto* inputs = new QTabWidget(this);
    inputs->setDocumentMode(true);
    inputs->setFixedWidth(PageColumns::inputsWidth());
    addScrolledTab(inputs, new EngineForm(model_), QStringLiteral("engine"), tr("Engine"));
    auto* cylinders = new CylinderEditor(model_, inputs);
    cylinders->setObjectName(QStringLiteral("cylinders"));
    inputs->addTab(cylinders, tr("Cylinders"));
    addScrolledTab(inputs, new BalancingForm(model_), QStringLiteral("balancing"), tr("Balancing"));
    return inputs;
}

QWidget* InertiaMomentsPage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(Theme::withText(332));
    holder->setMaximumWidth(Theme::withText(480));
    QVBoxLayout* column = columnIn(holder);
    auto* picturePanel = new PicturePanel(
        new EngineView(model_), tr("Crank angle of the picture, from cylinder 1's axis"), holder);
    playAction_ = picturePanel->action();
    column->addWidget(picturePanel, 5);

    auto* panel = new Panel(holder);
    QVBoxLayout* answerColumn =
        columnIn(panel, Theme::gap, {Theme::gap, Theme::gap, Theme::gap, Theme::space});
    auto* tabs = new QTabWidget(panel);
    tabs->setDocumentMode(true);
    const auto add = [&](const char* part, const QString& title, const QString& name) {
        auto* table = new PartTable(model_, part, name, tabs);
        table->setObjectName(QStringLiteral("table-") + QLatin1String(part));
        table->setShownRows(4);  // the picture has the same share of the height
        tabs->setTabToolTip(tabs->addTab(table, title), name);
    };
    add("orders", tr("Orders"), tr("Amplitudes and phases by order and plane"));
    add("rotating", tr("±kω"), tr("Forward and backward rotating parts by order"));
    add("shafts", tr("Shafts"), tr("Balance shafts"));
    add("weights", tr("Weights"), CrankViews::tr("Rotating masses and counterweights"));
    add("left", tr("Residual"), tr("Residual by order"));
    answerColumn->addWidget(tabs, 1);
    column->addWidget(panel, 5);
    return holder;
}

void InertiaMomentsPage::addShaftsAction() {
    shaftsAction_ = new QAction(themedIcon(QStringLiteral("best")), tr("&Shafts on or off"), this);
    shaftsAction_->setToolTip(tr("Switch all balance shafts on, or off when all are on"));
    connect(shaftsAction_, &QAction::triggered, this, [this] {
        const auto& shafts = model_->input().shafts;
        const bool all = std::all_of(shafts.begin(), shafts.end(),
                                     [](const auto& shaft) { return shaft.enabled; });
        model_->edit(all ? tr("All shafts off") : tr("All shafts on"),
                     [all](inertia_moments::Input& input) {
                         for (auto& shaft : input.shafts) {
                             shaft.enabled = !all;
                         }
                     });
    });
}

}  // namespace ravnoves
