#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <functional>

#include "balance-shaft/import_dialog.h"
#include "events.h"

namespace ravnoves::test {

/// Waits until the import window shows the file by its present settings.
inline bool isRead(const ImportDialog& dialog) {
    const auto* progress = dialog.findChild<QProgressBar*>();
    return test::comes([progress] { return !progress->isVisible(); });
}

/// Leaves the angles of a trace as they are.
inline void keepAngles(ImportDialog& dialog) {
    if (auto* shift = named<QCheckBox>(dialog, "import_shift"); shift->isChecked()) {
        shift->click();
    }
}

/// Decides how long a cycle is.
inline void chooseCycle(ImportDialog& dialog, int strokes) {
    auto* cycle = named<QComboBox>(dialog, "import_cycle");
    cycle->setFocus();
    QTest::keyClick(cycle, strokes == 2 ? Qt::Key_Home : Qt::Key_End);
    EXPECT_TRUE(isRead(dialog));
}

/// Opens the import window by `open`, acts in it once the file is read, and presses Import; where
/// that cannot be pressed, Cancel.
/// @return what is said about the file there
inline QString importBy(
    QWidget& page, const std::function<void()>& open,
    const std::function<void(ImportDialog&)>& act = [](ImportDialog&) {}) {
    QString said;
    whenModal<ImportDialog>(&page, [&](ImportDialog* dialog) {
        EXPECT_TRUE(isRead(*dialog));
        act(*dialog);
        EXPECT_TRUE(isRead(*dialog));
        said = named<QLabel>(*dialog, "import_understood")->text();
        auto* import = named<QPushButton>(*dialog, "import_accept");
        if (import->isEnabled()) {
            QTest::mouseClick(import, Qt::LeftButton);
        } else {
            dialog->reject();
        }
    });
    open();
    return said;
}

}  // namespace ravnoves::test
