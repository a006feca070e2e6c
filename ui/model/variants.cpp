// What SceneModel keeps beside the present input.

#include "model/variants.h"

#include <algorithm>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "model/scene_model.h"
#include "scenes/case_sources.h"

namespace ravnoves {

namespace {

bool isTaken(const QList<Variant>& variants, const QString& name) {
    return std::any_of(variants.begin(), variants.end(),
                       [&](const Variant& variant) { return variant.name == name; });
}

/// A, B, …, Z, A2, …: the first name that no variant has.
QString nextVariantName(const QList<Variant>& variants) {
    QString name;
    for (int i = 0; name.isEmpty() || isTaken(variants, name); ++i) {
        name = QChar(static_cast<char16_t>(u'A' + i % 26));
        if (i >= 26) {
            name += QString::number(i / 26 + 1);
        }
    }
    return name;
}

}  // namespace

CaseTexts textsOf(const CaseFile& file) {
    Variants variants;
    for (const CaseVariant& variant : file.variants) {
        if (variant.name == file.reference) {
            variants.reference = static_cast<int>(variants.list.size());
        }
        variants.list.push_back({QString::fromStdString(variant.name), variant.input.dump()});
    }
    return {QString::fromStdString(file.title), QString::fromStdString(file.notes), variants,
            file.study.is_null() ? std::string() : file.study.dump()};
}

void SceneModel::setTexts(const CaseTexts& next) {
    texts_.notes = next.notes;
    setTitle(next.title);
    if (!(next.variants == texts_.variants)) {
        Variants& variants = texts_.variants = next.variants;
        variants.reference =
            std::min(variants.reference, static_cast<int>(variants.list.size()) - 1);
        Q_EMIT variantsChanged();
    }
    if (next.study != texts_.study) {
        texts_.study = next.study;
        Q_EMIT studyChanged();
    }
}

void SceneModel::editText(const QString& title, const QString& notes) {
    CaseTexts next = texts_;
    next.title = title;
    next.notes = notes;
    changeTexts(tr("Title and notes"), next);
}

void SceneModel::changeStudy(const QString& name, const std::string& study) {
    CaseTexts next = texts_;
    next.study = study;
    changeTexts(name, next);
}

void SceneModel::changeVariants(const QString& name, const Variants& variants) {
    CaseTexts next = texts_;
    next.variants = variants;
    changeTexts(name, next);
}

void SceneModel::chooseReference(int place) {
    place = place >= 0 && place < texts_.variants.list.size() ? place : -1;
    if (texts_.variants.reference != place) {
        texts_.variants.reference = place;
        Q_EMIT variantsChanged();
    }
}

void SceneModel::keepVariant(const QString& name) {
    Variants next = texts_.variants;
    const bool usable = !name.trimmed().isEmpty() && !isTaken(next.list, name.trimmed());
    next.list.push_back({usable ? name.trimmed() : nextVariantName(next.list), inputJson().dump()});
    next.reference = static_cast<int>(next.list.size()) - 1;
    changeVariants(tr("Keep variant %1").arg(next.list.back().name), next);
}

QString SceneModel::renameVariant(int place, const QString& name) {
    Variants next = texts_.variants;
    const QString trimmed = name.trimmed();
    if (trimmed == next.list.at(place).name) {
        return {};
    }
    if (trimmed.isEmpty()) {
        return tr("Enter a name for the variant.");
    }
    if (isTaken(next.list, trimmed)) {
        return tr("Another variant has the name %1.").arg(trimmed);
    }
    next.list[place].name = trimmed;
    changeVariants(tr("Rename variant"), next);
    return {};
}

void SceneModel::removeVariant(int place) {
    Variants next = texts_.variants;
    const QString name = next.list.takeAt(place).name;
    if (next.reference == place) {
        next.reference = -1;
    } else if (next.reference > place) {
        --next.reference;
    }
    changeVariants(tr("Delete variant %1").arg(name), next);
}

QString SceneModel::changedFilesText(int variant) const {
    QStringList names;
    for (const std::string& name :
         changed_files(parse_json(texts_.variants.list.at(variant).input), context_)) {
        names << QString::fromStdString(name);
    }
    return names.isEmpty()
               ? QString()
               : tr("%1 has changed since this variant was kept: its results use the present file.")
                     .arg(names.join(QStringLiteral(", ")));
}

Json SceneModel::variantInput(int place) const {
    return parse_json(texts_.variants.list.at(place).input);
}

}  // namespace ravnoves
