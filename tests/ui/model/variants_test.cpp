// Inputs kept beside the present one: history, file, and what is rejected.

#include "model/variants.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "model/input_differences.h"
#include "model/root_model.h"
#include "text/result_row.h"

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
    EXPECT_EQ(model.takeVariant(0), QString());
    EXPECT_EQ(square(), 4.0);
    model.removeVariant(1);
    EXPECT_EQ(names(), QStringList{QStringLiteral("heavy")});
    EXPECT_EQ(model.reference(), -1);
    EXPECT_EQ(model.history()->count(), 6);

    model.undo();
    EXPECT_EQ(names(), (QStringList{QStringLiteral("heavy"), QStringLiteral("B")}));
    EXPECT_EQ(model.reference(), 1);
    model.undo();
    EXPECT_EQ(square(), 9.0);
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
}

TEST_F(VariantsTest, TakingKeepsTheVariant) {
    model.keepVariant();
    model.set("square", 9.0);
    const QList<Variant> before = model.variants();
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
    QSignalSpy reported(&model, &SceneModel::variantsChanged);
    model.chooseReference(0);
    model.chooseReference(0);
    EXPECT_EQ(reported.size(), 1);
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
    ASSERT_EQ(CaseDocument(&model).saveTo(path), QString());

    test::RootModel other;
    other.keepVariant(QStringLiteral("goes"));
    CaseDocument document(&other);
    document.open(CaseDocument::read(path), path);
    EXPECT_EQ(other.variants(), model.variants());
    EXPECT_EQ(other.input().square, 9.0);
    EXPECT_EQ(other.variantInput(0).at("crank_radius_mm"), 0.1 + 0.2);
    EXPECT_EQ(other.reference(), 0);
    EXPECT_FALSE(document.needsSaving());
    other.setByKey(QStringLiteral("crank_radius_mm"), QStringLiteral("16"));
    EXPECT_EQ(other.variants(), model.variants());
    other.loadCase({{"crank_radius_mm", 4.0}}, {}, {});
    EXPECT_TRUE(other.variants().isEmpty());
}

TEST_F(VariantsTest, AnInputThatIsRejectedStaysWithItsReason) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("v.case.json"));
    model.keepVariant();
    ASSERT_EQ(CaseDocument(&model).saveTo(path), QString());
    CaseFile file = CaseDocument::read(path);
    file.variants[0].input["crank_radius_mm"] = -1.0;
    file.variants.push_back({"odd", {{"radius", 1.0}}});
    CaseDocument document(&model);
    document.open(file, path);
    ASSERT_EQ(names().size(), 2);
    const QString why = model.takeVariant(0);
    EXPECT_FALSE(why.isEmpty());
    EXPECT_FALSE(why.contains(QLatin1Char('/'))) << why.toStdString();
    EXPECT_FALSE(model.takeVariant(1).isEmpty());
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
    const auto difference = found[0].present.from(found[0].reference);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->absolute, QStringLiteral("+1"));
    // The same to the last digits of a double, as another unit makes them, is no difference.
    EXPECT_TRUE(inputDifferences(model, {{"crank_radius_mm", 5.0 * (1.0 + 4e-16)}}).empty());
    const auto lists =
        inputDifferences(model, {{"crank_radius_mm", 5.0}, {"list", {1.0, 2.0}}, {"word", "x"}});
    ASSERT_EQ(lists.size(), 3U);
    EXPECT_EQ(lists[0].pointer, "/list/0");
    EXPECT_TRUE(lists[0].present.text.isEmpty());
    EXPECT_EQ(lists[2].reference, QStringLiteral("x"));
    EXPECT_FALSE(lists[2].present.from(lists[2].reference));
    // No more digits than it takes to tell them apart.
    const auto computed = [&](double square) {
        const auto all = inputDifferences(model, {{"crank_radius_mm", square}});
        const auto& [pointer, name, unit, present, reference] = all.front();
        return QStringList{present, reference, present.from(reference)->absolute};
    };
    using namespace Qt::StringLiterals;
    EXPECT_EQ(computed(11.14493322), (QStringList{u"5"_s, u"11.1449"_s, u"−6.1449"_s}));
    EXPECT_EQ(computed(5.00000012), (QStringList{u"5"_s, u"5.0000001"_s, u"−0.0000001"_s}));
}

TEST(ResultCells, DifferByTheNumbersThatAreShown) {
    using namespace Qt::StringLiterals;
    using Kind = ResultCell::Kind;
    const auto check = [](const ResultCell& now, const ResultCell& was, const QString& absolute,
                          const QString& percent) {
        const auto found = now.from(was);
        ASSERT_TRUE(found) << now.text.toStdString();
        EXPECT_EQ(found->absolute, absolute);
        EXPECT_EQ(found->percent, percent);
    };
    const auto number = [](double value, const char16_t* text, Kind kind = Kind::Plain,
                           const QString& unit = {}) {
        return ResultCell(value, QString::fromUtf16(text), kind, unit);
    };
    const auto two = [](const char16_t* pattern, const ResultCell& first,
                        const ResultCell& second) {
        return ResultCell::two(QString::fromUtf16(pattern), first, second);
    };
    check(number(1208.04, u"1208.0"), number(1200.47, u"1200.5"), u"+7.5"_s, u"+0.6\u00A0%"_s);
    check(number(-893, u"\u2212893.0"), number(-900, u"\u2212900.0"), u"+7.0"_s, u"+0.8\u00A0%"_s);
    check(number(0.65, u"0.65"), number(0.658, u"0.6580"), u"\u22120.0080"_s,
          u"\u22121.2\u00A0%"_s);
    check(number(5, u"5"), number(0, u"0"), u"+5"_s, u"–"_s);
    check(number(32.1, u"+32.1\u00A0%", Kind::Percent), number(30, u"+30.0\u00A0%", Kind::Percent),
          u"+2.1"_s, {});
    check(number(359, u"359.0°", Kind::Direction), number(1, u"1.0°", Kind::Direction),
          u"\u22122.0"_s, {});
    check(number(1.2e6, u"1.2e+06"), number(1e6, u"1.0·10⁶"), u"+2e+05"_s, u"+20.0\u00A0%"_s);
    check(number(12.3, u"12.3 g·mm"), number(12.1, u"12.1 g·mm"), u"+0.2"_s, u"+1.7\u00A0%"_s);
    check(two(u"%1 / %2", number(0.3, u"0.30"), number(0.5, u"0.50")),
          two(u"%1 / %2", number(0.25, u"0.25"), number(0.6, u"0.60")), u"+0.05 / −0.10"_s,
          u"+20.0\u00A0% / −16.7\u00A0%"_s);
    check(two(u"%1 × %2", number(178, u"178"), number(305, u"305")),
          two(u"%1 × %2", number(170, u"170"), number(305, u"305")), u"+8 × 0"_s,
          u"+4.7\u00A0% × 0\u00A0%"_s);
    check(two(u"%1 (%2)", number(1.2, u"1.20"), number(0.5, u"0.5\u00A0%", Kind::Percent)),
          two(u"%1 (%2)", number(1, u"1.00"), number(0.4, u"0.4\u00A0%", Kind::Percent)),
          u"+0.20 (+0.1\u00A0%)"_s, u"+20.0\u00A0%"_s);
    EXPECT_FALSE(number(5.04, u"5").from(number(4.96, u"5"))) << "equal as shown";
    EXPECT_FALSE(number(5, u"5").from(u"–"_s));
    EXPECT_FALSE(ResultCell(u"5"_s).from(u"4"_s)) << "words";
    EXPECT_FALSE(number(5, u"5", Kind::Plain, u"N"_s).from(number(4, u"4", Kind::Plain, u"kg"_s)));
    EXPECT_FALSE(number(5, u"5", Kind::Change).from(number(4, u"4", Kind::Change)));
    EXPECT_EQ(number(std::nan(""), u"–").number(), nullptr);
}

}  // namespace
}  // namespace ravnoves
