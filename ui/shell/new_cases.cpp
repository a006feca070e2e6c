#include "shell/new_cases.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLocale>
#include <array>
#include <functional>
#include <utility>

#include "balance-shaft/presets.h"
#include "balance-shaft/scene.h"
#include "bob-weights/presets.h"
#include "bob-weights/scene.h"
#include "case-file/json.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/scene.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/scene.h"
#include "scenes/scenes.h"
#include "text/message_text.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/scene.h"

namespace ravnoves {

namespace {

/// The titles of resources/examples, as they stand there: here they are found to be translated.
[[maybe_unused]] constexpr std::array exampleTitles{
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "TMZ-650D: balance shaft at 45°"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "Zotov and Sviridov 2021: formulas as printed"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "Zotov and Sviridov 2021: counterweight on the rod"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "Zotov and Sviridov 2021: guide that keeps the energy"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "V-8 of 4.25 litres: repair with oversize pistons"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "V-8 of 6 litres: improved pistons and rods"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "V-8, 90°: bob weight and correction"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "Volkswagen VR5 at 6200 min⁻¹"),
    QT_TRANSLATE_NOOP("ravnoves::NewCases", "Radial engine of nine cylinders"),
};

QString shown(const char* text) {
    return QCoreApplication::translate("ravnoves::NewCases", text);
}

CaseFile readInside(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return parse_case(file.readAll().toStdString());
}

NewCase preset(const char* scene, const QString& title, std::function<Json()> input) {
    return {NewCase::Kind::Preset, QString::fromLatin1(scene), title,
            [scene, title, input = std::move(input)] {
                return CaseFile{scene, title.toStdString(), input()};
            }};
}

std::vector<NewCase> presets() {
    std::vector<NewCase> list;
    list.push_back(preset("balance-shaft", QStringLiteral("TMZ-650D"), [] {
        return balance_shaft::write_input(balance_shaft::preset_tmz_650d());
    }));
    list.push_back(preset(
        "elastic-hinge", shown(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Zotov and Sviridov 2021")),
        [] { return elastic_hinge::write_input(elastic_hinge::preset_zotov()); }));
    for (const v8_plugs::Engine& engine : v8_plugs::engine_presets()) {
        const QString litres = QLocale().toString(
            QString::fromStdString(engine.name).section(QLatin1Char(' '), 0, 0).toDouble());
        list.push_back(
            preset("v8-plugs",
                   shown(QT_TRANSLATE_NOOP("ravnoves::NewCases", "V-8 of %1 litres")).arg(litres),
                   [engine] {
                       v8_plugs::Input input;
                       input.preset = engine.name;
                       input.engine = engine;
                       const v8_plugs::PlugSheet printed = v8_plugs::printed_plug(engine.name);
                       if (printed != v8_plugs::PlugSheet{}) {
                           input.plug = printed;
                       }
                       return v8_plugs::write_input(input);
                   }));
    }
    for (const bob_weights::Preset& engine : bob_weights::presets()) {
        list.push_back(preset("bob-weights", shownText(engine.name), [engine] {
            bob_weights::Input input;
            input.engine = engine.engine;
            return bob_weights::write_input(input);
        }));
    }
    list.push_back(preset("inertia-moments", QStringLiteral("Volkswagen VR5"), [] {
        return inertia_moments::write_input(inertia_moments::preset_vw_vr5());
    }));
    for (const int count : inertia_moments::radial_counts) {
        list.push_back(
            preset("inertia-moments",
                   shown(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Radial engine, %1 cylinders"))
                       .arg(count),
                   [count] {
                       return inertia_moments::write_input(inertia_moments::preset_radial(count));
                   }));
    }
    return list;
}

}  // namespace

QString listed(const NewCase& each) {
    switch (each.kind) {
        case NewCase::Kind::Preset:
            return shown(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Preset: %1")).arg(each.title);
        case NewCase::Kind::Example:
            return shown(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Example: %1")).arg(each.title);
        case NewCase::Kind::Empty:
            break;
    }
    return each.title;
}

std::vector<NewCase> newCases() {
    std::vector<NewCase> examples;
    const QDir folder(QStringLiteral(":/examples"));
    for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
        const QString path = folder.filePath(name);
        const CaseFile file = readInside(path);
        examples.push_back({NewCase::Kind::Example, QString::fromStdString(file.scene),
                            shown(file.title.c_str()), [path] { return readInside(path); }});
    }
    const std::vector<NewCase> ready = presets();
    std::vector<NewCase> list;
    for (const SceneSolver& solver : scene_solvers()) {
        const QString scene =
            QString::fromLatin1(solver.name.data(), static_cast<qsizetype>(solver.name.size()));
        const QString path = QStringLiteral(":/templates/%1.case.json").arg(scene);
        if (QFile::exists(path)) {
            list.push_back(
                {NewCase::Kind::Empty, scene,
                 shown(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Empty: round numbers to replace")),
                 [path] { return readInside(path); }});
        }
        for (const auto& each : {std::cref(ready), std::cref(std::as_const(examples))}) {
            for (const NewCase& one : each.get()) {
                if (one.scene == scene) {
                    list.push_back(one);
                }
            }
        }
    }
    return list;
}

}  // namespace ravnoves
