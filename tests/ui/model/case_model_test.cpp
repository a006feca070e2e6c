// What CaseModel does for every scene: change, reject, merge, undo, load.

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "case-file/case_file.h"
#include "model/root_model.h"

namespace ravnoves {
namespace {

class CaseModelTest : public ::testing::Test {
  protected:
    /// How often the scene solved since the last time this was asked.
    int solves() { return std::exchange(*scene.solves, 0); }

    test::RootScene scene;
    test::RootModel model{scene};
    QSignalSpy changes{&model, &SceneModel::changed};
};

TEST_F(CaseModelTest, AChangeIsSolvedOnce) {
    solves();
    EXPECT_EQ(model.set("square", 9.0), QString());
    EXPECT_EQ(solves(), 1);
    EXPECT_EQ(model.root(), 3.0);
    EXPECT_EQ(changes.size(), 1);
    EXPECT_EQ(model.takes, 1);
    EXPECT_FALSE(model.history()->isClean());
}

TEST_F(CaseModelTest, NoChangeIsNoStepAndIsNotSolved) {
    solves();
    EXPECT_EQ(model.set("square", 4.0), QString());
    EXPECT_EQ(solves(), 0);
    EXPECT_EQ(changes.size(), 0);
    EXPECT_FALSE(model.history()->canUndo());
}

TEST_F(CaseModelTest, WhatIsRejectedChangesNothingAndSaysWhy) {
    QSignalSpy rejected(&model, &SceneModel::rejected);
    const QString why = model.set("square", -1.0);
    EXPECT_TRUE(why.contains(QStringLiteral("negative"))) << why.toStdString();
    EXPECT_FALSE(why.contains(QLatin1Char('/'))) << why.toStdString();  // no JSON pointer
    ASSERT_EQ(rejected.size(), 1);
    EXPECT_EQ(rejected[0][0].toString(), why);
    EXPECT_EQ(model.input().square, 4.0);
    EXPECT_EQ(model.root(), 2.0);
    EXPECT_EQ(changes.size(), 0);
    EXPECT_FALSE(model.history()->canUndo());
    // What comes next is not taken for what was rejected, which is over.
    EXPECT_EQ(model.step("square", 16.0), QString());
    model.step("square", 25.0);
    EXPECT_EQ(model.root(), 5.0);
    ASSERT_EQ(rejected.size(), 2);
    EXPECT_EQ(rejected[1][0].toString(), QString());
}

TEST_F(CaseModelTest, WhatNeedsTooMuchMemoryIsRejectedInWords) {
    const QString why = model.set("square", 1e300);
    EXPECT_TRUE(why.contains(QStringLiteral("memory"))) << why.toStdString();
    EXPECT_EQ(model.root(), 2.0);
    EXPECT_FALSE(model.history()->canUndo());
    EXPECT_THROW(model.loadInput({{"crank_radius_mm", 1e300}}, {}), InputError);
    EXPECT_EQ(model.root(), 2.0);
    EXPECT_EQ(model.set("square", 9.0), QString());
    EXPECT_EQ(model.root(), 3.0);
}

TEST_F(CaseModelTest, ChangesOfOneNameAreOneStepUntilTheDragEnds) {
    model.set("square", 9.0);
    model.set("square", 16.0);
    EXPECT_EQ(model.history()->count(), 1);
    model.finishDrag();
    model.set("square", 25.0);
    EXPECT_EQ(model.history()->count(), 2);
    model.set("another name", 36.0);
    model.set("square", 49.0);
    EXPECT_EQ(model.history()->count(), 4);
}

TEST_F(CaseModelTest, WhatIsNoDragIsAStepOfItsOwn) {
    model.set("square", 9.0);
    model.step("square", 16.0);
    model.step("square", 25.0);
    model.set("square", 36.0);
    EXPECT_EQ(model.history()->count(), 4);
    model.undo();
    model.set("square", 49.0);  // goes on with no step that was undone to
    EXPECT_EQ(model.history()->count(), 4);
}

TEST_F(CaseModelTest, AnEditingIsOneStep) {
    model.set("square", 9.0);
    model.history()->setClean();
    model.beginEditing();
    EXPECT_FALSE(model.isTyped());
    for (const double typed : {1.0, 16.0, 1.0, 16.0}) {
        model.step("square", typed);
    }
    EXPECT_EQ(model.root(), 4.0);
    EXPECT_TRUE(model.isTyped());
    EXPECT_TRUE(model.hasChanges());
    model.endEditing();
    EXPECT_FALSE(model.isTyped());
    EXPECT_EQ(model.history()->count(), 2);
    EXPECT_EQ(model.history()->undoText(), QStringLiteral("square"));
    EXPECT_EQ(solves(), 6);  // once for each value
    model.undo();
    EXPECT_EQ(model.root(), 3.0);
    model.redo();
    EXPECT_EQ(model.root(), 4.0);
}

TEST_F(CaseModelTest, AnEditingIsNoPartOfTheDragBeforeIt) {
    model.set("square", 9.0);
    model.beginEditing();
    model.step("square", 16.0);
    EXPECT_TRUE(model.takeBack());
    EXPECT_EQ(model.root(), 3.0);
    model.step("square", 25.0);
    model.keepForSaving();  // Escape returns to what was saved
    model.step("square", 36.0);
    EXPECT_TRUE(model.takeBack());
    EXPECT_EQ(model.root(), 5.0);
    model.endEditing();
    EXPECT_EQ(model.history()->count(), 2);
}

TEST_F(CaseModelTest, AnEditingThatComesBackByItselfIsNoStep) {
    model.beginEditing();
    model.step("square", 25.0);
    model.step("square", 4.0);
    EXPECT_FALSE(model.hasChanges());
    model.endEditing();
    EXPECT_EQ(model.history()->count(), 0);
}

TEST_F(CaseModelTest, WhatElseChangesInAnEditingIsAnotherStep) {
    model.beginEditing();
    model.step("square", 9.0);
    model.step("another name", 16.0);
    EXPECT_EQ(model.history()->count(), 2);
    EXPECT_FALSE(model.takeBack());
    model.step("square", 25.0);
    model.endEditing();
    EXPECT_EQ(model.history()->count(), 3);
    model.undo();
    model.undo();
    EXPECT_EQ(model.root(), 3.0);
}

TEST_F(CaseModelTest, UndoInAnEditingUndoesWhatWasTyped) {
    model.step("square", 9.0);
    model.beginEditing();
    model.step("square", 16.0);
    model.undo();
    EXPECT_EQ(model.root(), 3.0);
    model.endEditing();
    EXPECT_EQ(model.history()->index(), 1);
    EXPECT_EQ(model.history()->count(), 2);
}

TEST_F(CaseModelTest, WhatIsLoadedInAnEditingComesAfterIt) {
    model.beginEditing();
    model.step("square", 9.0);
    model.loadInput({{"crank_radius_mm", 16.0}}, {});
    EXPECT_EQ(model.history()->count(), 2);
    model.undo();
    EXPECT_EQ(model.root(), 3.0);
    model.endEditing();
    EXPECT_EQ(model.history()->count(), 2);
}

TEST_F(CaseModelTest, TheTitleGoesBackWithItsStep) {
    model.step("preset", 9.0, QStringLiteral("Nine"));
    EXPECT_EQ(model.title(), QStringLiteral("Nine"));
    model.loadCase({{"crank_radius_mm", 16.0}}, {"folder"}, QStringLiteral("Sixteen"));
    EXPECT_EQ(model.title(), QStringLiteral("Sixteen"));
    EXPECT_EQ(model.context().directory, "folder");
    model.undo();
    EXPECT_EQ(model.title(), QStringLiteral("Nine"));
    EXPECT_EQ(model.context().directory, ".");
    model.undo();
    EXPECT_EQ(model.title(), QStringLiteral("Root of four"));
    model.redo();
    model.redo();
    EXPECT_EQ(model.title(), QStringLiteral("Sixteen"));
}

TEST_F(CaseModelTest, LoadingIsOneStepOfItsOwn) {
    model.set("square", 9.0);
    solves();
    model.loadInput({{"crank_radius_mm", 16.0}}, {});
    EXPECT_EQ(solves(), 1);
    EXPECT_EQ(model.loads, 1);
    EXPECT_EQ(model.history()->count(), 2);
    model.loadInput({{"crank_radius_mm", 25.0}}, {});
    EXPECT_EQ(model.history()->count(), 3);
    model.set("square", 36.0);
    EXPECT_EQ(model.history()->count(), 4);
    model.history()->undo();
    model.history()->undo();
    EXPECT_EQ(model.root(), 4.0);
}

TEST_F(CaseModelTest, WhatCannotBeLoadedChangesNothing) {
    model.set("square", 9.0);
    for (const Json& bad : {Json{{"crank_radius_mm", -1.0}}, Json{{"radius", 1.0}}}) {
        EXPECT_THROW(model.loadInput(bad, {}), InputError);
        EXPECT_EQ(model.root(), 3.0);
        EXPECT_EQ(model.loads, 0);
        EXPECT_EQ(model.history()->count(), 1);
    }
}

TEST_F(CaseModelTest, LoadingWhatIsThereIsNoStepButIsReported) {
    model.loadCase(model.inputJson(), model.context(), model.title());
    EXPECT_EQ(model.loads, 1);
    EXPECT_EQ(changes.size(), 1);
    EXPECT_TRUE(model.history()->isClean());
    EXPECT_FALSE(model.history()->canUndo());
}

/// Whatever painting left in the vector registers, no way into the scene computes with it.
TEST_F(CaseModelTest, SolvesWithClearVectorRegisters) {
    const auto dirtied = [](const auto& change) {
        test::dirty_vector_registers();
        change();
    };
    dirtied([&] { model.set("square", 9.0); });
    dirtied([&] { model.history()->undo(); });
    dirtied([&] { model.history()->redo(); });
    dirtied([&] { model.loadInput({{"crank_radius_mm", 16.0}}, {}); });
    dirtied([&] { model.restart({25.0}); });
    dirtied([&] { model.setByKey(QStringLiteral("crank_radius_mm"), QStringLiteral("36")); });
    dirtied([&] { test::RootModel{scene}; });
    EXPECT_EQ(solves(), 8);
    EXPECT_EQ(*scene.dirty, 0);
}

TEST_F(CaseModelTest, ThePresetsNameGoesWithItsEngine) {
    const QString fresh = model.title();
    model.set("square", 9.0);
    EXPECT_EQ(model.title(), QStringLiteral("Root of four (changed)"));
    // The mark is no word of a language: the title of a file says it in the one there is now.
    EXPECT_EQ(SceneModel::titleText(model.title()), SceneModel::tr("%1 (changed)").arg(fresh));
    model.set("square", 4.0);  // the hand comes back
    EXPECT_EQ(model.title(), fresh);
    EXPECT_TRUE(model.history()->isClean());
    model.step("preset", 9.0, QStringLiteral("Nine"));
    model.step("square", 16.0);
    EXPECT_EQ(model.title(), QStringLiteral("Nine (changed)"));
    model.loadInput({{"crank_radius_mm", 9.0}}, {});
    EXPECT_EQ(model.title(), QStringLiteral("Nine"));
    model.undo();
    EXPECT_EQ(model.title(), QStringLiteral("Nine (changed)"));
    model.undo();
    EXPECT_EQ(model.title(), QStringLiteral("Nine"));
    model.beginEditing();
    model.step("square", 25.0);
    EXPECT_EQ(model.title(), QStringLiteral("Nine (changed)"));
    model.step("square", 9.0);
    EXPECT_EQ(model.title(), QStringLiteral("Nine"));
    model.endEditing();
    EXPECT_EQ(model.history()->index(), 1);
}

TEST_F(CaseModelTest, TheUsersTitleStaysWhateverChanges) {
    model.editText(QStringLiteral("Mine"), {});
    model.set("square", 9.0);
    EXPECT_EQ(model.title(), QStringLiteral("Mine"));
    model.loadCase({{"crank_radius_mm", 16.0}}, {}, QStringLiteral("Of a file"));
    model.set("square", 25.0);
    EXPECT_EQ(model.title(), QStringLiteral("Of a file"));
    CaseFile file{"balance-shaft", "An example", {{"crank_radius_mm", 16.0}}};
    model.loadFile(file, {}, true);
    model.set("square", 25.0);
    EXPECT_EQ(model.title(), QStringLiteral("An example (changed)"));
}

TEST_F(CaseModelTest, TitleAndNotesAreOneStepThatSolvesNothing) {
    model.editText(QStringLiteral("Mine"), QStringLiteral("Two\nlines"));
    EXPECT_EQ(model.title(), QStringLiteral("Mine"));
    EXPECT_EQ(model.notes(), QStringLiteral("Two\nlines"));
    EXPECT_EQ(model.history()->count(), 1);
    EXPECT_TRUE(model.hasChanges());
    EXPECT_EQ(model.caseFile().notes, "Two\nlines");
    model.editText(QStringLiteral("Mine"), QStringLiteral("Two\nlines"));
    EXPECT_EQ(model.history()->count(), 1);
    model.undo();
    EXPECT_EQ(model.title(), QStringLiteral("Root of four"));
    EXPECT_EQ(model.notes(), QString());
    model.redo();
    EXPECT_EQ(model.notes(), QStringLiteral("Two\nlines"));
    model.set("square", 9.0);
    EXPECT_EQ(model.notes(), QStringLiteral("Two\nlines"));
}

}  // namespace
}  // namespace ravnoves
