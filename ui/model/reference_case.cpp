#include "model/reference_case.h"

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/scene_model.h"

namespace ravnoves {

ReferenceCase::ReferenceCase(SceneModel* present) : QObject(present), present_(present) {
    connect(present, &SceneModel::variantsChanged, this, &ReferenceCase::follow);
    connect(present, &SceneModel::changed, this, &ReferenceCase::takeView);
    connect(present, &SceneModel::viewChanged, this, &ReferenceCase::takeView);
    follow();
}

ReferenceCase::~ReferenceCase() = default;

void ReferenceCase::follow() {
    const int place = present_->reference();
    if (place < 0 || present_->parts().empty()) {
        if (model_ != nullptr) {
            model_.reset();
            shown_.clear();
            Q_EMIT changed();
        }
        return;
    }
    const Variant& variant = present_->variants().at(place);
    name_ = variant.name;
    try {
        if (model_ == nullptr || shown_ != variant.input) {
            // Anew: what its jobs had computed is of no other variant.
            model_ = present_->another(true);
            model_->loadCase(parse_json(variant.input), present_->context(), variant.name);
            shown_ = variant.input;
            takeView();
            for (const auto signal :
                 {&SceneModel::changed, &SceneModel::viewChanged, &SceneModel::shownChanged}) {
                connect(model_.get(), signal, this, &ReferenceCase::changed);
            }
            if (const QString files = present_->changedFilesText(place); !files.isEmpty()) {
                Q_EMIT said(tr("Reference %1: %2").arg(name_, files));
            }
        }
    } catch (const InputError& error) {
        model_.reset();
        Q_EMIT said(tr("Reference %1: %2").arg(name_, present_->explain(error)));
    }
    Q_EMIT changed();
}

void ReferenceCase::takeView() {
    if (model_ != nullptr) {
        model_->takeView(*present_);
    }
}

}  // namespace ravnoves
