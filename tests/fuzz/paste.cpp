// Text on the clipboard, pasted into each table that takes numbers: written whole or rejected in
// words. What stands there then is a case that can be solved, and undo brings back what stood.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/torque_table_model.h"
#include "case-file/input_error.h"
#include "inertia-moments/model/cylinder_table_model.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "studies/model/study_model.h"
#include "studies/model/study_tables.h"
#include "window_target.h"
#include "workshop/model/workshop_model.h"

namespace {

using namespace ravnoves;
using Cells = std::vector<QStringList>;

/// Pastes into a table of a model and takes it back.
void paste(SceneModel& model, const std::function<QString()>& write) {
    const Json before = model.inputJson();
    const std::string study = model.study();
    const int steps = model.history()->index();
    const bool isRejected = !write().isEmpty();
    const Json after = model.inputJson();
    require(!isRejected || (after == before && model.study() == study),
            "what is refused changes nothing");
    static_cast<void>(model.resultJson());
    CaseContext nowhere;
    nowhere.stays_in_directory = true;
    model.loadInput(after, nowhere);
    while (model.history()->index() > steps) {
        model.undo();
    }
    require(model.inputJson() == before && model.study() == study, "undo brings back what stood");
    model.history()->clear();
}

/// A model for all inputs: to make one for each takes longer than what is looked at.
struct Pages {
    Pages() { plugs.setHasPlugs(true); }

    WorkshopModel shaft{QString()};
    WorkshopModel plugs{QString()};
    BalanceShaftModel single;
    TorqueTableModel torque{&single};
    InertiaMomentsModel engine;
    CylinderTableModel cylinders{&engine};
    StudyModel study{&engine};
    ScatterTable scatter{&study};
    WatchTable watch{&study};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    needApplication();
    static Pages pages;
    if (size < 2) {
        return 0;
    }
    const int row = data[0] % 16;
    const int column = data[1] % 12;
    const QString text = QString::fromUtf8(reinterpret_cast<const char*>(data + 2),
                                           static_cast<qsizetype>(size - 2));
    const Cells cells = readTextTable(text);
    paste(pages.single, [&]() -> QString {
        try {
            pages.torque.replaceByText(text.toStdString());
            return {};
        } catch (const InputError& error) {
            return QString::fromUtf8(error.what());
        }
    });
    if (cells.empty()) {
        return 0;
    }
    paste(pages.single, [&] { return pages.torque.pasteBlock(row, column % 2, cells); });
    pages.torque.forgetRejected();
    paste(pages.shaft, [&] {
        return pages.shaft.pasteWeights(row, column, readTextTable(text, EmptyLine::gap));
    });
    paste(pages.plugs, [&] {
        return pages.plugs.pasteWeights(row, column, readTextTable(text, EmptyLine::gap));
    });
    paste(pages.engine, [&] { return pages.cylinders.pasteBlock(row, column, cells); });
    paste(pages.engine, [&] { return pages.scatter.pasteBlock(row, column, cells); });
    paste(pages.engine, [&] { return pages.watch.pasteBlock(row, column, cells); });
    return 0;
}
