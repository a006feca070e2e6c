#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "events.h"
#include "files.h"
#include "painted.h"
#include "scenes/scenes.h"
#include "theme/theme.h"
#include "widgets/number_field.h"
#include "widgets/result_table.h"
#include "workshop/model/workshop_model.h"
#include "workshop/older_formats.h"
#include "workshop/workshop_card.h"
#include "workshop/workshop_page.h"
#include "workshop/workshop_sheet.h"

namespace ravnoves {

/// An example of plugs alone, as the window opens it.
inline Json plugsJob(const char* name) {
    const QString file = QStringLiteral(RAVNOVES_EXAMPLES) + u'/' + QString::fromLatin1(name);
    return workshop::as_job(parse_case(read_text_file(file.toStdString()))).input;
}
inline Json repairJob() {
    return plugsJob("v8-4.25-repair.case.json");
}

/// An example of bob weights alone, whose planes are read and planned.
inline Json bobWeightsJob() {
    return Json::parse(read_text_file(RAVNOVES_EXAMPLES "/bob-weights-v8.case.json")).at("input");
}

/// The text of a PDF, its spaces single.
inline QString textOfPdf(const QString& file) {
    QProcess reader;
    reader.start(QStringLiteral(PDFTOTEXT), {QStringLiteral("-layout"), QStringLiteral("-enc"),
                                             QStringLiteral("UTF-8"), file, QStringLiteral("-")});
    EXPECT_TRUE(reader.waitForFinished());
    return QString::fromUtf8(reader.readAllStandardOutput());
}

/// Whether a text has a part, all of them, or begins with one; a failure shows the text.
inline ::testing::AssertionResult has(const QString& text, const auto& part) {
    return (text.contains(part) ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
           << qPrintable(text);
}
inline ::testing::AssertionResult hasAll(const QString& text, const QStringList& parts) {
    for (const QString& part : parts) {
        if (!text.contains(part)) {
            return ::testing::AssertionFailure() << qPrintable(part) << " in " << qPrintable(text);
        }
    }
    return ::testing::AssertionSuccess();
}
inline ::testing::AssertionResult begins(const QString& text, const QString& part) {
    return (text.startsWith(part) ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
           << qPrintable(text);
}

/// A new job of an engine with plugs, by the paper's masses: without the sizes that contradict
/// them.
inline void beginPlugs(WorkshopModel& model) {
    model.setHasPlugs(true);
    model.editPlugs({}, [](v8_plugs::Input& plugs) { plugs.plug.reset(); });
    model.newJob();
}
class PlugsModel : public WorkshopModel {
  public:
    explicit PlugsModel(const QString& journal = {}) : WorkshopModel(journal) { beginPlugs(*this); }
};

/// The page over a journal of its own, used as a person does. Not in an anonymous namespace: the
/// tests of several files are of this one class.
class JobPageTest : public ::testing::Test {
  protected:
    enum Sheet { JobTab, PartsTab, WeighInTab, PlugsTab, MachineTab, CorrectionTab };

    JobPageTest() {
        test::showAt(page, {1187, 712});
        page.activateWindow();
        page.openJournal();
    }

    template <typename Widget>
    Widget* find(const char* name) {
        return test::named<Widget>(page, name);
    }
    NumberField* field(const char* name) { return find<NumberField>(name); }
    QString label(const char* name) {
        return find<QLabel>(name)->text().replace(QChar(0x00A0), u' ');
    }
    QColor colour(const char* name) {
        return find<QLabel>(name)->palette().color(QPalette::WindowText);
    }
    bool isAmber(const char* name) { return colour(name) == Theme::instance().warning(); }
    /// In the order of Enter.
    QList<QWidget*> fieldsOf(int sheet) {
        return sheets->widget(sheet)->findChild<WorkshopSheet*>()->order();
    }
    void show(Sheet sheet) { sheets->setCurrentIndex(sheet); }

    Sheet sheetOf(const QWidget* field) {
        int sheet = sheets->count() - 1;
        while (sheet > 0 && !sheets->widget(sheet)->isAncestorOf(field)) {
            --sheet;
        }
        return static_cast<Sheet>(sheet);
    }
    /// Goes to the sheet's tab and the field, types over what is there, presses Enter.
    void type(QWidget* field, const QString& text) {
        show(sheetOf(field));
        field->setFocus(Qt::TabFocusReason);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void type(const char* name, const QString& text) { type(find<QWidget>(name), text); }
    /// Keys on a box, list or button, as one comes to it.
    void keys(const char* name, std::initializer_list<Qt::Key> pressed) {
        auto* widget = find<QWidget>(name);
        show(sheetOf(widget));
        widget->setFocus();
        for (const Qt::Key key : pressed) {
            QTest::keyClick(widget, key);
        }
    }
    void click(const char* name) { QTest::mouseClick(find<QWidget>(name), Qt::LeftButton); }
    void fill(const std::vector<std::pair<const char*, const char*>>& values) {
        for (const auto& [name, text] : values) {
            type(name, QString::fromUtf8(text));
        }
    }
    /// A column of the weigh-in sheet.
    void weigh(const char* part, const std::vector<double>& masses) {
        for (std::size_t i = 0; i < masses.size(); ++i) {
            type(("mass_" + std::string(part) + '_' + std::to_string(i + 1)).c_str(),
                 QString::number(masses[i]));
        }
    }
    void typeShopCard() {
        fill({{"rings", "69.5"},
              {"piston", "583.9"},
              {"pin", "173.6"},
              {"locks", "4.8"},
              {"small_end", "162.4"},
              {"big_end", "229.8"},
              {"shells", "23.7"},
              {"oil", "4"}});
    }
    /// A limit of each plane in place of a grade, as one types it.
    void typeLimit(const QString& gramMillimetres) {
        keys("own_limit", {Qt::Key_Space});
        type("g_mm", gramMillimetres);
    }
    void typeReadings() {
        fill({{"position_1", "60"},
              {"radius_1", "85"},
              {"unbalance_1", "2600"},
              {"angle_1", "75"},
              {"position_2", "480"},
              {"radius_2", "85"},
              {"angle_2", "210"},
              {"unbalance_2", "1450"},
              {"maximum_depth_mm", "35"},
              {"diameters_mm", "8 10 12.5; 16"}});
    }
    /// Both planes of a run: unbalance and angle, then the same of the rear one.
    void typeRun(int run, const QStringList& values) {
        const char* const keys[] = {"unbalance_1", "angle_1", "unbalance_2", "angle_2"};
        for (qsizetype i = 0; i < values.size(); ++i) {
            type(QStringLiteral("run_%1_%2").arg(run).arg(QLatin1String(keys[i])).toLatin1(),
                 values[i]);
        }
    }
    void limitTo(double gramMillimetres) {
        model->editTolerance(QStringLiteral("limit"), [=](bob_weights::Tolerance& it) {
            it.by_grade = false;
            it.plane = gramMillimetres * units::gram_mm;
        });
    }

    /// A key that is an action's, wherever the focus is; what it saves is saved then.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        ASSERT_TRUE(test::becomesActive(page));
        QTest::keyClick(&page, key, modifiers);
    }
    void save() { press(Qt::Key_F2); }
    /// Saves and answers the question. @return what was asked
    QString saveAnd(const QString& button) {
        const auto asked = answer(button);
        save();
        return *asked;
    }
    void act(const QString& name) {
        for (QAction* action : page.sceneActions()) {
            if (action != nullptr && action->objectName() == name) {
                action->trigger();
            }
        }
    }
    QList<JournalJob> jobs() { return model->desk()->journal()->search({}); }

    template <typename Dialog, typename Act>
    static void whenModal(Act act) {
        test::whenModal<Dialog>(qApp, act);
    }
    /// Clicks the button of the next question that begins with the text. @return what was asked
    static std::shared_ptr<QString> answer(const QString& button) {
        auto asked = std::make_shared<QString>();
        whenModal<QMessageBox>([=](QMessageBox* box) {
            *asked = box->text();
            for (QAbstractButton* each : box->buttons()) {
                if (each->text().remove(u'&').startsWith(button)) {
                    QTest::mouseClick(each, Qt::LeftButton);
                    return;
                }
            }
            ADD_FAILURE() << "no button " << qPrintable(button);
            box->reject();
        });
        return asked;
    }

    int rowsOf(const char* accessibleName) {
        for (const ResultTable* table : page.findChildren<ResultTable*>()) {
            if (table->accessibleName() == QLatin1String(accessibleName)) {
                return table->rowCount();
            }
        }
        return -1;
    }
    /// What the verdict begins with: "Passes", "Fails", "STOP".
    QString verdict() {
        static const QRegularExpression end(QStringLiteral("[:.]"));
        return label("verdict").section(end, 0, 0);
    }
    /// What the job card prints, in English.
    QString card(const QStringList& rejected = {}) {
        onCard = {};
        test::Recorder recorder({2100, 2970}, onCard);
        QPainter painter(&recorder);
        paintPaper(jobCard(*model, Words(QStringLiteral("en")), rejected, rejected), painter,
                   {0, 0, 2100, 2970}, [] { return true; });
        painter.end();
        QStringList texts;
        for (const auto& each : onCard.texts) {
            texts << each.text;
            EXPECT_LE(each.ink.bottom(), 2970) << qPrintable(each.text);
        }
        return texts.join(u'\n').replace(QChar(0x00A0), u' ');
    }
    /// The same, lines that were broken made whole.
    QString cardText() { return card().replace(u'\n', u' '); }

    QTemporaryDir folder;
    WorkshopPage page{QDir(folder.path()).filePath(QStringLiteral("journal.sqlite")), nullptr};
    WorkshopModel* model = page.viewModel();
    QTabWidget* sheets = find<QTabWidget>("sheets");
    test::Painted onCard;  ///< by card()
};

/// The same with the masses of the shop's card.
class CardJobTest : public JobPageTest {
  protected:
    CardJobTest() { typeShopCard(); }
};

/// And with the machine's readings, in planes at 60 and 480 mm.
class ReadJobTest : public CardJobTest {
  protected:
    ReadJobTest() { typeReadings(); }
};

/// A job of plugs.
class PlugsPageTest : public JobPageTest {
  protected:
    PlugsPageTest() {
        beginPlugs(*model);
        model->desk()->setCardLanguage(QStringLiteral("en"));
    }
    ~PlugsPageTest() override { model->desk()->setCardLanguage({}); }

    /// The nominal masses, without which there is no bob weight.
    void typeGear() {
        fill({{"reciprocating_mass_g", "1000"},
              {"rotating_mass_g", "650"},
              {"oil_mass_g", "20"},
              {"oil_coefficient", "1"}});
    }
};

}  // namespace ravnoves
