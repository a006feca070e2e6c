#include "inertia-moments/inertia_moments_answer.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/engine_view.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "page/mechanism_picture.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/result_table.h"

namespace ravnoves {

using Model = InertiaMomentsModel;

InertiaMomentsAnswer::InertiaMomentsAnswer(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    setMinimumWidth(Theme::withText(332));
    setMaximumWidth(Theme::withText(480));
    QVBoxLayout* column = columnIn(this);

    picture_ = new EngineView(model_);
    picturePanel_ =
        new PicturePanel(picture_, tr("Crank angle of the picture, from cylinder 1's axis"), this);
    column->addWidget(picturePanel_, 5);

    auto* panel = new Panel(this);
    auto* answerColumn = new QVBoxLayout(panel);
    answerColumn->setContentsMargins(Theme::gap, Theme::gap, Theme::gap, Theme::space);
    answerColumn->setSpacing(Theme::gap);
    tabs_ = new QTabWidget(panel);
    tabs_->setDocumentMode(true);
    addTable(tr("Orders"), tr("Amplitudes and phases by order and plane"), &Model::orderResults);
    addTable(tr("±kω"), tr("Forward and backward rotating parts by order"),
             &Model::rotatingResults);
    addTable(tr("Shafts"), tr("Balance shafts"), &Model::shaftResults);
    addTable(tr("Weights"), CounterweightView::name(), &Model::weightResults);
    addTable(tr("Left"), tr("What is left over, by order"), &Model::remainingResults);
    connect(tabs_, &QTabWidget::currentChanged, this, &InertiaMomentsAnswer::showFront);
    answerColumn->addWidget(tabs_, 1);
    column->addWidget(panel, 5);

    connect(model_, &SceneModel::changed, this, &InertiaMomentsAnswer::showFront);
    showFront();
}

void InertiaMomentsAnswer::addTable(const QString& title, const QString& name, Find results) {
    auto* table = new ResultTable(name, tabs_);
    table->setResults((model_->*results)());
    table->setShownRows(4);  // the picture has the same share of the height
    tabs_->setTabToolTip(tabs_->addTab(table, title), name);
    tables_.push_back({table, results});
}

void InertiaMomentsAnswer::showFront() {
    const Table& front = tables_.at(static_cast<std::size_t>(tabs_->currentIndex()));
    front.table->setResults((model_->*front.results)());
}

void InertiaMomentsAnswer::fill() const {
    for (const Table& each : tables_) {
        each.table->setResults((model_->*each.results)());
    }
}

QString InertiaMomentsAnswer::asText() const {
    fill();
    QString text;
    for (const Table& each : tables_) {
        text += each.table->asText() + QLatin1Char('\n');
    }
    return text;
}

QString InertiaMomentsAnswer::asCsv() const {
    fill();
    QString text;
    for (const Table& each : tables_) {
        text += each.table->asCsv() + QLatin1Char('\n');
    }
    return text;
}

}  // namespace ravnoves
