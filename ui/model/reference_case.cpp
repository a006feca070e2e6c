#include "model/reference_case.h"

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/scene_model.h"
#include "model/variant_files.h"

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
    trouble_.clear();
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
        if (model_ == nullptr) {
            model_ = present_->another(true);
            shown_.clear();
            for (const auto signal :
                 {&SceneModel::changed, &SceneModel::viewChanged, &SceneModel::shownChanged}) {
                connect(model_.get(), signal, this, &ReferenceCase::changed);
            }
        }
        if (shown_ != variant.input) {
            model_->loadCase(present_->variantInput(place), present_->context(), variant.name);
            shown_ = variant.input;
            takeView();
            if (const QString files = changedFilesText(*present_, place); !files.isEmpty()) {
                Q_EMIT said(tr("Reference %1: %2").arg(name_, files));
            }
        }
    } catch (const InputError&) {
        trouble_ = present_->variantTrouble(place);
        model_.reset();
        Q_EMIT said(tr("Reference %1: %2").arg(name_, trouble_));
    }
    Q_EMIT changed();
}

void ReferenceCase::takeView() {
    if (model_ != nullptr) {
        model_->takeView(*present_);
    }
}

}  // namespace ravnoves
