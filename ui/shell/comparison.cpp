#include "shell/comparison.h"

#include <algorithm>
#include <iterator>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/variant_files.h"
#include "page/compared_figure.h"
#include "page/scene_page.h"
#include "plot/plot_view.h"
#include "shell/scene_list.h"
#include "text/error_text.h"
#include "widgets/page_columns.h"
#include "widgets/result_table.h"

namespace ravnoves {

namespace {

/// The page's plots, or its tables, in the order in which they were made: their order as children
/// changes with what is in front.
template <typename Part>
QList<Part*> partsOf(const ScenePage& page) {
    QList<Part*> parts = page.findChildren<Part*>();
    std::sort(parts.begin(), parts.end(),
              [](const Part* a, const Part* b) { return a->number() < b->number(); });
    return parts;
}

template <typename Part>
void connectAll(const ScenePage& page, const ScenePage* twin, const QString& name) {
    const QList<Part*> parts = partsOf<Part>(page);
    const QList<Part*> others = twin != nullptr ? partsOf<Part>(*twin) : QList<Part*>();
    for (qsizetype i = 0; i < parts.size(); ++i) {
        parts[i]->setReference(others.value(i), name);
    }
}

}  // namespace

Comparison::Comparison(ScenePage* page) : QObject(page), page_(page) {
    page->addBusy([this] { return twin_ != nullptr && twin_->isBusy(); });
    connect(page->model(), &SceneModel::variantsChanged, this, &Comparison::showReference);
    connect(page->model(), &SceneModel::changed, this, &Comparison::takeView);
    connect(page->model(), &SceneModel::viewChanged, this, &Comparison::takeView);
    showReference();  // of a model that another page has left
}

Comparison::~Comparison() = default;

void Comparison::showReference() {
    SceneModel& model = *page_->model();
    const int place = model.reference();
    trouble_.clear();
    if (place < 0) {
        connectParts({});
        twin_.reset();
        shown_.clear();
        return;
    }
    const Variant& variant = model.variants().at(place);
    try {
        if (twin_ == nullptr) {
            for (const SceneInfo& info : sceneList()) {
                if (info.name == model.sceneName()) {
                    twin_.reset(info.make(nullptr, nullptr));
                }
            }
            shown_.clear();
            const auto outdate = [this] { stale_ = true; };
            connect(twin_->model(), &SceneModel::changed, this, outdate);
            connect(twin_->model(), &SceneModel::viewChanged, this, outdate);
        }
        if (shown_ != variant.input) {
            twin_->model()->loadCase(model.variantInput(place), model.context(), variant.name);
            twin_->model()->takeView(model);
            shown_ = variant.input;
            fill();
            const QString changed = changedFilesText(model, place);
            if (!changed.isEmpty()) {
                Q_EMIT page_->status(tr("Reference %1: %2").arg(variant.name, changed));
            }
        }
        connectParts(variant.name);
    } catch (const InputError&) {
        trouble_ = model.variantTrouble(place);
        connectParts({});
        twin_.reset();
        Q_EMIT page_->status(tr("Reference %1: %2").arg(variant.name, trouble_));
    }
}

void Comparison::takeView() {
    if (twin_ != nullptr) {
        twin_->model()->takeView(*page_->model());
        if (stale_) {
            fill();
        }
    }
}

void Comparison::connectParts(const QString& name) {
    const ScenePage* twin = name.isEmpty() ? nullptr : twin_.get();
    connectAll<PlotView>(*page_, twin, name);
    connectAll<ResultTable>(*page_, twin, name);
    connectAll<ComparedFigure>(*page_, twin, name);
}

void Comparison::fill() {
    stale_ = false;
    QList<QWidget*> parts;
    const auto add = [&parts](const auto& some) {
        std::copy(some.begin(), some.end(), std::back_inserter(parts));
    };
    add(partsOf<PlotView>(*twin_));
    add(partsOf<ResultTable>(*twin_));
    add(partsOf<ComparedFigure>(*twin_));
    fillUnseen(*twin_, parts);
}

}  // namespace ravnoves
