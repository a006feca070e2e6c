#include "model/scene_model.h"

#include <utility>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/reference_case.h"
#include "numerics/demand.h"
#include "scenes/scenes.h"
#include "text/field_names.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/plain_title.h"

namespace ravnoves {

QString SceneModel::titleOf(const std::string& scene) {
    return shownText(scene_solver(scene).title);
}

ReferenceCase& SceneModel::referenceCase() {
    if (referenceCase_ == nullptr) {
        referenceCase_ = new ReferenceCase(this);
    }
    return *referenceCase_;
}

void SceneModel::needParts() {
    for (const PagePart& part : parts()) {
        needPart(part.id);
    }
}

SceneModel::SceneModel(QObject* parent) : QObject(parent) {
    connect(&history_, &QUndoStack::indexChanged, this, &SceneModel::historyChanged);
    connect(&history_, &QUndoStack::cleanChanged, this, &SceneModel::historyChanged);
}

void SceneModel::beginEditing() {
    endEditing();
    finishDrag();
    editing_ = true;
}

void SceneModel::endEditing(bool isRejected) {
    const bool isStep = isTyped();
    if (std::exchange(editing_, false)) {
        finishDrag();
        editingEnds();
        if (isStep) {
            Q_EMIT historyChanged();
        }
    }
    if (!isRejected) {
        setRejection({});
    }
}

bool SceneModel::isTyped() const {
    return editing_ && history_.canUndo() && history_.command(history_.index() - 1)->id() == step_;
}

bool SceneModel::takeBack() {
    if (!isTyped()) {
        return false;
    }
    auto* typed = const_cast<QUndoCommand*>(history_.command(history_.index() - 1));
    typed->undo();
    typed->setObsolete(true);  // the history drops it
    history_.undo();
    return true;
}

int SceneModel::stepOf(const QString& name) {
    if (name != lastName_) {
        // What else changes in an editing is no part of it.
        editing_ = editing_ && lastName_.isEmpty();
        ++step_;
        lastName_ = name;
    }
    moved_ = moved_ || !editing_;
    return step_;
}

void SceneModel::undo() {
    if (!hasRejected()) {
        history_.undo();
        finishDrag();
    }
    Q_EMIT broughtIn();
    if (!std::exchange(rejectedIn_, {}).isEmpty()) {
        Q_EMIT rejectedInChanged();
    }
}

void SceneModel::redo() {
    history_.redo();
    finishDrag();
    Q_EMIT broughtIn();
}

void SceneModel::setRejection(const QString& why) {
    if (hasRejection_ || !why.isEmpty()) {
        hasRejection_ = !why.isEmpty();
        Q_EMIT rejected(why);
    }
}

Json SceneModel::keptJson() const {
    return nullptr;
}

Json SceneModel::placeJson() const {
    return nullptr;
}

void SceneModel::noteRejected(QObject* where, bool isRejected) {
    if (!isRejected) {
        const bool isNewest = hasRejected() && where == rejectedIn_.last();
        forgetRejectedIn(where);
        if (isNewest) {
            setRejection({});  // what was said of it
        }
        return;
    }
    rejectedIn_.removeOne(where);
    rejectedIn_.append(where);
    connect(where, &QObject::destroyed, this, &SceneModel::forgetRejectedIn, Qt::UniqueConnection);
    Q_EMIT rejectedInChanged();
}

void SceneModel::forgetRejectedIn(QObject* where) {
    if (rejectedIn_.removeOne(where)) {
        Q_EMIT rejectedInChanged();
    }
}

CaseFile SceneModel::caseFile() const {
    CaseFile file{sceneName().toStdString(), texts_.title.toStdString(), inputJson()};
    file.notes = texts_.notes.toStdString();
    file.kept = keptJson();
    file.study = texts_.study.empty() ? Json() : Json::parse(texts_.study);
    // What scatters is given, also where it is left to its default.
    if (file.study.is_object() && file.study.contains("vary") && file.study["vary"].is_object()) {
        std::vector<std::string> varied;
        for (const auto& [pointer, spread] : file.study["vary"].items()) {
            varied.push_back(pointer);
        }
        giveDefaults(file.input, varied);
    }
    for (const Variant& variant : texts_.variants.list) {
        file.variants.push_back({variant.name.toStdString(), parse_json(variant.input)});
    }
    if (texts_.variants.reference >= 0) {
        file.reference = texts_.variants.list.at(texts_.variants.reference).name.toStdString();
    }
    return file;
}

void SceneModel::giveDefaults(Json& input, const std::vector<std::string>& pointers) const {
    for (const std::string& pointer : pointers) {
        if (!pointer.starts_with('/') || input.contains(Json::json_pointer(pointer))) {
            continue;
        }
        const Json::json_pointer place(pointer);
        const auto field = fields(pointer);
        // An object that is not there is no default: giving it would change the case.
        if (!field.empty() && std::holds_alternative<double>(field.front().value) &&
            input.contains(place.parent_pointer()) &&
            input.at(place.parent_pointer()).is_object()) {
            input[place] = std::get<double>(field.front().value);
        }
    }
}

QString SceneModel::explain(const InputError& error) const {
    if (const auto* rejected = dynamic_cast<const RejectedInput*>(&error)) {
        return rejected->said();
    }
    return FieldNames({fields(), describedFields()}).errorText(error);
}

void SceneModel::loadCase(const Json& input, const CaseContext& context, const QString& title) {
    loadFile({sceneName().toStdString(), title.toStdString(), input}, context);
}

void SceneModel::loadInput(const Json& input, const CaseContext& context, const QString& /*name*/) {
    CaseFile file = caseFile();
    file.input = input;
    loadFile(file, context);
}

bool SceneModel::setViewOption(const QString& /*key*/, const QString& /*value*/) {
    return false;
}

double SceneModel::readNumber(const QString& key, const QString& value) {
    const auto number = readFormNumber(value);
    if (!number) {
        throw InputError(key.toStdString(), Text::tr("must be a number"), value.toStdString());
    }
    return *number;
}

int SceneModel::oneOf(const QString& key, const QString& value, const QStringList& words) {
    const auto place = words.indexOf(value);
    if (place < 0) {
        std::vector<std::string> known;
        for (const QString& word : words) {
            known.push_back(word.toStdString());
        }
        throw InputError(key.toStdString(), {Text::tr("must be one of %1"), quoted_list(known)},
                         value.toStdString());
    }
    return static_cast<int>(place);
}

FieldEntry SceneModel::describedField(std::string_view pointer) const {
    const std::vector<FieldEntry> found = describedFields(pointer);
    RAVNOVES_DEMAND(!found.empty(), "a form's field is in the input");
    return found.front();
}

CaseFile SceneModel::asNew(const CaseFile& file) const {
    return file;
}

QString SceneModel::titleText(const QString& title) {
    return plainTitle(title.endsWith(changedMark)
                          ? tr("%1 (changed)").arg(title.chopped(changedMark.size()))
                          : title);
}

void SceneModel::setTitle(const QString& title) {
    if (texts_.title != title) {
        texts_.title = title;
        Q_EMIT titleChanged(title);
    }
}

void SceneModel::setByKey(const QString& key, const QString& value) {
    if (key == QLatin1String("reference") && hasCaseFile()) {
        QStringList names{QStringLiteral("none")};
        for (const Variant& variant : texts_.variants.list) {
            names << variant.name;
        }
        chooseReference(oneOf(key, value, names) - 1);
        return;
    }
    if (setViewOption(key, value)) {
        return;
    }
    const std::string path = (QLatin1Char('/') + key).toStdString();
    Json input = inputJson();
    Json parsed;
    try {
        parsed = parse_json(value.toStdString());
    } catch (const InputError&) {
        parsed = value.toStdString();  // a bare word
    }
    try {
        set_input_value(input, path, parsed);
    } catch (const Json::exception&) {  // "~" with neither 0 nor 1
        throw InputError::unknown_key("/input" + path);
    }
    loadInput(input, context_);
}

}  // namespace ravnoves
