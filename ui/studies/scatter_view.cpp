#include "studies/scatter_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "plot/plot_painter.h"
#include "studies/model/result_words.h"
#include "studies/model/study_model.h"
#include "text/csv_format.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr int unchosen = -1;
constexpr const char* chosenByHand = "chosenByHand";

/// A little wider than what it holds.
std::pair<double, double> roomFor(const std::vector<double>& values) {
    if (values.empty()) {
        return {0.0, 1.0};
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double least = 1e-9 * std::max(std::abs(*low), 1e-9);
    const double room = std::max(0.04 * (*high - *low), least);
    return {*low - room, *high + room};
}

}  // namespace

void CloudPlot::setPoints(std::vector<double> x, std::vector<double> y) {
    x_ = std::move(x);
    y_ = std::move(y);
    groundChanged();
}

void CloudPlot::paintGround(QPainter& painter) {
    constexpr std::size_t few = 300;
    painter.save();
    painter.setClipRect(plotArea());
    painter.setRenderHint(QPainter::Antialiasing);
    QColor colour = Theme::instance().curve(2);
    colour.setAlphaF(x_.size() > few ? 0.6F : 0.85F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const double radius = strokeScale() * (x_.size() > few ? 1.8 : 2.4);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        painter.drawEllipse(toPixel(x_[i], y_[i]), radius, radius);
    }
    painter.restore();
}

QString CloudPlot::csv(const CsvFormat& format) const {
    if (x_.empty()) {
        return {};
    }
    QString table = format.field(data().x.spec.title) + format.separator +
                    format.field(data().left.spec.title) + QLatin1Char('\n');
    for (std::size_t i = 0; i < x_.size(); ++i) {
        table += format.number(data().x.spec.factor * x_[i]) + format.separator +
                 format.number(data().left.spec.factor * y_[i]) + QLatin1Char('\n');
    }
    return table;
}

QString CloudPlot::sentence() const {
    return x_.empty()
               ? title()
               : tr("%1. %2 from %3 to %4, over %5 from %6 to %7.")
                     .arg(title(), data().left.spec.title,
                          data().left.readout(*std::min_element(y_.begin(), y_.end()), locale()),
                          data().left.readout(*std::max_element(y_.begin(), y_.end()), locale()),
                          data().x.spec.title,
                          data().x.readout(*std::min_element(x_.begin(), x_.end()), locale()),
                          data().x.readout(*std::max_element(x_.begin(), x_.end()), locale()));
}

ScatterView::ScatterView(StudyModel* study, QWidget* parent) : QWidget(parent), study_(study) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::gap);
    auto* row = new QHBoxLayout;
    const auto chooser = [&](const QString& text, const char* name) {
        auto* label = new QLabel(text, this);
        auto* box = new QComboBox(this);
        box->setObjectName(QLatin1String(name));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
        label->setBuddy(box);
        row->addWidget(label);
        row->addWidget(box, 1);
        connect(box, &QComboBox::activated, this, [this, box] {
            box->setProperty(chosenByHand, true);
            showSamples();
        });
        return box;
    };
    up_ = chooser(tr("U&p"), "scatter_up");
    across_ = chooser(tr("A&cross"), "scatter_across");
    column->addLayout(row);
    plot_ = new CloudPlot({}, this);
    column->addWidget(plot_, 1);
    connect(study_, &StudyModel::changed, this, &ScatterView::fillChoices);
    connect(study_, &StudyModel::answered, this, &ScatterView::showSamples);
    fillChoices();
}

void ScatterView::fillChoices() {
    titles_.clear();
    for (const studies::Varied& varied : study_->study().vary) {
        titles_.push_back(study_->inputTitle(varied.pointer));
    }
    const auto inputs = static_cast<int>(titles_.size());
    for (const studies::Watched& watched : study_->study().watch) {
        titles_.push_back({resultName(watched.pointer).ownTitle()});
    }
    QStringList names;
    for (const ShownTitle& title : titles_) {
        names << shownTitle(title.text).text;  // as the axis has it
    }
    for (QComboBox* box : {across_, up_}) {
        const QSignalBlocker block(box);
        const QString before = box->currentText();
        box->clear();
        box->addItems(names);
        const int same = box->property(chosenByHand).toBool() ? box->findText(before) : unchosen;
        // At first a result over an input.
        box->setCurrentIndex(same >= 0         ? same
                             : box == up_      ? std::min<int>(inputs, box->count() - 1)
                             : names.isEmpty() ? unchosen
                                               : 0);
    }
    showSamples();
}

void ScatterView::showSamples() {
    const StudyAnswers* answers = study_->answers();
    const auto x = static_cast<std::size_t>(std::max(across_->currentIndex(), 0));
    const auto y = static_cast<std::size_t>(std::max(up_->currentIndex(), 0));
    std::vector<double> across;
    std::vector<double> up;
    const auto columns = static_cast<std::size_t>(across_->count());
    if (answers != nullptr && !study_->isStale()) {
        for (const std::vector<double>& sample : answers->samples) {
            if (sample.size() == columns && x < columns && y < columns) {
                across.push_back(titles_[x].factor * sample[x]);
                up.push_back(titles_[y].factor * sample[y]);
            }
        }
    }
    const bool isFaded = study_->isStale();
    plot_->setFaded(isFaded, isFaded ? tr("Computing …") : QString());
    if (isFaded) {
        return;
    }
    const auto [left, right] = roomFor(across);
    const auto [low, high] = roomFor(up);
    const auto title = [&](std::size_t column) {
        return column < titles_.size() ? titles_[column].text : QString();
    };
    plot_->setXAxis({title(x), left, right});
    plot_->setYAxis(PlotView::Side::Left, {title(y)});
    plot_->setYRange(PlotView::Side::Left, low, high);
    plot_->setTitle(across.empty() ? tr("No samples: the method takes none, or they are on the way")
                                   : tr("Samples: %1, correlation %2")
                                         .arg(across.size())
                                         .arg(fixedDecimals(StudyModel::correlation(across, up), 2,
                                                            QLocale())));
    plot_->setPoints(std::move(across), std::move(up));
}

}  // namespace ravnoves
