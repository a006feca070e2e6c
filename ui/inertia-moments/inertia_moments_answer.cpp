#include "inertia-moments/inertia_moments_page.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "inertia-moments/engine_view.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/presets.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/mechanism_picture.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {

namespace {

using Tabs = InertiaMomentsModel::Tabs;

constexpr int plotStep = 3;        // degrees between the points of one order
constexpr int cycleDegrees = 720;  // the paper's Fig. 6 shows two turns

}  // namespace

ResultTable* InertiaMomentsPage::addAnswerTable(const QString& title, const QString& name,
                                                const QStringList& columns) {
    auto* table = new ResultTable(answer_);
    table->setAccessibleName(name);
    table->setColumns(columns);
    table->setMinimumHeight(100);  // long tables scroll
    answer_->addTab(table, title);
    answer_->setTabToolTip(answer_->count() - 1, name);
    tables_.push_back(table);
    return table;
}

QWidget* InertiaMomentsPage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(332);
    holder->setMaximumWidth(480);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);

    picture_ = new EngineView(model_);
    auto* picturePanel = new PicturePanel(
        picture_, cycleDegrees, tr("Crank angle of the picture, from cylinder 1's axis"), holder);
    playAction_ = picturePanel->action();
    crank_ = picturePanel->slider();
    connect(crank_, &ValueSlider::valueEdited, model_, &InertiaMomentsModel::setCrankAngleDeg);
    column->addWidget(picturePanel, 5);

    auto* panel = new Panel(holder);
    auto* answerColumn = new QVBoxLayout(panel);
    answerColumn->setContentsMargins(Theme::gap, Theme::gap, Theme::gap, Theme::space);
    answerColumn->setSpacing(Theme::gap);
    answer_ = new QTabWidget(panel);
    answer_->setDocumentMode(true);
    answer_->setUsesScrollButtons(false);
    // Its long tables scroll: the picture has the same share of the height.
    answer_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    addAnswerTable(tr("Orders"), tr("Amplitudes and phases by order and plane"),
                   model_->orderColumns());
    addAnswerTable(tr("±kω"), tr("Forward and backward rotating parts by order"),
                   model_->rotatingColumns());
    addAnswerTable(tr("Shafts"), tr("Balance shafts"), model_->shaftColumns());
    addAnswerTable(tr("Weights"), tr("Rotating masses and counterweights"),
                   model_->weightColumns());
    addAnswerTable(tr("Left"), tr("What is left over, by order"), model_->remainingColumns());
    connect(answer_, &QTabWidget::currentChanged, this, [this](int index) {
        model_->setTab(Tabs::Answer, index);
        showAnswer();
    });
    answerColumn->addWidget(answer_, 1);
    warning_ = captionLabel({}, panel);
    warning_->setContentsMargins(Theme::gap, 0, Theme::gap, 0);
    warning_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const auto paintWarning = [this] { colourText(warning_, Theme::instance().warning()); };
    paintWarning();
    connect(&Theme::instance(), &Theme::changed, warning_, paintWarning);
    answerColumn->addWidget(warning_);
    column->addWidget(panel, 5);
    return holder;
}

void InertiaMomentsPage::showAnswer() {
    switch (answer_->currentIndex()) {
        case 0:
            tables_[0]->setRows(model_->orderRows());
            break;
        case 1:
            tables_[1]->setRows(model_->rotatingRows());
            break;
        case 2:
            tables_[2]->setRows(model_->shaftRows());
            break;
        case 3:
            tables_[3]->setRows(model_->weightRows());
            break;
        default:
            tables_[4]->setRows(model_->remainingRows());
            break;
    }
}

QString InertiaMomentsPage::resultsAsText() const {
    QString text;
    const std::vector<QVector<QStringList>> rows{model_->orderRows(), model_->rotatingRows(),
                                                 model_->shaftRows(), model_->weightRows(),
                                                 model_->remainingRows()};
    const std::vector<QStringList> columns{model_->orderColumns(), model_->rotatingColumns(),
                                           model_->shaftColumns(), model_->weightColumns(),
                                           model_->remainingColumns()};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        tables_[i]->setRows(rows[i]);
        text += tables_[i]->asText() + QLatin1Char('\n');
    }
    return text + model_->warningText() + QLatin1Char('\n');
}

QString InertiaMomentsPage::resultsAsCsv() const {
    resultsAsText();  // fills the tables that are not in front
    QString text;
    for (const ResultTable* table : tables_) {
        text += table->asCsv() + QLatin1Char('\n');
    }
    return text;
}

}  // namespace ravnoves
