#include "methods/case_budget.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <utility>

#include "case-file/case_file.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "methods/plain_text.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"
#include "studies/taylor.h"

namespace ravnoves::methods {

namespace {

using Kind = Contribution::Kind;
using Pointer = Json::json_pointer;
using Values = std::vector<double>;  ///< in the units of the keys; not a number where there is none

/// How this thread rounds while it lives.
class RoundingMode {
  public:
    explicit RoundingMode(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
    ~RoundingMode() { std::fesetround(before_); }
    RoundingMode(const RoundingMode&) = delete;
    RoundingMode& operator=(const RoundingMode&) = delete;

  private:
    int before_;
};

/// One case and the changes that are made to it.
class Question {
  public:
    Question(const CaseFile& file, const CaseContext& context)
        : file_(file), context_(context), solver_(scene_solver(file.scene)) {
        const auto entries = solver_.results(file.input, context);
        for (const std::string_view leading : solver_.leading) {
            const auto found = std::find_if(
                entries.begin(), entries.end(),
                [&](const ResultEntry& entry) { return entry.pointer == leading && entry.si; });
            if (found != entries.end()) {
                budget_.push_back({*found});
                pointers_.emplace_back(leading);
            }
        }
        nominal_ = solved(file.input);
    }

    void ask_rounding() {
        std::vector<Values> others;
        for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            const RoundingMode rounding(mode);
            others.push_back(solved(file_.input));
        }
        add({Kind::rounding}, others);
    }

    void ask_choices() {
        for (const FieldEntry& entry : solver_.fields(file_.input)) {
            if (entry.pointer != solver_.method) {
                continue;
            }
            for (const Word& each : entry.field.words) {  // the present one changes nothing
                const std::string word(each.word);
                add({Kind::choice, entry.pointer, word}, {solved(with(entry.pointer, word))});
            }
        }
    }

    /// Of a result that has an approximate form beside the exact one.
    void ask_approximation() {
        constexpr std::string_view exact = "/exact";
        const std::string approximate = "/two_term";
        std::vector<std::string> pointers = pointers_;
        for (std::string& pointer : pointers) {
            if (pointer.starts_with(exact)) {
                pointer.replace(0, exact.size(), approximate);
            }
        }
        if (pointers != pointers_) {
            add({Kind::approximate, approximate}, {solved(file_.input, pointers)});
        }
    }

    void ask_tolerances() {
        std::vector<studies::Varied> all;
        if (!file_.study.is_null()) {
            all = studies::read_study(file_.study, true).vary;
        }
        if (const auto open = studies::open_input(file_, context_, all)) {
            add({Kind::tolerance, open->pointer},
                {solved(with(open->pointer, open->from)), solved(with(open->pointer, open->to))});
        }
        for (const studies::Varied& varied : all) {
            const Pointer place(varied.pointer);
            if (varied.spread == studies::Varied::Spread::grid || !file_.input.contains(place) ||
                !file_.input.at(place).is_number()) {
                continue;  // of an input that another source of the case has
            }
            const double nominal = file_.input.at(place).get<double>();
            const studies::Law law = studies::law_of(varied, nominal);
            const double low = law.normal ? nominal - law.deviation : law.low;
            const double high = law.normal ? nominal + law.deviation : law.high;
            add({Kind::tolerance, varied.pointer},
                {solved(with(varied.pointer, low)), solved(with(varied.pointer, high))});
        }
    }

    std::vector<CaseDoubt> take() {
        // What changes a result by no more than rounding does is rounding.
        for (CaseDoubt& doubt : budget_) {
            double rounding = 0.0;
            for (const Contribution& each : doubt.contributions) {
                rounding = each.kind == Kind::rounding ? each.change.value_or(0.0) : rounding;
            }
            std::erase_if(doubt.contributions, [&](const Contribution& each) {
                return each.kind != Kind::rounding && each.change && *each.change <= rounding;
            });
        }
        std::erase_if(budget_, [](const CaseDoubt& doubt) { return doubt.contributions.empty(); });
        for (CaseDoubt& doubt : budget_) {
            std::stable_sort(doubt.contributions.begin(), doubt.contributions.end(),
                             [](const Contribution& a, const Contribution& b) {
                                 return a.change.value_or(-1.0) > b.change.value_or(-1.0);
                             });
        }
        return std::move(budget_);
    }

  private:
    Json with(const std::string& pointer, Json value) const {
        Json input = file_.input;
        input[Pointer(pointer)] = std::move(value);
        return input;
    }

    Values solved(const Json& input) const { return solved(input, pointers_); }
    Values solved(const Json& input, const std::vector<std::string>& pointers) const {
        Values values(pointers.size(), std::numeric_limits<double>::quiet_NaN());
        try {
            solver_.respond(input, context_, {}, pointers)->evaluate({}, values);
        } catch (const InputError&) {
            // The scene rejects the case with this change.
        }
        return values;
    }

    void add(const Contribution& what, const std::vector<Values>& others) {
        for (std::size_t i = 0; i < budget_.size(); ++i) {
            const ResultEntry& result = budget_[i].result;
            double largest = 0.0;
            for (const Values& other : others) {
                const double change =
                    studies::difference(other[i], nominal_[i], result.period) * result.unit;
                largest = std::isnan(change) ? change : std::max(largest, std::abs(change));
                if (std::isnan(largest)) {
                    break;
                }
            }
            if (largest != 0.0) {
                budget_[i].contributions.push_back(what);
                budget_[i].contributions.back().change =
                    std::isnan(largest) ? std::nullopt : std::optional(largest);
            }
        }
    }

    const CaseFile& file_;
    const CaseContext& context_;
    const SceneSolver& solver_;
    std::vector<CaseDoubt> budget_;
    std::vector<std::string> pointers_;
    Values nominal_;
};

}  // namespace

std::string Contribution::english() const {
    switch (kind) {
        case Kind::rounding:
            return "rounding";
        case Kind::choice:
            return pointer + ": " + word;
        case Kind::approximate:
            return pointer + " instead";
        case Kind::tolerance:
            break;
    }
    return pointer + " ±";
}

std::vector<CaseDoubt> case_budget(const CaseFile& file, const CaseContext& context) {
    Question question(file, context);
    question.ask_rounding();
    question.ask_choices();
    question.ask_approximation();
    question.ask_tolerances();
    return question.take();
}

std::string write_text(const std::vector<CaseDoubt>& budget) {
    AlignedTable table({{"result"}, {"value", true}, {"changes by", true}, {"with"}});
    constexpr int value_digits = 7;
    constexpr int change_digits = 3;
    for (const CaseDoubt& doubt : budget) {
        std::string name = doubt.result.pointer;
        std::string value = format_number(*doubt.result.si / doubt.result.unit, value_digits);
        for (const Contribution& each : doubt.contributions) {
            table.add({std::exchange(name, ""), std::exchange(value, ""),
                       each.change ? format_number(*each.change / doubt.result.unit, change_digits)
                                   : "not solved",
                       each.english()});
        }
    }
    constexpr std::size_t width = 110;
    return table.text(width);
}

}  // namespace ravnoves::methods
