#include "report/sections.h"

#include <QSet>
#include <QTabWidget>
#include <algorithm>
#include <memory>
#include <optional>
#include <span>

#include "model/reference_case.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "page/scene_page.h"
#include "pictures/figure.h"
#include "report/figure_drawings.h"
#include "report/patience.h"
#include "studies/tolerance_bands.h"

namespace ravnoves {

using namespace paper;

namespace {

constexpr qint64 jobPatienceMs = 60'000;

QString titleOfTab(const ScenePage& page, const QString& tab) {
    for (const QTabWidget* tabs : page.findChildren<QTabWidget*>()) {
        for (int i = 0; i < tabs->count(); ++i) {
            if (tabs->widget(i)->objectName() == tab) {
                return tabs->tabText(i).remove(QLatin1Char('&'));
            }
        }
    }
    return tab;
}

/// The group of a tab, a new one where there is none.
PageGroup& groupOf(const ScenePage& page, const QString& tab, std::vector<PageGroup>& groups) {
    const auto found = std::ranges::find(groups, tab, &PageGroup::tab);
    return found != groups.end()
               ? *found
               : groups.emplace_back(PageGroup{.tab = tab, .title = titleOfTab(page, tab)});
}

/// Name of the tab of parts that a widget of the page is on; empty beside them.
QString tabOf(const QWidget* widget, std::span<const PagePart> parts) {
    for (const QWidget* at = widget; at != nullptr; at = at->parentWidget()) {
        const std::string name = at->objectName().toStdString();
        const bool isTab =
            !name.empty() && std::any_of(parts.begin(), parts.end(),
                                         [&](const PagePart& part) { return part.tab == name; });
        if (isTab) {
            return at->objectName();
        }
    }
    return {};
}

/// The same part of the reference; nothing where there is none.
std::optional<Content> ofReference(SceneModel& model, const PagePart& part) {
    const SceneModel* reference = model.referenceCase().model();
    return reference != nullptr ? std::optional(reference->part(part.id)) : std::nullopt;
}

void addFigure(const ScenePage& page, SceneModel& model, const PagePart& part, const Figure& figure,
               const PartSpread* spread, PageGroup& group, Paper& report) {
    PartPlot* own = partPlot(page, part.id);
    if (own != nullptr) {
        own->make();
    }
    if (own != nullptr && own->isDrawing() && !own->dataAsCsv().isEmpty()) {
        group.figures += report.figure(drawingOf(own));
        return;
    }
    const bool isEmpty = std::all_of(figure.curves.begin(), figure.curves.end(),
                                     [](const Figure::Curve& curve) { return curve.x.empty(); });
    if (isEmpty) {
        return;
    }
    auto plot = std::make_shared<PlotView>();
    plot->showFigure(figure);
    if (const auto reference = ofReference(model, part)) {
        plot->showReference(std::get_if<Figure>(&*reference), model.referenceCase().name());
    }
    if (spread != nullptr) {
        plot->setSpreads(spread->curves);
    }
    constexpr int width = 660;
    constexpr int high = 460;
    constexpr int low = 290;
    plot->resize(figure.equalScale ? high : width, figure.equalScale ? high : low);
    group.figures += report.figure(drawingOf(plot));
}

/// With their ±; its differences from the reference are in the table of variants.
void addTable(const ScenePage& page, const PagePart& part, const Results& results,
              const PartSpread* spread, PageGroup& group) {
    ResultRows rows = results.rows;
    if (spread != nullptr) {
        addSpreads(rows, spread->cells);
    }
    Results shown{results.columns};
    for (qsizetype i = 0; i < rows.size(); ++i) {
        if (!results.rows[i].isBlank()) {
            shown.rows << rows[i];
        }
    }
    Table table = tableOf(shown);
    if (const PartView* view = partView(page, part.id)) {
        table.caption = view->widget()->accessibleName();
    }
    table.isSmall = results.columns.size() > 6;
    group.tables += paper::table(table);
}

/// The pictures: that of the mechanism is part of the answer, else those beside the tabs.
void addPictures(ScenePage& page, std::vector<PageGroup>& groups, PageGroup& answer,
                 Paper& report) {
    std::vector<QWidget*> others;
    for (QWidget* picture : page.findChildren<QWidget*>()) {
        if (!isFigure(picture) || isEmptyFigure(picture) ||
            qobject_cast<PlotView*>(picture) != nullptr) {
            continue;
        }
        const QString tab = tabOf(picture, page.model()->parts());
        if (!tab.isEmpty()) {
            groupOf(page, tab, groups).figures += report.figure(drawingOf(picture));
        } else if (qobject_cast<MechanismPicture*>(picture) != nullptr) {
            answer.figures += report.figure(drawingOf(picture));
        } else {
            others.push_back(picture);
        }
    }
    PageGroup& beside = answer.figures.isEmpty() ? answer : groups.front();
    for (QWidget* picture : others) {
        beside.figures += report.figure(drawingOf(picture));
    }
}

}  // namespace

Tone toneOf(Severity severity) {
    switch (severity) {
        case Severity::error:
            return Tone::Error;
        case Severity::warning:
            return Tone::Warning;
        case Severity::good:
            return Tone::Good;
        case Severity::note:
            break;
    }
    return Tone::Text;
}

CaseParts caseParts(ScenePage& page, Paper& report, const Patience& patience) {
    const auto isBusy = [&page] { return page.isBusy(); };
    SceneModel& model = *page.model();
    model.needParts();
    if (SceneModel* reference = model.referenceCase().model()) {
        reference->needParts();
    }
    auto* bands = page.findChild<ToleranceBands*>(QString(), Qt::FindDirectChildrenOnly);
    patience.waitWhile(isBusy, jobPatienceMs);
    if (bands != nullptr) {
        bands->findAll();
        patience.waitWhile(isBusy, jobPatienceMs);
    }
    PageGroup answer;
    std::vector<PageGroup> groups(1);  // what is beside the tabs
    QSet<QString> said;
    for (const PagePart& part : model.parts()) {
        PageGroup& group = groupOf(
            page, QString::fromLatin1(part.tab.data(), static_cast<qsizetype>(part.tab.size())),
            groups);
        PageGroup& words = part.tab.empty() ? answer : group;
        const PartSpread* spread = bands != nullptr ? bands->spreadOf(part.id) : nullptr;
        if (spread != nullptr && model.study().empty() && !said.contains(spread->how)) {
            said.insert(spread->how);  // else the section of the tolerances says what ± is
            answer.words += paragraph(spread->how.toHtmlEscaped(), Tone::Muted);
        }
        const Content content = model.part(part.id);
        if (const auto* notes = std::get_if<Notes>(&content)) {
            for (const auto& [severity, line] : notes->lines) {
                if (!said.contains(line)) {
                    said.insert(line);
                    words.words += paragraph(
                        line.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br/>")),
                        toneOf(severity));
                }
            }
        } else if (const auto* results = std::get_if<Results>(&content)) {
            addTable(page, part, *results, spread, words);
        } else if (const auto* figure = std::get_if<Figure>(&content)) {
            addFigure(page, model, part, *figure, spread, group, report);
        }
        patience.wait();
    }
    addPictures(page, groups, answer, report);
    return {std::move(answer), std::move(groups)};
}

}  // namespace ravnoves
