#include "inertia-moments/inertia_moments_answer.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/engine_view.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"

namespace ravnoves {

InertiaMomentsAnswer::InertiaMomentsAnswer(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    setMinimumWidth(Theme::withText(332));
    setMaximumWidth(Theme::withText(480));
    QVBoxLayout* column = columnIn(this);

    picturePanel_ = new PicturePanel(
        new EngineView(model_), tr("Crank angle of the picture, from cylinder 1's axis"), this);
    column->addWidget(picturePanel_, 5);

    auto* panel = new Panel(this);
    auto* answerColumn = new QVBoxLayout(panel);
    answerColumn->setContentsMargins(Theme::gap, Theme::gap, Theme::gap, Theme::space);
    answerColumn->setSpacing(Theme::gap);
    tabs_ = new QTabWidget(panel);
    tabs_->setDocumentMode(true);
    addTable("orders", tr("Orders"), tr("Amplitudes and phases by order and plane"));
    addTable("rotating", tr("±kω"), tr("Forward and backward rotating parts by order"));
    addTable("shafts", tr("Shafts"), tr("Balance shafts"));
    addTable("weights", tr("Weights"), CounterweightView::name());
    addTable("left", tr("Residual"), tr("Residual by order"));
    answerColumn->addWidget(tabs_, 1);
    column->addWidget(panel, 5);
}

void InertiaMomentsAnswer::addTable(const char* part, const QString& title, const QString& name) {
    auto* table = new PartTable(model_, part, name, tabs_);
    table->setObjectName(QStringLiteral("table-") + QLatin1String(part));
    table->setShownRows(4);  // the picture has the same share of the height
    tabs_->setTabToolTip(tabs_->addTab(table, title), name);
}

}  // namespace ravnoves
