// What a user types stays through any changes of torque source and variant.

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>
#include <map>
#include <random>

#include "balance-shaft/model/balance_shaft_model.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "text/file_path.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using Kind = balance_shaft::TorqueSource::Kind;

/// By pointers below "input".
using Typed = std::map<std::string, double>;

/// A field and what may be typed into it, in the unit of its key.
struct TypedField {
    const char* pointer;
    double from;
    double to;
};
constexpr TypedField fields[]{
    {"/cylinder/bore_mm", 60, 110},
    {"/cylinder/rod_length_mm", 130, 190},
    {"/cylinder/offset_mm", 0, 4},
    {"/crank_radius_mm", 30, 50},
    {"/centre_distance_mm", 60, 140},
    {"/shaft_angle_deg", 0, 360},
    {"/reciprocating_masses_kg/piston", 0.3, 0.8},
    {"/reciprocating_masses_kg/pin", 0.1, 0.3},
    {"/counterweight_radius_mm", 30, 60},
    {"/torque/cycle/compression_ratio", 7, 12},
    {"/torque/cycle/combustion_duration_deg", 40, 70},
    {"/torque/pressure/crank_angle_shift_deg", -10, 10},
};
constexpr const char* tableCell = "/torque/torque_Nm/5";

class RandomWalk : public ::testing::Test {
  protected:
    /// What the case should hold at each step of the history.
    struct State {
        Typed present;
        std::vector<Typed> variants;
    };

    RandomWalk() {
        std::string trace = "angle,pressure bar\n";
        for (int angle = 0; angle <= 720; angle += 5) {
            const double turn = std::cos((angle - 365) * M_PI / 360.0);
            trace += std::to_string(angle) + ',' +
                     std::to_string(1.1 + 40.0 * std::exp(12.0 * (std::abs(turn) - 1.0))) + '\n';
        }
        const std::filesystem::path directory = fsPath(folder.path());
        write_text_file(directory / "trace.csv", trace);
        model.setTorqueKind(Kind::cycle);
        model.setTorqueKind(Kind::table);
        CaseFile file = model.caseFile();
        file.kept["torque"]["pressure"] = {{"csv", "trace.csv"}};
        model.loadFile(file, {directory});
        first = model.history()->index();
        states.assign(static_cast<std::size_t>(first) + 1, {});
    }

    double between(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); }
    State& now() { return states.at(static_cast<std::size_t>(model.history()->index())); }

    /// What the model holds of a field: of a source that is not in use among what is kept.
    static std::optional<double> held(const SceneModel& of, const std::string& pointer) {
        const Json::json_pointer at(pointer);
        for (const Json& json : {of.inputJson(), of.keptJson()}) {
            if (json.contains(at)) {
                return json.at(at).get<double>();
            }
        }
        return std::nullopt;
    }
    void expectAll(const SceneModel& of, const Typed& typed) {
        for (const auto& [pointer, value] : typed) {
            EXPECT_EQ(held(of, pointer), std::optional(value)) << pointer;
        }
    }

    /// Does one thing, and says what the case should hold then.
    State change() {
        State next = now();
        const int variants = static_cast<int>(model.variants().size());
        switch (below(8)) {
            case 0:
                model.setTorqueKind(std::array{Kind::table, Kind::cycle,
                                               Kind::pressure}[static_cast<std::size_t>(below(3))]);
                break;
            case 1:
                if (variants < 4) {
                    model.keepVariant();
                    next.variants.push_back(inUse(next.present));
                } else {
                    const int gone = below(variants);
                    model.removeVariant(gone);
                    next.variants.erase(next.variants.begin() + gone);
                }
                break;
            case 2:
                if (variants > 0) {
                    const int place = below(variants);
                    // What the variant has takes the place also of what is kept.
                    const Typed present = inUse(next.present);
                    const Json input = model.variantInput(place);
                    std::erase_if(next.present, [&](const auto& each) {
                        return present.contains(each.first) ||
                               input.contains(Json::json_pointer(each.first));
                    });
                    const Typed& variant = next.variants[static_cast<std::size_t>(place)];
                    next.present.insert(variant.begin(), variant.end());
                    EXPECT_EQ(model.takeVariant(place), QString());
                }
                break;
            case 3:
                if (model.input().torque.kind == Kind::table) {
                    const double value = std::round(between(-300, 300));
                    model.edit(u"Torque"_s, [&](balance_shaft::Input& input) {
                        input.torque.table.torque[5] = value;
                    });
                    next.present[tableCell] = value;
                }
                break;
            default:
                type(fields[below(std::ssize(fields))], next.present);
        }
        return next;
    }
    void type(const TypedField& field, Typed& typed) {
        if (!model.inputJson().contains(Json::json_pointer(field.pointer))) {
            return;  // no form shows it now
        }
        const double value = QString::number(between(field.from, field.to), 'g', 6).toDouble();
        if (model.editField(field.pointer, value, QString::fromUtf8(field.pointer)).isEmpty()) {
            typed[field.pointer] = value;
        }
    }
    Typed inUse(const Typed& typed) const {
        Typed used;
        const Json input = model.inputJson();
        for (const auto& [pointer, value] : typed) {
            if (input.contains(Json::json_pointer(pointer))) {
                used.emplace(pointer, value);
            }
        }
        return used;
    }

    QTemporaryDir folder;
    BalanceShaftModel model;
    std::mt19937 random{20261128};
    int first = 0;
    std::vector<State> states;
};

TEST_F(RandomWalk, LosesNoTypedNumber) {
    std::map<Kind, int> kinds;
    std::size_t maximum = 0;
    for (int step = 0; step < 500 && !HasFailure(); ++step) {
        SCOPED_TRACE(step);
        const int before = model.history()->index();
        const int what = below(10);
        if (what == 0 && before > first) {
            model.undo();
        } else if (what == 1) {
            model.redo();
        } else {
            State next = change();
            const auto index = static_cast<std::size_t>(model.history()->index());
            if (model.history()->index() > before) {
                states.resize(index);
                states.push_back(std::move(next));
            }
        }
        ++kinds[model.input().torque.kind];
        maximum = std::max(maximum, now().present.size());
        expectAll(model, now().present);
        ASSERT_EQ(static_cast<std::size_t>(model.variants().size()), now().variants.size());
        for (int i = 0; i < model.variants().size(); ++i) {
            const Json input = model.variantInput(i);
            for (const auto& [pointer, value] : now().variants[static_cast<std::size_t>(i)]) {
                EXPECT_EQ(input.at(Json::json_pointer(pointer)), value) << i << ' ' << pointer;
            }
        }
        if (step % 50 == 0) {
            BalanceShaftModel other;
            other.loadFile(model.caseFile(), model.context());
            expectAll(other, now().present);
        }
    }
    EXPECT_EQ(kinds.size(), 3U) << "each source was in use";
    EXPECT_GT(maximum, 10U) << "most of them at once";
    while (model.history()->index() > first) {
        model.undo();
        expectAll(model, now().present);
    }
}

}  // namespace
}  // namespace ravnoves
