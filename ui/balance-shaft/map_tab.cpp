#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/shaft_map_plot.h"
#include "balance-shaft/shaft_tabs.h"
#include "numerics/units.h"
#include "text/message_text.h"
#include "theme/theme.h"
#include "widgets/answer_label.h"
#include "widgets/form.h"
#include "widgets/layouts.h"
#include "widgets/number_field.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"

namespace ravnoves {

namespace {

/// Positions the shaft: the map of its places over the front view, the limits on them, and the cost
/// of the criterion in size.
class ShaftMapView final : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftMapView)

  public:
    ShaftMapView(BalanceShaftModel* model, QWidget* parent)
        : QWidget(parent), model_(model), map_(model->shaftMap()) {
        QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);
        column->addWidget(buildBar());

        auto* tabs = new FittedTabs(this);
        tabs->setDocumentMode(true);
        auto* front = new QWidget(tabs);
        front->setObjectName(QStringLiteral("front"));
        QVBoxLayout* frontColumn = columnIn(front, Theme::gap);
        plot_ = new ShaftMapPlot(model_, front);
        frontColumn->addWidget(plot_, 1);
        words_ = copyableCaption("shaft_map_words", front);
        words_->setAccessibleName(tr("The place under the pointer, or the best one"));
        wordsRoom_ = new Apart(words_, front);
        frontColumn->addWidget(wordsRoom_);
        tabs->addTab(front, tr("Front view"));
        tabs->addTab(buildLimits(), tr("Limits"));
        tabs->addTab(buildSizes(), tr("Pareto"));
        column->addWidget(tabs, 1);

        connect(plot_, &ShaftMapPlot::hovered, this, &ShaftMapView::showWords);
        connect(map_, &ShaftMapModel::mapChanged, this, &ShaftMapView::showMap);
        connect(map_, &ShaftMapModel::staleChanged, this, &ShaftMapView::showStale);
        connect(map_, &ShaftMapModel::moved, this, [this] {
            if (isVisible()) {
                map_->need();
                showPresent();
                showWords(map_->isAtBest() ? QString() : map_->placeText(map_->present()));
            }
        });
        showMap();
    }

  protected:
    void showEvent(QShowEvent* event) override {
        QWidget::showEvent(event);
        map_->need();  // the button goes by it, whatever tab is in front
        showPresent();
        showWords();  // the shaft may have moved meanwhile
    }

    void resizeEvent(QResizeEvent* event) override {
        QWidget::resizeEvent(event);
        fitWords();
    }

    /// A click or a drag in the chart is one step of the history.
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::MouseButtonRelease) {
            model_->finishDrag();
        }
        return QWidget::eventFilter(watched, event);
    }

  private:
    QWidget* buildBar() {
        auto* bar = new Panel(this);
        QVBoxLayout* column = columnIn(bar, Theme::gap, barMargins);
        distance_ = new FieldSlider(
            model_, "/centre_distance_mm", {0.0, 200.0, 0.1, 10.0, 2}, bar,
            {.label = tr("Distance &l"),
             .hint = tr("Distance from crank axis to shaft axis; α is kept."),
             .name = QStringLiteral("place_distance_mm"),
             // A new range is a new layout of the page: not at every step.
             .ends = [this] {
                 return std::pair(0.0, std::ceil(map_->largestDistance() / units::mm));
             }});
        column->addWidget(distance_);

        auto* row = new QHBoxLayout;
        row->setSpacing(Theme::space);
        auto* label = new QLabel(tr("&Criterion"), bar);
        criterion_ = new QComboBox(bar);
        criterion_->addItems({tr("range"), tr("RMS")});
        // As wide as there is room: a narrow window keeps the button whole.
        criterion_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        criterion_->setMinimumContentsLength(4);
        criterion_->setMaximumWidth(Theme::withText(180));
        criterion_->setObjectName(QStringLiteral("map_criterion"));
        criterion_->setAccessibleName(tr("Criterion of the places of the shaft"));
        criterion_->setToolTip(
            tr("Criterion of map and optimum, relative to no shaft: range of Mᵤₚₛ, or its RMS"));
        label->setBuddy(criterion_);
        connect(criterion_, &QComboBox::activated, this, [this](int index) {
            model_->setCriterion(static_cast<ShaftMapModel::Criterion>(index));
        });
        row->addWidget(label);
        row->addWidget(criterion_, 1);
        row->addStretch();
        best_ = new QPushButton(tr("&Best place"), bar);
        best_->setObjectName(QStringLiteral("go_best_place"));
        connect(best_, &QPushButton::clicked, map_, &ShaftMapModel::goToBest);
        row->addWidget(best_);
        column->addLayout(row);
        return bar;
    }

    QWidget* buildLimits() {
        auto* form = new Form(model_, this);
        FormSection* section = form->section(tr("Limits on the shaft's axis"));
        for (const char* place :
             {"/place_limits/centre_distance_min_mm", "/place_limits/centre_distance_max_mm",
              "/place_limits/shaft_angle_from_deg", "/place_limits/shaft_angle_to_deg",
              "/place_limits/left_mm", "/place_limits/right_mm", "/place_limits/bottom_mm",
              "/place_limits/top_mm"}) {
            form->number(place);
        }
        section->addWide(captionLabel(
            tr("Further limits, for example a crankcase wall; blank means no limit."), section));
        form->column()->addStretch();
        constexpr int enough = 340;  // no field stands far from its name
        form->setMaximumWidth(Theme::withText(enough));
        form->setObjectName(QStringLiteral("limits"));
        return form;
    }

    QWidget* buildSizes() {
        sizes_ = new PartPlot(model_, "front", this);
        sizes_->setObjectName(QStringLiteral("sizes"));
        sizes_->setPickable(true);
        sizes_->setToolTip(
            tr("Feasible places that are Pareto-optimal in range, RMS and size. Click to move "
               "the shaft."));
        sizes_->installEventFilter(this);
        connect(sizes_, &PlotView::pickedAt, this, &ShaftMapView::pickSize);
        return sizes_;
    }

    void showMap() {
        criterion_->setCurrentIndex(static_cast<int>(map_->criterion()));
        showStale();
        fitWords();
        showWords();
        showPresent();
    }

    void showPresent() {
        distance_->follow();
        // What the best place would change is seen from here.
        const QString why =
            nothingIsBuilt() ? messageText(map_->map()->buildable.reason) : map_->answer();
        const ShaftMapModel::Marker* best = map_->best();
        best_->setEnabled(best != nullptr && best->isBuildable && !map_->isAtBest());
        best_->setToolTip(why);
        plot_->setAccessibleDescription(map_->placeText(map_->present()));
    }

    void showStale() {
        const QString computing = tr("computing…");
        sizes_->setFaded(map_->isStale() || nothingIsBuilt(),
                         map_->isStale() ? computing : tr("no feasible position"));
    }

    /// though there is something to balance
    bool nothingIsBuilt() const {
        const ShaftMap* map = map_->map();
        return map != nullptr && map->best.reason.empty() && !map->buildable.reason.empty();
    }

    void showWords(const QString& hovered = {}) {
        const QString text = hovered.isEmpty() ? map_->answer() : hovered;
        words_->setText(text);
        words_->setToolTip(text);
    }

    /// Room for the words, so that the map rests while they change.
    void fitWords() {
        const bool isNarrow = width() < Theme::withText(500);
        const bool isWide = width() >= Theme::withText(600);
        // What is read under the pointer is shorter than the best place.
        const int needed =
            words_->fontMetrics()
                .boundingRect(QRect(0, 0, width(), 10000), Qt::TextWordWrap, map_->answer())
                .height();
        const int rows = isNarrow ? 5 : isWide ? 3 : 4;
        wordsRoom_->setFixedHeight(std::max(rows * words_->fontMetrics().lineSpacing(), needed) +
                                   2);
    }

    /// Goes to the place whose point lies nearest on the screen.
    void pickSize(double size, double change) {
        const ShaftMap* map = map_->map();
        if (map == nullptr || map->front.empty() || !sizes_->data().find("front")) {
            return;
        }
        const balance_shaft::BestPosition& nearest =
            map->front[nearestPoint(*sizes_, "front", size, change)];
        const QPointF away =
            sizes_->toPixel(nearest.criteria.size / units::cm2,
                            map_->change(nearest.criteria).value_or(0.0) / units::percent) -
            sizes_->toPixel(size, change);
        constexpr double reach = 40.0;  // pixels
        if (std::hypot(away.x(), away.y()) <= reach) {
            map_->moveTo(map_->shortened(nearest.position, map_->criterion()));
        }
    }

    BalanceShaftModel* model_;
    ShaftMapModel* map_;
    FieldSlider* distance_;
    QComboBox* criterion_;
    QPushButton* best_;
    QLabel* words_;
    QWidget* wordsRoom_;  ///< what the words may take
    ShaftMapPlot* plot_;
    PartPlot* sizes_;
};

}  // namespace

QWidget* ShaftTabs::buildMap() {
    return new ShaftMapView(model_, this);
}

}  // namespace ravnoves
