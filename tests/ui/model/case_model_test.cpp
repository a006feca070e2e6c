// What CaseModel does for every scene: change, refuse, merge, undo, load.

#include <gtest/gtest.h>

#include <QSignalSpy>

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

TEST_F(CaseModelTest, BeginsWithTheDefault) {
    EXPECT_EQ(solves(), 1);
    EXPECT_EQ(model.root(), 2.0);
    EXPECT_EQ(model.title(), QStringLiteral("Root of four"));
    EXPECT_TRUE(model.history()->isClean());
    EXPECT_FALSE(model.history()->canUndo());
}

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

TEST_F(CaseModelTest, WhatIsRefusedChangesNothingAndSaysWhy) {
    QSignalSpy refused(&model, &SceneModel::refused);
    const QString why = model.set("square", -1.0);
    EXPECT_TRUE(why.contains(QStringLiteral("negative"))) << why.toStdString();
    ASSERT_EQ(refused.size(), 1);
    EXPECT_EQ(refused[0][0].toString(), why);
    EXPECT_EQ(model.input().square, 4.0);
    EXPECT_EQ(model.root(), 2.0);
    EXPECT_EQ(changes.size(), 0);
    EXPECT_FALSE(model.history()->canUndo());
    // What comes next is not taken for what was refused.
    EXPECT_EQ(model.set("square", 16.0), QString());
    EXPECT_EQ(model.root(), 4.0);
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

TEST_F(CaseModelTest, UndoAndRedoSolveAnew) {
    model.set("square", 9.0);
    model.set("square", 16.0);
    solves();
    changes.clear();
    model.history()->undo();
    EXPECT_EQ(model.root(), 2.0);
    EXPECT_TRUE(model.history()->isClean());
    model.history()->redo();
    EXPECT_EQ(model.root(), 4.0);
    EXPECT_EQ(solves(), 2);
    EXPECT_EQ(changes.size(), 2);
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

TEST_F(CaseModelTest, LoadingWhatIsThereIsNoStepButIsTold) {
    model.loadDefault();
    EXPECT_EQ(model.loads, 1);
    EXPECT_EQ(changes.size(), 1);
    EXPECT_TRUE(model.history()->isClean());
    EXPECT_FALSE(model.history()->canUndo());
}

TEST_F(CaseModelTest, TheDefaultComesBackWithItsTitle) {
    model.set("square", 9.0);
    model.setTitle(QStringLiteral("Nine"));
    model.loadDefault();
    EXPECT_EQ(model.input(), test::RootScene::Input{});
    EXPECT_EQ(model.title(), QStringLiteral("Root of four"));
    model.history()->undo();
    EXPECT_EQ(model.root(), 3.0);
}

TEST_F(CaseModelTest, AnotherDocumentBeginsAHistoryOfItsOwn) {
    model.set("square", 9.0);
    model.restart({16.0});
    EXPECT_EQ(model.root(), 4.0);
    EXPECT_TRUE(model.history()->isClean());
    EXPECT_FALSE(model.history()->canUndo());
    model.set("square", 25.0);
    model.history()->undo();
    EXPECT_EQ(model.root(), 4.0);
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
    dirtied([&] { model.solveAgain(); });
    dirtied([&] { test::RootModel{scene}; });
    EXPECT_EQ(solves(), 9);
    EXPECT_EQ(*scene.dirty, 0);
}

TEST_F(CaseModelTest, ValuesAreSetByTheirKeys) {
    model.setByKey(QStringLiteral("crank_radius_mm"), QStringLiteral("9"));
    EXPECT_EQ(model.root(), 3.0);
    EXPECT_THROW(model.setByKey(QStringLiteral("crank_radius_mm"), QStringLiteral("nine")),
                 InputError);
    EXPECT_THROW(model.setByKey(QStringLiteral("radius"), QStringLiteral("9")), InputError);
    EXPECT_EQ(model.root(), 3.0);
}

}  // namespace
}  // namespace ravnoves
