// Every page in other units than its own: nothing on it is left in the old ones, and the numbers of
// its tables are the same quantities.

#include "text/shown_units.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QTabWidget>
#include <memory>
#include <string>

#include "events.h"
#include "page/scene_page.h"
#include "painted.h"
#include "plot/plot_view.h"
#include "scene_tests.h"
#include "scenes/open_example.h"
#include "shown_number.h"
#include "text/csv_format.h"
#include "text/preferences.h"
#include "widgets/result_table.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

/// What a page says on all of its tabs.
struct Said {
    QStringList texts;  ///< as they are drawn, those of plots and pictures too
    QStringList labels;
    QList<QVector<QStringList>> tables;  ///< headings first
};

QVector<QStringList> cellsOf(const ResultTable& table) {
    QVector<QStringList> all(table.rowCount() + 1);
    for (int column = 0; column < table.columnCount(); ++column) {
        all[0] << table.horizontalHeaderItem(column)->text();
        for (int row = 0; row < table.rowCount(); ++row) {
            const QTableWidgetItem* cell = table.item(row, column);
            all[row + 1] << (cell != nullptr ? cell->text() : QString());
        }
    }
    return all;
}

class PageInOtherUnits : public ::testing::TestWithParam<std::string> {
  protected:
    ~PageInOtherUnits() override {
        QSettings().clear();
        Preferences::instance().load();
    }

    static bool isHinge() { return GetParam() == "elastic-hinge"; }
    static void chooseUnits() {
        Preferences& preferences = Preferences::instance();
        for (const auto quantity :
             {Preferences::Length, Preferences::Mass, Preferences::Torque, Preferences::Force}) {
            preferences.setUnits(quantity, Preferences::Units::Imperial);
        }
        preferences.setUnits(Preferences::Speed, isHinge() ? Preferences::Units::Rpm
                                                           : Preferences::Units::RadPerSecond);
    }

    void look(ScenePage& page, Said& said) {
        QApplication::processEvents();
        EXPECT_TRUE(test::comes([&] { return !page.isBusy(); }));
        QApplication::processEvents();
        for (QWidget* each : page.findChildren<QWidget*>()) {
            if (each->isVisible()) {
                for (const test::PaintedText& painted : test::painted(*each).texts) {
                    said.texts << painted.text;
                }
            }
        }
        for (const QLabel* label : page.findChildren<QLabel*>()) {
            if (label->isVisible()) {
                said.labels << label->text();
            }
        }
        for (const PlotView* plot : page.findChildren<PlotView*>()) {
            if (plot->isVisible()) {
                said.texts << plot->sentence()
                           << plot->csv(CsvFormat(QLocale::c())).section(u'\n', 0, 0);
            }
        }
        for (const ResultTable* table : page.findChildren<ResultTable*>()) {
            if (table->isVisible()) {
                said.tables << cellsOf(*table);
            }
        }
    }
    Said allOf() {
        Said said;
        const std::unique_ptr<ScenePage> page = test::makePage(GetParam());
        test::openExample(*page->model());
        test::showAt(*page, {1500, 950});
        look(*page, said);
        for (QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
            for (int i = 1; i < tabs->count(); ++i) {
                // What papers print stays in their units.
                if (tabs->isVisible() && tabs->widget(i)->objectName() != u"validation"_s) {
                    tabs->setCurrentIndex(i);
                    look(*page, said);
                }
            }
        }
        said.texts.removeDuplicates();
        return said;
    }
};

/// The units, by their names, that a number of a table may be in: that of its column, of its row,
/// of a column for units, of the table.
QStringList unitsOf(const QVector<QStringList>& table, qsizetype row, qsizetype column) {
    const QStringList& headings = table[0];
    if (headings.last() == u"Unit"_s) {
        return {table[row].last()};
    }
    for (const QString& title : {headings[column], table[row][0]}) {
        if (const QString unit = unitOfTitle(title); !unit.isEmpty()) {
            return {unit};
        }
    }
    const QString unit = unitOfTitle(headings[0]);
    return unit.isEmpty() ? QString(headings[0]).remove(u" about z₀"_s).split(u"; "_s)
                          : QStringList{unit};
}

void compare(const QVector<QStringList>& own, const QVector<QStringList>& other, int& converted) {
    ASSERT_EQ(own.size(), other.size());
    for (qsizetype row = 1; row < own.size(); ++row) {
        for (qsizetype column = 1; column < own[row].size(); ++column) {
            const auto was = test::readShownNumber(own[row][column]);
            const auto is = test::readShownNumber(other[row].value(column));
            if (!was || !is) {
                continue;
            }
            bool isSame = false;
            // A cell may carry its unit.
            const QStringList units =
                was->unit.isEmpty() ? unitsOf(own, row, column) : QStringList{was->unit};
            for (const QString& unit : units) {
                const double factor = shownUnit(unit).factor;
                const double wanted = factor * was->value;
                const double rounding = 0.51 * (factor * std::pow(10.0, -was->decimals) +
                                                std::pow(10.0, -is->decimals));
                isSame = isSame || std::abs(is->value - wanted) <=
                                       rounding + (was->isPlain ? 0.0 : 1e-3 * std::abs(wanted));
                converted += factor != 1.0 && was->value != 0.0 ? 1 : 0;
            }
            EXPECT_TRUE(isSame) << own[row].join(u" | "_s).toStdString() << "  against  "
                                << other[row].join(u" | "_s).toStdString() << "  in "
                                << own[0].join(u" | "_s).toStdString();
        }
    }
}

TEST_P(PageInOtherUnits, HasNothingLeftInItsOwn) {
    const QRegularExpression left(
        u"(?:^|[\\d\u2013][\\s\u00A0]|, |; |\\()"
        "(?:mm|µm|cm²|cm³|kg|g|g·mm|kg·m²|kg/m³|N|kN|N·m|N/m|kN/m|%1)"
        "(?=$|[\\s\u00A0,.;:)\"])"_s.arg(isHinge() ? u"rad/s"_s : u"min⁻¹"_s),
        QRegularExpression::UseUnicodePropertiesOption);
    // The pattern finds them where they are …
    const Said own = allOf();
    EXPECT_TRUE(own.texts.filter(left).size() > 3 || GetParam() == "methods");
    // … and elsewhere there are none.
    chooseUnits();
    const Said other = allOf();
    for (qsizetype i = 0; i < other.texts.size(); ++i) {
        // A letter alone is one with the line of a mnemonic, but for a label's whole text.
        if (other.texts[i].contains(left) && other.texts[i] != u"g"_s && other.texts[i] != u"N"_s) {
            ADD_FAILURE() << other.texts[i].toStdString() << "  after  "
                          << other.texts.value(i - 1).toStdString();
        }
    }
    EXPECT_FALSE(other.labels.contains(u"g"_s) || other.labels.contains(u"N"_s));
    // The numbers of tables are the same quantities.
    ASSERT_EQ(own.tables.size(), other.tables.size());
    int converted = 0;
    for (qsizetype i = 0; i < own.tables.size(); ++i) {
        compare(own.tables[i], other.tables[i], converted);
    }
    EXPECT_TRUE(converted > 1 || GetParam() == "methods") << converted;
}

INSTANTIATE_TEST_SUITE_P(Scenes, PageInOtherUnits, ::testing::ValuesIn(test::sceneNames()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);

}  // namespace
}  // namespace ravnoves
