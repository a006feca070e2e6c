#include "shell/new_cases.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <algorithm>
#include <array>
#include <iterator>

#include "case-file/json.h"
#include "scenes/scenes.h"
#include "text/message_text.h"

namespace ravnoves {

namespace {

/// The titles of resources/examples, as they are there, and what each answers.
constexpr auto exampleTitles = std::to_array<std::pair<const char*, const char*>>({
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "TMZ-650D: balance shaft"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "Where do I put the balance shaft?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "88 × 75 mm: a balance shaft that helps"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "How much can a balance shaft help?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "Zotov and Sviridov 2021: formulas as printed"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "What do elastic hinges change?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "Zotov and Sviridov 2021: counterweight on the rod"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "Which counterweight does the rod need?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases",
                       "Zotov and Sviridov 2021: guide that keeps the energy"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "Which guide keeps the crank speed constant?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases",
                       "Elastic hinge that can be made: softer spring, roller of 10 mm"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "Which hinge can be made?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "V-8 of 4.25 litres: repair with oversize pistons"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "Which plugs compensate oversize pistons?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "V-8 of 6 litres: improved pistons and rods"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "Which plugs suit lighter pistons and rods?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "V-8, 90°: bob weight and correction"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "How heavy is the bob weight, and where do I drill?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases",
                       "V-8 4.25 l: plugs, bob weight, second run on the machine"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "How is a crankshaft balanced from start to finish?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "Volkswagen VR5 at 6200 min⁻¹"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "How much does a VR5 shake?")},
    {QT_TRANSLATE_NOOP("ravnoves::NewCases", "Radial engine of nine cylinders"),
     QT_TRANSLATE_NOOP("ravnoves::NewCases", "How much does a radial engine shake?")},
});

QString shown(const char* text) {
    return QCoreApplication::translate("ravnoves::NewCases", text);
}

CaseFile readInside(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return parse_shown_case(file.readAll().toStdString());
}

}  // namespace

std::vector<NewCase> newCases() {
    const auto listed = [](const char* kind, const QString& title) {
        return shown(kind).arg(title);
    };
    std::vector<NewCase> examples;
    const QDir folder(QStringLiteral(":/examples"));
    for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
        const QString path = folder.filePath(name);
        const CaseFile file = readInside(path);
        const auto known = std::ranges::find(exampleTitles, file.title,
                                             &std::pair<const char*, const char*>::first);
        const QString title = shown(file.title.c_str());
        examples.push_back({QString::fromStdString(file.scene), title,
                            listed(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Example: %1"), title),
                            known != exampleTitles.end() ? shown(known->second) : title,
                            [path] { return readInside(path); }});
    }
    std::vector<NewCase> list;
    for (const SceneSolver& solver : scene_solvers()) {
        if (solver.title.empty()) {
            continue;
        }
        const QString scene =
            QString::fromLatin1(solver.name.data(), static_cast<qsizetype>(solver.name.size()));
        const QString blank =
            shown(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Blank (placeholder values)"));
        list.push_back({scene, blank, blank, {}, [scene] {
                            return readInside(
                                QStringLiteral(":/templates/%1.case.json").arg(scene));
                        }});
        for (const auto& [name, input] : solver.presets()) {
            const QString title = presetTitle(name);
            list.push_back({scene,
                            title,
                            listed(QT_TRANSLATE_NOOP("ravnoves::NewCases", "Preset: %1"), title),
                            {},
                            [scene, title, input = input] {
                                return CaseFile{scene.toStdString(), title.toStdString(), input};
                            }});
        }
        std::ranges::copy_if(examples, std::back_inserter(list),
                             [&](const NewCase& each) { return each.scene == scene; });
    }
    return list;
}

}  // namespace ravnoves
