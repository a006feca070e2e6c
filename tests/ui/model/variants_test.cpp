// Inputs kept beside the present one: history, file, and what is refused.

#include "model/variants.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "model/input_differences.h"
#include "model/root_model.h"
#include "text/difference_text.h"

namespace ravnoves {
namespace {

class VariantsTest : public ::testing::Test {
  protected:
    QStringList names() const {
        QStringList all;
        for (const Variant& variant : model.variants()) {
            all << variant.name;
        }
        return all;
    }
    double square() const { return model.input().square; }
    double squareOf(int place) const {
        return model.variantInput(place).at("crank_radius_mm").get<double>();
    }

    test::RootModel model;
};

TEST_F(VariantsTest, AreNamedByLettersThatNoOtherHas) {
    for (int i = 0; i < 28; ++i) {
        model.keepVariant();
    }
    EXPECT_EQ(names().first(), QStringLiteral("A"));
    EXPECT_EQ(names()[25], QStringLiteral("Z"));
    EXPECT_EQ(names()[26], QStringLiteral("A2"));
    model.removeVariant(1);
    model.keepVariant();
    EXPECT_EQ(names().last(), QStringLiteral("B"));
    model.keepVariant(QStringLiteral(" light piston "));
    EXPECT_EQ(names().last(), QStringLiteral("light piston"));
    model.keepVariant(QStringLiteral("light piston"));
    EXPECT_EQ(names().last(), QStringLiteral("C2"));
}

TEST_F(VariantsTest, EachChangeIsOneStepThatIsUndone) {
    model.keepVariant();
    model.set("square", 9.0);
    model.keepVariant();
    EXPECT_EQ(model.reference(), 1);
    EXPECT_EQ(model.renameVariant(0, QStringLiteral("heavy")), QString());
    EXPECT_EQ(model.swapVariant(0), QString());
    EXPECT_EQ(square(), 4.0);
    EXPECT_EQ(squareOf(0), 9.0);
    model.removeVariant(1);
    EXPECT_EQ(names(), QStringList{QStringLiteral("heavy")});
    EXPECT_EQ(model.reference(), -1);
    EXPECT_EQ(model.history()->count(), 6);

    model.undo();
    EXPECT_EQ(names(), (QStringList{QStringLiteral("heavy"), QStringLiteral("B")}));
    EXPECT_EQ(model.reference(), 1);
    model.undo();
    EXPECT_EQ(square(), 9.0);
    EXPECT_EQ(squareOf(0), 4.0);
    model.undo();
    EXPECT_EQ(names()[0], QStringLiteral("A"));
    model.undo();
    model.undo();
    EXPECT_EQ(square(), 4.0);
    EXPECT_EQ(names().size(), 1);
    model.undo();
    EXPECT_TRUE(names().isEmpty());
    EXPECT_EQ(model.reference(), -1);
    EXPECT_FALSE(model.hasChanges());
    for (int i = 0; i < 6; ++i) {
        model.redo();
    }
    EXPECT_EQ(names(), QStringList{QStringLiteral("heavy")});
    EXPECT_EQ(square(), 4.0);
    EXPECT_EQ(squareOf(0), 9.0);
}

TEST_F(VariantsTest, SwapTwiceIsIdentityAndTakingKeepsTheVariant) {
    model.keepVariant();
    model.set("square", 9.0);
    const QList<Variant> before = model.variants();
    model.swapVariant(0);
    model.swapVariant(0);
    EXPECT_EQ(model.variants(), before);
    EXPECT_EQ(square(), 9.0);
    EXPECT_EQ(model.takeVariant(0), QString());
    EXPECT_EQ(square(), 4.0);
    EXPECT_EQ(model.variants(), before);
    const int steps = model.history()->count();
    model.takeVariant(0);  // is the present one already
    EXPECT_EQ(model.history()->count(), steps);
}

TEST_F(VariantsTest, ChoosingAReferenceIsNoChangeOfTheCase) {
    model.keepVariant();
    model.keepVariant();
    model.history()->setClean();
    QSignalSpy told(&model, &SceneModel::variantsChanged);
    model.chooseReference(0);
    model.chooseReference(0);
    EXPECT_EQ(told.size(), 1);
    EXPECT_FALSE(model.hasChanges());
    model.set("square", 9.0);
    model.chooseReference(-1);
    model.undo();
    EXPECT_EQ(model.reference(), -1);  // what is looked at is nothing that is undone
    model.chooseReference(7);
    EXPECT_EQ(model.reference(), -1);
    model.chooseReference(1);
    model.removeVariant(0);
    EXPECT_EQ(model.reference(), 0);
}

TEST_F(VariantsTest, KeepingSolvesNothing) {
    test::RootScene scene;
    test::RootModel counted(scene);
    *scene.solves = 0;
    counted.keepVariant();
    counted.renameVariant(0, QStringLiteral("x"));
    counted.removeVariant(0);
    EXPECT_EQ(*scene.solves, 0);
}

TEST_F(VariantsTest, ANameIsNeededAndOfOneAlone) {
    model.keepVariant();
    model.keepVariant();
    const int steps = model.history()->count();
    EXPECT_FALSE(model.renameVariant(0, QStringLiteral("  ")).isEmpty());
    EXPECT_FALSE(model.renameVariant(0, QStringLiteral("B")).isEmpty());
    EXPECT_EQ(model.renameVariant(0, QStringLiteral("A")), QString());
    EXPECT_EQ(model.history()->count(), steps);
}

TEST_F(VariantsTest, WhatIsTypedIsKeptAsItStands) {
    model.beginEditing();
    model.step("square", 9.0);
    model.keepVariant();
    EXPECT_EQ(squareOf(0), 9.0);
    model.step("square", 16.0);
    model.endEditing();
    EXPECT_EQ(model.history()->count(), 3);
    model.undo();
    EXPECT_EQ(square(), 9.0);
    EXPECT_EQ(names().size(), 1);
}

TEST_F(VariantsTest, GoWithTheCaseThroughItsFile) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("v.case.json"));
    model.set("square", 0.1 + 0.2);
    model.keepVariant(QStringLiteral("Ж \"1\""));
    model.set("square", 9.0);
    ASSERT_EQ(CaseDocument(&model, {}).saveTo(path), QString());

    test::RootModel other;
    other.keepVariant(QStringLiteral("goes"));
    CaseDocument document(&other, {});
    document.open(CaseDocument::read(path), path);
    EXPECT_EQ(other.variants(), model.variants());
    EXPECT_EQ(other.input().square, 9.0);
    EXPECT_EQ(other.variantInput(0).at("crank_radius_mm"), 0.1 + 0.2);
    EXPECT_EQ(other.reference(), -1);
    EXPECT_FALSE(document.needsSaving());
    other.setByKey(QStringLiteral("crank_radius_mm"), QStringLiteral("16"));
    EXPECT_EQ(other.variants(), model.variants());
    other.loadDefault();
    EXPECT_TRUE(other.variants().isEmpty());
}

TEST_F(VariantsTest, AnInputThatIsRefusedStaysWithItsReason) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("v.case.json"));
    model.keepVariant();
    ASSERT_EQ(CaseDocument(&model, {}).saveTo(path), QString());
    CaseFile file = CaseDocument::read(path);
    file.variants[0].input["crank_radius_mm"] = -1.0;
    file.variants.push_back({"odd", {{"radius", 1.0}}});
    CaseDocument document(&model, {});
    document.open(file, path);
    ASSERT_EQ(names().size(), 2);
    EXPECT_FALSE(model.variantTrouble(0).isEmpty());
    EXPECT_FALSE(model.variantTrouble(1).isEmpty());
    EXPECT_FALSE(model.variantTrouble(0).contains(QLatin1Char('/')))
        << model.variantTrouble(0).toStdString();
    EXPECT_EQ(model.takeVariant(0), model.variantTrouble(0));
    EXPECT_EQ(model.swapVariant(1), model.variantTrouble(1));
    EXPECT_EQ(square(), 4.0);
    EXPECT_EQ(names().size(), 2);
    ASSERT_EQ(document.saveTo(path), QString());
    EXPECT_EQ(CaseDocument::read(path).variants, file.variants);
}

TEST_F(VariantsTest, InputsThatDifferAreListedByLabel) {
    model.keepVariant();
    EXPECT_TRUE(inputDifferences(model, model.variantInput(0)).empty());
    model.set("square", 5.0);
    const auto found = inputDifferences(model, model.variantInput(0));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pointer, "/crank_radius_mm");
    EXPECT_EQ(found[0].name, QStringLiteral("Square"));
    EXPECT_EQ(found[0].present, QStringLiteral("5"));
    EXPECT_EQ(found[0].reference, QStringLiteral("4"));
    EXPECT_EQ(found[0].absolute(), QStringLiteral("+1"));
    EXPECT_EQ(found[0].percent(), QStringLiteral("+25.0\u00A0%"));
    const auto lists =
        inputDifferences(model, {{"crank_radius_mm", 5.0}, {"list", {1.0, 2.0}}, {"word", "x"}});
    ASSERT_EQ(lists.size(), 3U);
    EXPECT_EQ(lists[0].pointer, "/list/0");
    EXPECT_TRUE(lists[0].present.isEmpty());
    EXPECT_EQ(lists[2].reference, QStringLiteral("x"));
    EXPECT_TRUE(lists[2].absolute().isEmpty());
}

TEST(DifferenceText, IsOfTheNumbersThatAreShown) {
    const auto check = [](const char16_t* now, const char16_t* was, const char16_t* absolute,
                          const char16_t* percent) {
        const auto found = difference(QString::fromUtf16(now), QString::fromUtf16(was));
        ASSERT_TRUE(found) << QString::fromUtf16(now).toStdString();
        EXPECT_EQ(found->absolute, QString::fromUtf16(absolute));
        EXPECT_EQ(found->percent, QString::fromUtf16(percent));
    };
    check(u"1208.0", u"1200.5", u"+7.5", u"+0.6\u00A0%");
    check(u"\u2212893.0", u"\u2212900.0", u"+7.0", u"+0.8\u00A0%");
    check(u"0.65", u"0.6580", u"\u22120.0080", u"\u22121.2\u00A0%");
    check(u"5", u"5", u"0", u"0\u00A0%");
    check(u"5", u"0", u"+5", u"–");
    check(u"+32.1\u00A0%", u"+30.0\u00A0%", u"+2.1", u"");
    check(u"359.0°", u"1.0°", u"\u22122.0", u"");
    check(u"1.2E6", u"1.0E6", u"+2e+05", u"+20.0\u00A0%");
    check(u"0.30 / 0.50", u"0.25 / 0.60", u"+0.05 / −0.10", u"+20.0\u00A0% / −16.7\u00A0%");
    check(u"178 × 305", u"170 × 305", u"+8 × 0", u"+4.7\u00A0% × 0\u00A0%");
    check(u"1.20 (0.5\u00A0%)", u"1.00 (0.4\u00A0%)", u"+0.20 (+0.1\u00A0%)", u"+20.0\u00A0%");
    check(u"12.50 (÷ 9.1)", u"10.00 (÷ 11.4)", u"+2.50", u"+25.0\u00A0%");
    EXPECT_FALSE(difference(QStringLiteral("0.30 / 0.50"), QStringLiteral("–")));
    for (const char16_t* text : {u"–", u"178 × 305", u"", u"none", u"1-3-4-2", u"5/6"}) {
        EXPECT_FALSE(readShownNumber(QString::fromUtf16(text)))
            << QString::fromUtf16(text).toStdString();
    }
}

}  // namespace
}  // namespace ravnoves
