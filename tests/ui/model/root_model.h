#pragma once

#include <cmath>
#include <memory>

#include "case-file/field_visitor.h"
#include "model/case_model_json.h"
#include "vector_registers.h"

namespace ravnoves::test {

/// A scene that is as small as can be: the root of a number. It counts how often it solves.
struct RootScene {
    struct Input {
        double square = 4.0;
        double unused = 0.0;
        friend bool operator==(const Input&, const Input&) = default;
    };
    using Solved = double;

    static Input defaultInput() { return {}; }
    static QString defaultTitle() { return QStringLiteral("Root of four"); }
    static Input read(const Json& input, const CaseContext& /*context*/) {
        Input read;
        for (const auto& [key, value] : input.items()) {
            if (key != "crank_radius_mm" || !value.is_number()) {
                throw InputError("/input/" + key, "is not a known key");
            }
            read.square = value.get<double>();
        }
        return read;
    }
    static Json write(const Input& input) { return {{"crank_radius_mm", input.square}}; }
    Solved solve(const Input& input) const {
        ++*solves;
        *dirty += are_vector_registers_dirty() ? 1 : 0;
        if (input.square > 1e100) {
            throw std::bad_alloc();
        }
        if (input.square < 0.0) {
            throw InputError("/input/crank_radius_mm", "must not be negative");
        }
        return std::sqrt(input.square);
    }

    std::shared_ptr<int> solves = std::make_shared<int>(0);
    std::shared_ptr<int> dirty =
        std::make_shared<int>(0);  ///< with registers that others left in use
};

inline void visit_fields(FieldVisitor& visitor, RootScene::Input& input) {
    visitor.number(
        Field{.key = "crank_radius_mm", .unit = units::none, .label = Text::tr("Square")},
        input.square);
}

class RootModel : public CaseModel<RootScene> {
  public:
    explicit RootModel(const RootScene& scene = {}) : CaseModel(scene, nullptr) {}

    /// A word that case files know.
    QString sceneName() const override { return QStringLiteral("balance-shaft"); }
    Json resultJson() const override { return {{"root", root()}}; }
    double root() const { return solved(); }
    QString set(const char* name, double square) {
        return drag(QString::fromLatin1(name), [=](Input& input) { input.square = square; });
    }
    QString step(const char* name, double square, const QString& title = {}) {
        return edit(
            QString::fromLatin1(name), [=](Input& input) { input.square = square; }, title);
    }
    Json placeJson() const override { return place; }
    void takePlace(const Json& from) override { place = from; }
    using CaseModel::restart;

    Json place;
    int loads = 0;
    int takes = 0;

  protected:
    void aboutToLoad() override { ++loads; }
    void taken() override { ++takes; }
};

}  // namespace ravnoves::test
