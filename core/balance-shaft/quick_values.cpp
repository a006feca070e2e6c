#include "balance-shaft/quick_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "balance-shaft/clearance.h"
#include "balance-shaft/input_check.h"
#include "balance-shaft/moments.h"
#include "case-file/input_error.h"
#include "case-file/number_places.h"

namespace ravnoves::balance_shaft {

namespace {

/// The moments of one input; each part is computed where it is asked for.
class Answers {
  public:
    Answers(const Moments& moments, const Input& input)
        : moments(moments), input_(input), alpha_(wrap_turn(input.shaft_angle)) {}

    const Moments& moments;
    double mass() const { return input_.reciprocating_mass(); }
    const MomentMetrics& up() {
        return keep(up_, [&] { return moments.tipping(); });
    }
    const MomentMetrics& s() {
        return keep(s_, [&] { return moments.shaft(alpha_); });
    }
    const MomentMetrics& ups() {
        return keep(ups_, [&] { return moments.at(alpha_); });
    }
    bool is_buildable() const {
        return buildable_angles(front_view(input_), input_.place_limits).contains(alpha_);
    }
    const Optimum& range() {
        return keep(range_, [&] { return moments.best_range(tipping_of_none()); });
    }
    const Optimum& rms() {
        return keep(rms_, [&] { return moments.best_rms(up()); });
    }

  private:
    template <typename Value, typename Compute>
    static const Value& keep(std::optional<Value>& kept, const Compute& compute) {
        return kept ? *kept : kept.emplace(compute());
    }
    /// The best range asks for M_up where there is no shaft's moment alone.
    MomentMetrics tipping_of_none() {
        return moments.forces.moment_amplitude == 0.0 ? up() : MomentMetrics{};
    }

    const Input& input_;
    double alpha_;
    std::optional<MomentMetrics> up_, s_, ups_;
    std::optional<Optimum> range_, rms_;
};

using Value = std::optional<double> (*)(Answers& of);

struct QuickValue {
    std::string_view pointer;
    Value value;
    const Message* (*note)(Answers& of) = nullptr;
};

template <const MomentMetrics& (Answers::*Which)()>
constexpr std::array<Value, 7> metrics_values{
    [](Answers& of) { return std::optional((of.*Which)().mean); },
    [](Answers& of) { return std::optional((of.*Which)().max); },
    [](Answers& of) { return std::optional((of.*Which)().min); },
    [](Answers& of) { return std::optional((of.*Which)().range); },
    [](Answers& of) { return std::optional((of.*Which)().rms); },
    [](Answers& of) { return std::optional((of.*Which)().max_angle / degree); },
    [](Answers& of) { return std::optional((of.*Which)().min_angle / degree); }};

template <const Optimum& (Answers::*Which)()>
std::optional<double> angle_of(Answers& of) {
    const auto& angle = (of.*Which)().shaft_angle;
    return angle ? std::optional(*angle * (1.0 / degree)) : std::nullopt;
}
template <const Optimum& (Answers::*Which)()>
std::optional<double> value_of(Answers& of) {
    return (of.*Which)().value;
}
template <const Optimum& (Answers::*Which)()>
const Message* note_of(Answers& of) {
    return &(of.*Which)().note;
}

constexpr auto& of_up = metrics_values<&Answers::up>;
constexpr auto& of_s = metrics_values<&Answers::s>;
constexpr auto& of_ups = metrics_values<&Answers::ups>;

constexpr std::array quick_values{
    QuickValue{"/metrics/M_up/mean_Nm", of_up[0]},
    QuickValue{"/metrics/M_up/max_Nm", of_up[1]},
    QuickValue{"/metrics/M_up/min_Nm", of_up[2]},
    QuickValue{"/metrics/M_up/range_Nm", of_up[3]},
    QuickValue{"/metrics/M_up/rms_Nm", of_up[4]},
    QuickValue{"/metrics/M_up/max_crank_angle_deg", of_up[5]},
    QuickValue{"/metrics/M_up/min_crank_angle_deg", of_up[6]},
    QuickValue{"/metrics/M_s/max_Nm", of_s[1]},
    QuickValue{"/metrics/M_s/min_Nm", of_s[2]},
    QuickValue{"/metrics/M_s/range_Nm", of_s[3]},
    QuickValue{"/metrics/M_s/rms_Nm", of_s[4]},
    QuickValue{"/metrics/M_s/max_crank_angle_deg", of_s[5]},
    QuickValue{"/metrics/M_s/min_crank_angle_deg", of_s[6]},
    QuickValue{"/metrics/M_ups/mean_Nm", of_ups[0]},
    QuickValue{"/metrics/M_ups/max_Nm", of_ups[1]},
    QuickValue{"/metrics/M_ups/min_Nm", of_ups[2]},
    QuickValue{"/metrics/M_ups/range_Nm", of_ups[3]},
    QuickValue{"/metrics/M_ups/rms_Nm", of_ups[4]},
    QuickValue{"/metrics/M_ups/max_crank_angle_deg", of_ups[5]},
    QuickValue{"/metrics/M_ups/min_crank_angle_deg", of_ups[6]},
    QuickValue{"/optimum/range/shaft_angle_deg", angle_of<&Answers::range>,
               note_of<&Answers::range>},
    QuickValue{"/optimum/range/range_Nm", value_of<&Answers::range>},
    QuickValue{"/optimum/rms/shaft_angle_deg", angle_of<&Answers::rms>, note_of<&Answers::rms>},
    QuickValue{"/optimum/rms/rms_Nm", value_of<&Answers::rms>},
    QuickValue{"/buildable/at_shaft_angle",
               [](Answers& of) { return std::optional(of.is_buildable() ? 1.0 : 0.0); }},
    QuickValue{"/reciprocating_mass_kg", [](Answers& of) { return std::optional(of.mass()); }},
    QuickValue{"/inertia_force_1_max_N",
               [](Answers& of) { return std::optional(of.moments.forces.inertia_force_1_max); }},
    QuickValue{"/counterweight_mass_kg",
               [](Answers& of) { return std::optional(of.moments.forces.counterweight_mass); }},
    QuickValue{"/counterweight_force_N",
               [](Answers& of) { return std::optional(of.moments.forces.counterweight_force); }},
    QuickValue{"/moment_amplitude_Nm",
               [](Answers& of) { return std::optional(of.moments.forces.moment_amplitude); }},
};

/// An input of which some numbers vary.
class VariedInput {
  public:
    VariedInput(const Input& input, std::span<const std::string> varied)
        : input_(input),
          varied_(varied.begin(), varied.end()),
          places_(find_numbers(input_, varied)) {}
    VariedInput(const VariedInput&) = delete;  // the places are those of this one
    VariedInput& operator=(const VariedInput&) = delete;

    /// @return why it is refused; empty of an input that is whole
    Reason set(std::span<const double> x) {
        for (std::size_t j = 0; j < x.size(); ++j) {
            const NumberPlace& place = places_[j];
            if (const Range* range = left_one({&place.range, &place.size}, x[j])) {
                return {"/input" + varied_[j], range->message()};
            }
            *place.value = x[j] * place.unit;
        }
        try {
            check_joined(input_);
        } catch (const InputError& error) {
            return {error.where_message(), error.allowed_message()};
        }
        return {};
    }
    const Input& input() const { return input_; }
    const std::vector<std::string>& varied() const { return varied_; }

  private:
    Input input_;
    std::vector<std::string> varied_;
    std::vector<NumberPlace> places_;
};

class QuickResponse final : public Response {
  public:
    QuickResponse(const Input& input, std::span<const std::string> varied,
                  std::vector<const QuickValue*> values)
        : input_(input, varied),
          values_(std::move(values)),
          keeps_torque_(std::none_of(varied.begin(), varied.end(),
                                     [](const std::string& pointer) {
                                         return pointer.starts_with("/torque") ||
                                                pointer == "/offset_mm";
                                     })) {}

    bool evaluate(std::span<const double> x, std::span<double> y) override {
        std::fill(y.begin(), y.end(), std::numeric_limits<double>::quiet_NaN());
        if (Reason refused = input_.set(x); !refused.empty()) {
            reason_ = std::move(refused);
            last_.clear();
            return false;
        }
        const Input& input = input_.input();
        try {
            if (!moves_shaft_alone(x) &&
                (!moments_ || !keeps_torque_ || !moments_->follow(input))) {
                moments_.emplace(input);
            }
            last_.assign(x.begin(), x.end());
        } catch (const InputError& error) {
            last_.clear();
            reason_ = {error.where_message(), error.allowed_message()};
            return false;
        }
        Answers answers(*moments_, input);
        bool whole = true;
        for (std::size_t w = 0; w < y.size(); ++w) {
            const auto value = values_[w]->value(answers);
            if (value && std::isfinite(*value)) {
                y[w] = *value;
            } else if (whole) {
                whole = false;
                const Message* note =
                    values_[w]->note != nullptr ? values_[w]->note(answers) : nullptr;
                reason_ = {values_[w]->pointer,
                           note != nullptr && !note->empty() ? *note : Message(no_value)};
            }
        }
        return whole;
    }

  private:
    /// The moments of the last inputs are these.
    bool moves_shaft_alone(std::span<const double> x) const {
        bool same = last_.size() == x.size();
        for (std::size_t j = 0; same && j < x.size(); ++j) {
            same = x[j] == last_[j] || input_.varied()[j] == "/shaft_angle_deg";
        }
        return same;
    }

    VariedInput input_;
    std::vector<const QuickValue*> values_;
    bool keeps_torque_;
    std::optional<Moments> moments_;
    std::vector<double> last_;
};

/// Whether the fields give these numbers themselves, not copies.
bool have_places(const Input& input, std::span<const std::string> pointers) {
    Input one = input;
    Input other = input;
    const auto places = find_numbers(one, pointers);
    const auto others = find_numbers(other, pointers);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].value == nullptr || places[i].value == others[i].value) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::unique_ptr<Response> quick_response(const Input& input, std::span<const std::string> varied,
                                         std::span<const std::string> watched) {
    std::vector<const QuickValue*> values;
    for (const std::string& pointer : watched) {
        const auto found =
            std::find_if(quick_values.begin(), quick_values.end(),
                         [&](const QuickValue& each) { return each.pointer == pointer; });
        if (found == quick_values.end()) {
            return nullptr;
        }
        values.push_back(&*found);
    }
    if (!have_places(input, varied)) {
        return nullptr;
    }
    return std::make_unique<QuickResponse>(input, varied, std::move(values));
}

BuildableOf quick_buildable(const Input& input, std::span<const std::string> varied) {
    if (!have_places(input, varied)) {
        return {};
    }
    return [moved = std::make_shared<VariedInput>(input, varied)](
               std::span<const double> x) -> std::optional<AngleStretches> {
        if (!moved->set(x).empty()) {
            return std::nullopt;
        }
        AngleStretches found;
        const Input& now = moved->input();
        for (const AngleStretch& stretch :
             buildable_angles(front_view(now), now.place_limits).stretches) {
            found.emplace_back(stretch.from / degree, stretch.to / degree);
        }
        return found;
    };
}

}  // namespace ravnoves::balance_shaft
