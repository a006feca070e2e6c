#include "scenes/responses.h"

#include "balance-shaft/quick_values.h"
#include "balance-shaft/scene.h"
#include "case-file/case_file.h"

namespace ravnoves {

std::unique_ptr<Response> quick_response(const CaseFile& file, const CaseContext& context,
                                         std::span<const std::string> varied,
                                         std::span<const std::string> watched) {
    // One line for each scene that has them.
    if (file.scene == "balance-shaft") {
        return balance_shaft::quick_response(balance_shaft::read_input(file.input, context), varied,
                                             watched);
    }
    return nullptr;
}

BuildableOf quick_buildable(const CaseFile& file, const CaseContext& context,
                            std::span<const std::string> varied) {
    if (file.scene == "balance-shaft") {
        return balance_shaft::quick_buildable(balance_shaft::read_input(file.input, context),
                                              varied);
    }
    return {};
}

std::optional<std::string> buildable_value(const CaseFile& file) {
    if (file.scene == "balance-shaft") {
        return "/buildable/at_shaft_angle";
    }
    return std::nullopt;
}

std::vector<Message> file_notes(const CaseFile& file, const CaseContext& context) {
    std::vector<Message> notes;
    if (file.scene == "balance-shaft") {
        const auto input = balance_shaft::read_input(file.input, context);
        if (Message changed = input.torque.changed_note(); !changed.empty()) {
            notes.push_back(std::move(changed));
        }
    }
    return notes;
}

std::optional<BestChoice> best_choice(const CaseFile& file) {
    if (file.scene == "balance-shaft") {
        return BestChoice{"/shaft_angle_deg",
                          "/metrics/M_ups/range_Nm",
                          "/optimum/range/shaft_angle_deg",
                          "/optimum_buildable/range/shaft_angle_deg",
                          "/moment_amplitude_Nm",
                          "/buildable/shaft_angles_deg"};
    }
    return std::nullopt;
}

}  // namespace ravnoves
