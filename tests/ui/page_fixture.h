#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>

#include "events.h"
#include "page/part_views.h"
#include "widgets/number_field.h"
#include "widgets/page_columns.h"

namespace ravnoves::test {

/// A page as a window of a usual size, and what a hand does there.
template <typename Page>
class PageTest : public ::testing::Test {
  protected:
    PageTest() {
        showAt(page, {1187, 712});
        page.activateWindow();
    }

    template <typename Widget>
    Widget* find(const char* name) {
        return named<Widget>(page, name);
    }
    NumberField* field(const char* name) { return find<NumberField>(name); }
    void type(const char* name, const QString& text) { test::type(field(name), text); }
    /// Empties a field and presses Enter.
    void blank(const char* name) {
        field(name)->setFocus();
        field(name)->selectAll();
        QTest::keyClick(field(name), Qt::Key_Delete);
        QTest::keyClick(field(name), Qt::Key_Return);
    }
    /// Presses a button or ticks a box.
    void press(const char* name) {
        auto* button = find<QAbstractButton>(name);
        QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(8, button->height() / 2));
    }
    void choose(const char* name, int index) {
        auto* box = find<QComboBox>(name);
        box->setFocus();
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    }
    /// Brings the tab of a widget to the front.
    template <typename Widget>
    Widget* bring(Widget* widget) {
        showTabOf(widget);
        QApplication::processEvents();
        return widget;
    }
    void bring(const char* name) { bring(find<QWidget>(name)); }
    /// The same of the plot of a part.
    PartPlot* bringPlot(std::string_view part) { return bring(partPlot(page, part)); }

    Page page;
    decltype(page.viewModel()) model = page.viewModel();
};

}  // namespace ravnoves::test
