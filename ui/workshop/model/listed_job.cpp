#include "workshop/model/listed_job.h"

#include <exception>

#include "case-file/field_reader.h"
#include "case-file/json.h"
#include "v8-plugs/compensation.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

namespace {

/// Of a job without plugs, in the language of the list.
QString listedEngine(const Words& words, const JournalJob& job) {
    try {
        const Json engine = parse_json(job.form.toStdString()).at("input").at("engine");
        return WorkshopModel::engineName(
            words, read_fields<bob_weights::Engine>(engine, Completeness::as_is));
    } catch (const std::exception&) {
        return job.engine;  // a sheet that cannot be read says so when it is opened
    }
}

}  // namespace

ListedJob listedJob(const Words& words, const JournalJob& job) {
    if (job.process.isEmpty()) {
        return {listedEngine(words, job),
                job.bobWeight ? words.translate("BobWeights", "Bob weight %1")
                                    .arg(words.number(*job.bobWeight * units::gram, units::gram, 1))
                              : QStringLiteral("–")};
    }
    ListedJob text{v8_text::engineName(words, job.engine.toStdString()), job.recommended};
    if (job.recommended.isEmpty()) {
        text.result = QStringLiteral("–");
    } else if (job.recommended == QLatin1String("none-needed")) {
        text.result = words.translate("ravnoves::WorkshopPage", "no action required");
    } else if (job.recommended == QLatin1String("not-compensated")) {
        text.result = words.translate("ravnoves::WorkshopPage", "not compensated");
    }
    for (const v8_plugs::OptionId id : v8_plugs::all_options) {
        if (job.recommended.toStdString() == v8_plugs::option_word(id).word) {
            text.result = v8_text::optionName(words, id);
            if (job.reduction) {
                text.result +=
                    QStringLiteral(", ") + v8_text::grams(words, *job.reduction * units::gram);
            }
        }
    }
    return text;
}

}  // namespace ravnoves
