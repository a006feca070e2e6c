#include "page/part_views.h"

#include <algorithm>

#include "model/reference_case.h"
#include "page/rejected_verdict.h"
#include "text/message_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

PartView::PartView(SceneModel* model, std::string_view id, QWidget* widget)
    : model_(model), id_(id), widget_(widget) {
    const auto outdateOwn = [this] { outdate(false); };
    for (const auto signal : {&SceneModel::changed, &SceneModel::viewChanged,
                              &SceneModel::shownChanged, &SceneModel::rested}) {
        QObject::connect(model, signal, widget, outdateOwn);
    }
    QObject::connect(&model->referenceCase(), &ReferenceCase::changed, widget,
                     [this] { outdate(true); });
}

void PartView::outdate(bool ofReference) {
    (ofReference ? isReferenceStale_ : isStale_) = true;
    if (isSeen()) {
        shown();
    }
}

void PartView::shown() {
    model_->needPart(id_);
    if (SceneModel* reference = model_->referenceCase().model()) {
        reference->needPart(id_);
    }
    make();
}

void PartView::make() {
    if (std::exchange(isStale_, false)) {
        showPart(model_->part(id_));
    }
    if (std::exchange(isReferenceStale_, false)) {
        const ReferenceCase& reference = model_->referenceCase();
        if (reference.model() != nullptr) {
            const Content content = reference.model()->part(id_);
            showReference(&content, reference.name());
        } else {
            showReference(nullptr, {});
        }
    }
}

std::vector<PartView*> PartView::below(const QWidget& page, bool seenAlone) {
    std::vector<PartView*> views;
    for (QWidget* widget : page.findChildren<QWidget*>()) {
        auto* view = dynamic_cast<PartView*>(widget);
        if (view != nullptr && (!seenAlone || widget->isVisible())) {
            views.push_back(view);
        }
    }
    return views;
}

PartPlot::PartPlot(SceneModel* model, std::string_view id, QWidget* parent)
    : PlotView(parent), PartView(model, id, this) {}

void PartPlot::showEvent(QShowEvent* event) {
    PlotView::showEvent(event);
    shown();
}

void PartPlot::showPart(const Content& content) {
    const auto* figure = std::get_if<Figure>(&content);
    showFigure(figure != nullptr ? *figure : Figure());
}

void PartPlot::showReference(const Content* content, const QString& name) {
    PlotView::showReference(content != nullptr ? std::get_if<Figure>(content) : nullptr, name);
}

namespace {

/// What is to be known before what is copied is used.
QString warningOf(const SceneModel& model) {
    const QString stop = model.stopText();
    return stop.isEmpty() ? messageText(rejectedNote(model)) : stop;
}

}  // namespace

QString answerOf(const QWidget& page, bool asCsv) {
    QString text;
    const std::vector<PartView*> views = PartView::below(page, false);
    if (views.empty()) {
        return text;
    }
    const SceneModel& model = *views.front()->partModel();
    text = ResultTable::lineAbove(warningOf(model), asCsv);
    for (const PagePart& part : model.parts()) {
        if (!part.isAnswer) {
            continue;
        }
        if (auto* table = dynamic_cast<PartTable*>(partView(page, part.id))) {
            table->make();  // seen or not
            text += (asCsv ? table->asCsv() : table->asText()) + QLatin1Char('\n');
            continue;
        }
        const Content content = asCsv ? Content() : model.part(part.id);
        if (const auto* notes = std::get_if<Notes>(&content)) {
            for (const auto& [severity, line] : notes->lines) {
                text += line + QLatin1Char('\n');
            }
        }
    }
    if (const auto verdict =
            !asCsv && model.stopText().isEmpty() ? model.verdictShown() : std::nullopt) {
        text += messageText(verdict->text) + QLatin1Char('\n');
    }
    return text;
}

PartView* partView(const QWidget& page, std::string_view id) {
    const std::vector<PartView*> views = PartView::below(page, false);
    const auto found = std::ranges::find(views, id, &PartView::id);
    return found != views.end() ? *found : nullptr;
}

PartPlot* partPlot(const QWidget& page, std::string_view id) {
    return dynamic_cast<PartPlot*>(partView(page, id));
}

PartTable::PartTable(SceneModel* model, std::string_view id, const QString& name, QWidget* parent)
    : ResultTable(name, parent), PartView(model, id, this) {}

QString PartTable::warning() const {
    return warningOf(*partModel());
}

void PartTable::showEvent(QShowEvent* event) {
    ResultTable::showEvent(event);
    shown();
}

void PartTable::showPart(const Content& content) {
    const auto* results = std::get_if<Results>(&content);
    setResults(results != nullptr ? *results : Results());
    if (hidesWhereEmpty_) {
        setVisible(rowCount() > 0);
    }
}

void PartTable::hideWhereEmpty() {
    hidesWhereEmpty_ = true;
    make();
    setVisible(rowCount() > 0);
}

void PartTable::showReference(const Content* content, const QString& name) {
    ResultTable::showReference(content != nullptr ? std::get_if<Results>(content) : nullptr, name);
}

void PartTable::showSpread(const PartSpread& spread) {
    setSpreads(spread.cells, spread.how);
}

void PartTable::clearSpread(bool another) {
    another ? awaitSpreads() : setSpreads({});
}

PartText::PartText(SceneModel* model, std::string_view id, QWidget* parent)
    : AnswerLabel(parent), PartView(model, id, this) {
    setFont(Theme::font(Theme::smallSize));
    colourText(this, &Theme::mutedText);
}

void PartText::showEvent(QShowEvent* event) {
    AnswerLabel::showEvent(event);
    shown();
}

void PartText::showPart(const Content& content) {
    QStringList lines;
    if (const auto* notes = std::get_if<Notes>(&content)) {
        for (const auto& [severity, line] : notes->lines) {
            lines << line;
        }
    }
    // No unit is broken behind its stroke.
    setText(lines.join(QLatin1Char('\n')).replace(u'/', QStringLiteral("/\u2060")));
}

}  // namespace ravnoves
