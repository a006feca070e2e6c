// Fills a sheet of the workshop field by field, as the page does, and says on standard output which
// fields it has left behind: "left N VALUE" when it goes on to the next. It is there to be killed.

#include <QCoreApplication>
#include <cstdio>

#include "v8-plugs/model/v8_plugs_model.h"

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    if (argc < 2) {
        std::fprintf(stderr, "usage: sheet_typist FILE\n");
        return 2;
    }
    ravnoves::V8PlugsModel model(QCoreApplication::arguments().at(1), nullptr);
    if (!model.desk()->openJournal()) {
        std::fprintf(stderr, "%s\n", qPrintable(model.desk()->journalTrouble()));
        return 1;
    }
    for (int field = 0; field < 100000; ++field) {
        const double grams = 600.0 + field % 997;
        model.edit(QString::number(field), [&](ravnoves::v8_plugs::Input& input) {
            if (!input.weigh_in) {
                input.weigh_in.emplace();
            }
            (*input.weigh_in)[ravnoves::v8_plugs::Part::piston]
                .mass[static_cast<std::size_t>(field % 8)] = grams * 1e-3;
            input.job.engine_number = std::to_string(field);
        });
        model.desk()->keepDraft();  // what the page does when a field loses the focus
        std::printf("left %d %g\n", field, grams);
        std::fflush(stdout);
    }
    return 0;
}
