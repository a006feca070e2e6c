#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "scenes/scenes.h"
#include "v8-plugs/presets.h"
#include "widgets/number_field.h"
#include "workshop/model/workshop_model.h"
#include "workshop/scene.h"
#include "workshop/workshop_page.h"
#include "workshop_page_test.h"

namespace ravnoves {

/// An example of plugs alone, as the window opens it.
inline Json plugsJob(const char* name) {
    const QString file = QStringLiteral(RAVNOVES_EXAMPLES) + u'/' + QString::fromLatin1(name);
    return workshop::as_job(parse_case(read_text_file(file.toStdString()))).input;
}
inline Json repairJob() {
    return plugsJob("v8-4.25-repair.case.json");
}

/// The text of a PDF, its spaces single.
inline QString textOfPdf(const QString& file) {
    QProcess reader;
    reader.start(QStringLiteral(PDFTOTEXT), {QStringLiteral("-layout"), QStringLiteral("-enc"),
                                             QStringLiteral("UTF-8"), file, QStringLiteral("-")});
    EXPECT_TRUE(reader.waitForFinished());
    return QString::fromUtf8(reader.readAllStandardOutput());
}

/// A new job of an engine with plugs.
class PlugsModel : public WorkshopModel {
  public:
    explicit PlugsModel(const QString& journal = {}) : WorkshopModel(journal) {
        setHasPlugs(true);
        newJob();
    }
};

/// The page over a journal of its own with a job of plugs, used as a person does. Not in an
/// anonymous namespace: the tests of all files here are of this one class.
class PlugsPageTest : public test::WorkshopPageTest<WorkshopPage> {
  protected:
    enum Sheet { Job, Parts, WeighIn, Plugs, Machine, Correction };

    PlugsPageTest() {
        model->setHasPlugs(true);
        model->newJob();
        model->desk()->setCardLanguage(QStringLiteral("en"));
    }
    ~PlugsPageTest() override { model->desk()->setCardLanguage({}); }

    NumberField* field(const char* name) { return find<NumberField>(name); }
    QString label(const char* name) { return find<QLabel>(name)->text(); }
    QColor colour(const char* name) {
        return find<QLabel>(name)->palette().color(QPalette::WindowText);
    }
    /// The nominal masses, without which there is no bob weight.
    void typeGear() {
        const std::pair<const char*, const char*> masses[] = {{"reciprocating_mass_g", "1000"},
                                                              {"rotating_mass_g", "650"},
                                                              {"oil_mass_g", "20"},
                                                              {"oil_coefficient", "1"}};
        for (const auto& [key, mass] : masses) {
            type(key, QLatin1String(mass));
        }
    }
    void show(Sheet sheet) { page.sheets()->setCurrentIndex(sheet); }
    void act(const QString& name) {
        for (QAction* action : page.sceneActions()) {
            if (action != nullptr && action->objectName() == name) {
                action->trigger();
            }
        }
    }
    /// What the card prints, in English unless another language is chosen.
    QString card() {
        const QString file = QDir(folder.path()).filePath(QStringLiteral("card.pdf"));
        EXPECT_EQ(page.writeCard(file), QString());
        return textOfPdf(file);
    }

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
