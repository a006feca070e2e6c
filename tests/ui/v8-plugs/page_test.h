#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/v8_plugs_page.h"
#include "widgets/number_field.h"
#include "workshop_page_test.h"

namespace ravnoves {

/// The page over a journal of its own, used as a person does. Not in an anonymous namespace: the
/// tests of all files here are of this one class.
class V8PageTest : public test::WorkshopPageTest<V8PlugsPage> {
  protected:
    NumberField* field(const char* name) { return find<NumberField>(name); }
    QString label(const char* name) { return find<QLabel>(name)->text(); }

    /// Answers the next message box with a button.
    static void answer(QMessageBox::StandardButton button) {
        whenModal<QMessageBox>(
            [button](QMessageBox* box) { QTest::mouseClick(box->button(button), Qt::LeftButton); });
    }

    template <typename Dialog, typename Act>
    static void whenModal(Act act) {
        test::whenModal<Dialog>(qApp, act);
    }
};

}  // namespace ravnoves
