#pragma once

#include "model/case_model_json.h"
#include "workshop/model/workshop_model.h"

/// What of WorkshopModel sees JSON, as case_model_json.h: the file that includes it says `template
/// class WorkshopModel<…Scene>;` too.
namespace ravnoves {

template <typename Scene>
Json WorkshopModel<Scene>::resultJson() const {
    try {
        return Scene::solvedJson(this->inputJson(), this->context());
    } catch (const InputError& error) {
        return {{"error", error.what()}};  // a sheet half filled has no result yet
    }
}

template <typename Scene>
Json WorkshopModel<Scene>::placeJson() const {
    return desk_.jobId() == 0 ? Json()
                              : Json{{"id", desk_.jobId()}, {"revision", desk_.jobRevision()}};
}

template <typename Scene>
void WorkshopModel<Scene>::takePlace(const Json& place) {
    const auto number = [&](const char* key) {
        return place.is_object() && place.contains(key) && place.at(key).is_number_integer()
                   ? place.at(key).get<qint64>()
                   : 0;
    };
    JournalJob job;
    job.id = number("id");
    job.revision = static_cast<int>(number("revision"));
    desk_.replaceInJournal(job);
}

/// A sheet without a job, such as a preset's, becomes one as any new job is: of today.
template <typename Scene>
CaseFile WorkshopModel<Scene>::asNew(const CaseFile& file) const {
    CaseFile next = file;
    try {
        Input input = Scene::read(file.input, this->context());
        if (input.job == decltype(input.job){}) {
            this->scene().startJob(input);
            next.input = Scene::write(input);
        }
    } catch (const InputError&) {
        return file;  // loading it says why
    }
    return next;
}

template <typename Scene>
void WorkshopModel<Scene>::takeJob(const CaseFile& file, bool isCopy) {
    Input next = Scene::read(file.input, this->context());
    if (isCopy) {
        next = nextOf(next);  // other parts
        next.job.technician = this->input().job.technician;
    }
    this->editText(QString::fromStdString(file.title),
                   isCopy ? QString() : QString::fromStdString(file.notes));
    // Undo must not bring another job's values under this job's number.
    isLoading_ = true;
    this->restart(next);
    if (!isCopy) {
        this->setVariants(variantsOf(file));
        this->setStudy(file.study.is_null() ? std::string() : file.study.dump());
    }
}

}  // namespace ravnoves
