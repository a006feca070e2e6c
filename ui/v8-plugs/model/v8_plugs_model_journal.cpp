// What the journal keeps of a job.

#include "v8-plugs/fields.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "workshop/model/verdict.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {
using units::gram;
using units::gram_mm;
}  // namespace

bool V8PlugsModel::hasNumbers() const {
    const auto& machine = input().balancing;
    return input().changes_known() || input().has_typed_changes() ||
           (input().weigh_in && !input().weigh_in->is_empty()) ||
           (machine && (machine->front_reading || machine->rear_reading));
}

bool V8PlugsModel::isEngineOf(const CaseFile& job) const {
    // As they are written, without the name and the preset.
    const auto values = [](const Input& input) {
        Input alone;
        alone.engine = input.engine;
        alone.engine.name.clear();
        return write_input(alone).at("engine");
    };
    return values(read_input(job.input, Completeness::as_is)) == values(input());
}

JournalJob V8PlugsModel::journalEntry() const {
    JournalJob job = JobDesk::entryOf(input().job);
    job.engine = QString::fromStdString(input().engine.name);
    const std::string process(process_words[static_cast<std::size_t>(input().process)].word);
    job.process = QString::fromStdString(process);
    if (solution().unbalanced_mass) {
        job.unbalancedMass = *solution().unbalanced_mass / gram;
    }
    if (solution().advice) {
        if (solution().advice->kind == Advice::Kind::none_needed) {
            job.recommended = QStringLiteral("none-needed");
            if (solution().before) {
                job.bobWeight = solution().before->sum() / gram;
            }
        } else if (solution().advice->kind == Advice::Kind::option) {
            const Option& option = *solution().advice->option;
            job.recommended = QString::fromStdString(std::string(option_word(option.id).word));
            job.reduction = option.reduction / gram;
            if (const auto& weights = solution().bob_weights[index(option.id)]) {
                job.bobWeight = weights->after.sum() / gram;
            }
        } else if (solution().advice->kind != Advice::Kind::no_new_plug_data) {
            job.recommended = QStringLiteral("not-compensated");
            if (solution().before) {
                job.bobWeight = solution().hung().value() / gram;  // with the nearest option
            }
        }
    }
    if (input().balancing) {
        const auto grams = [](const std::optional<double>& reading) {
            return reading ? std::optional(*reading / gram_mm) : std::nullopt;
        };
        job.frontReading = grams(input().balancing->front_reading);
        job.rearReading = grams(input().balancing->rear_reading);
    }
    job.verdict = readWord(solution(), solution().passes());
    return job;
}

}  // namespace ravnoves
