#include <QSettings>
#include <algorithm>
#include <utility>

#include "v8-plugs/fields.h"
#include "v8-plugs/presets.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

/// The paper's engine with the sizes it prints of the plug; the cutter is the shop's, and what the
/// scale said stays.
void takePreset(workshop::Input& job, const v8_plugs::Engine& preset) {
    v8_plugs::Input& plugs = *job.plugs;
    if (plugs.preset != preset.name) {
        PlugSheet plug = printed_plug(preset.name);
        plug.cutter_diameter = plugs.plug ? plugs.plug->cutter_diameter : std::nullopt;
        plugs.plug = plug == PlugSheet{} ? std::nullopt : std::optional(plug);
        for (const Part part : all_parts) {
            if (job.weigh_in) {
                (*job.weigh_in)[part].nominal.reset();
                (*job.weigh_in)[part].permitted_spread.reset();
            }
        }
    }
    plugs.preset = preset.name;
    plugs.engine = preset;
}

const QString toleranceKey = QStringLiteral("workshop/tolerance_g_mm");

/// The limit that new jobs begin with, kg·m.
double shopsTolerance() {
    bool isNumber = false;
    const double kept = QSettings().value(toleranceKey).toDouble(&isNumber);
    return isNumber && field::tolerance.range.contains(kept) ? kept * field::tolerance.unit
                                                             : default_tolerance;
}

}  // namespace

void WorkshopScene::startPlugs(v8_plugs::Input& plugs) const {
    if (dated && plugs.tolerance == default_tolerance) {
        plugs.tolerance = shopsTolerance();
    }
}

/// What the preset does not know may be filled in.
bool WorkshopScene::isSameEngine(const Input& input, const Input& named) {
    if (input.engine != named.engine || !input.plugs || !named.plugs) {
        return input.engine == named.engine && !input.plugs && !named.plugs;
    }
    const v8_plugs::Engine& a = input.plugs->engine;
    const v8_plugs::Engine& b = named.plugs->engine;
    return input.plugs->preset == named.plugs->preset && a.name == b.name &&
           a.has_aluminium_plug == b.has_aluminium_plug && a.has_new_plug == b.has_new_plug &&
           std::ranges::all_of(engine_fields(), [&](const EngineField& each) {
               return !(b.*each.member) || a.*each.member == b.*each.member;
           });
}

void WorkshopModel::notePlugs(JournalJob& job) const {
    const v8_plugs::Input& input = *plugsInput();
    const v8_plugs::Result& solution = *plugs();
    job.engine = QString::fromStdString(input.engine.name);
    job.process = QString::fromStdString(
        std::string(process_words[static_cast<std::size_t>(input.process)].word));
    if (solution.unbalanced_mass) {
        job.unbalancedMass = *solution.unbalanced_mass / units::gram;
    }
    if (!solution.advice) {
        return;
    }
    if (solution.advice->kind == Advice::Kind::none_needed) {
        job.recommended = QStringLiteral("none-needed");
    } else if (solution.advice->kind == Advice::Kind::option) {
        const SolvedOption& option = *solution.chosen();
        job.recommended = QString::fromStdString(std::string(option_word(option.id).word));
        job.reduction = option.take_off() / units::gram;
    } else if (solution.advice->kind != Advice::Kind::no_new_plug_data) {
        job.recommended = QStringLiteral("not-compensated");
    }
}

// --------------------------------------------------------------------------------- on the page

void WorkshopModel::setHasPlugs(bool there) {
    std::optional<workshop::Input> before = input();
    edit(tr("Sludge-trap plugs"), [&](workshop::Input& job) {
        if (there) {
            job.plugs = otherForm_ ? otherForm_->plugs : std::nullopt;
            if (!job.plugs) {
                workshop::Input first;  // the parts weighed keep their nominal masses
                first.plugs.emplace();
                takePreset(first, engine_presets().front());
                job.plugs = first.plugs;
            }
            scene().startPlugs(*job.plugs);
            job.parts = {};
            job.factor = {};
            if (!job.weigh_in && job.plugs->plug) {
                fit_weigh_in(job);
            }
        } else {
            job.plugs.reset();
            if (otherForm_ && !otherForm_->plugs) {
                job.parts = otherForm_->parts;
                job.factor = otherForm_->factor;
            }
        }
    });
    if (there == hasPlugs()) {
        otherForm_ = std::move(before);
    }
}

QString WorkshopModel::editPlugs(const QString& name,
                                 const std::function<void(v8_plugs::Input&)>& mutate) {
    return edit(name, [&](workshop::Input& job) {
        if (job.plugs) {
            mutate(*job.plugs);
        }
    });
}

void WorkshopModel::keepTolerance() {
    if (scene().dated && hasPlugs()) {
        QSettings().setValue(toleranceKey, input().plugs->tolerance / field::tolerance.unit);
        Q_EMIT changed();
    }
}

bool WorkshopModel::isShopsTolerance() const {
    return scene().dated && hasPlugs() && input().plugs->tolerance == shopsTolerance();
}

v8_plugs::Engine WorkshopModel::withNominalMasses() const {
    v8_plugs::Engine engine = plugsInput()->engine;
    if (const auto& sheet = plugsInput()->weigh_in) {
        const auto sum = nominal_reciprocating(*sheet);
        engine.reciprocating_mass = sum ? sum : engine.reciprocating_mass;
        const auto rotating = nominal_rotating(*sheet);
        engine.rotating_mass = rotating ? rotating : engine.rotating_mass;
    }
    return engine;
}

bool WorkshopModel::canFillNominalMasses() const {
    return hasPlugs() && withNominalMasses() != plugsInput()->engine;
}

void WorkshopModel::fillNominalMasses() {
    editPlugs(tr("Masses of the nominal parts"),
              [filled = withNominalMasses()](v8_plugs::Input& plugs) { plugs.engine = filled; });
}

// ------------------------------------------------------------------------------------- engines

void WorkshopModel::setPlugs(const QString& name, EngineGroup group, bool present) {
    editPlugs(name, [&](v8_plugs::Input& plugs) {
        set_plugs(plugs.engine, group, present);
        if (!plugs.engine.has_new_plug) {
            plugs.crankshaft = Crankshaft::standard;
        }
        if (const v8_plugs::Engine* known = present ? find_preset(plugs.preset) : nullptr) {
            for (const EngineField& each : engine_fields()) {
                if (each.group == group) {
                    plugs.engine.*each.member = known->*each.member;
                }
            }
        }
    });
}

QStringList WorkshopModel::engineNames() const {
    QStringList names;
    for (const v8_plugs::Engine& preset : engine_presets()) {
        names << v8_text::engineName(Words(), preset.name);
    }
    return names;
}

int WorkshopModel::engineIndex() const {
    const auto presets = engine_presets();
    const auto preset = std::ranges::find(
        presets, hasPlugs() ? input().plugs->preset : std::string(), &v8_plugs::Engine::name);
    return preset == presets.end() ? -1 : static_cast<int>(preset - presets.begin());
}

void WorkshopModel::chooseEngine(int place) {
    const auto presets = engine_presets();
    if (!hasPlugs() || place < 0 || place >= std::ssize(presets)) {
        return;
    }
    finishDrag();
    edit(tr("Engine"),
         [&](workshop::Input& job) { takePreset(job, presets[static_cast<std::size_t>(place)]); });
    finishDrag();
}

QString WorkshopModel::ownEngineName() const {
    return hasPlugs() && input().plugs->preset.empty()
               ? QString::fromStdString(input().plugs->engine.name)
               : QString();
}

void WorkshopModel::nameEngine(const QString& name) {
    editPlugs(tr("Name of the engine"), [&](v8_plugs::Input& plugs) {
        plugs.preset.clear();
        plugs.engine.name = name.toStdString();
    });
}

QString WorkshopModel::engineNote() const {
    const v8_plugs::Engine* preset = hasPlugs() ? find_preset(input().plugs->preset) : nullptr;
    if (preset == nullptr) {
        return {};
    }
    if (!preset->steel_plug_mass) {
        return tr(
            "The paper gives only the crank radius of this engine; measure the other values.");
    }
    if (input().plugs->engine.steel_plug_mass == preset->steel_plug_mass) {
        return tr(
            "The paper's plug masses look too small for its threads: weigh the plugs and enter "
            "their masses.");
    }
    return {};
}

}  // namespace ravnoves
