// What pictures of mechanisms and forms share.

#include <gtest/gtest.h>

#include <QAccessible>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <limits>

#include "events.h"
#include "page/mechanism_picture.h"
#include "widgets/drawing.h"
#include "widgets/form_section.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class Framed final : public MechanismPicture {
  public:
    explicit Framed(CrankAngle* crank) : MechanismPicture(crank, u"Picture"_s, {}) {}

    bool showsPlaying = false;  ///< in the picture as it was painted last

  protected:
    void paintPicture(QPainter& painter) override {
        painter.fillRect(rect(), Qt::white);
        showsPlaying = isPlaying();
    }
};

TEST(CrankAngle, GoesRoundAndRestsAtTheEndOfItsCycle) {
    CrankAngle crank(40.0, 720.0);
    crank.turnTo(-30.0);
    EXPECT_EQ(crank.degrees(), 690.0);
    crank.turnTo(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(crank.degrees(), 690.0);
    crank.turnTo(720.0);  // where its slider ends
    EXPECT_EQ(crank.degrees(), 720.0);
    crank.turnTo(721.0);
    EXPECT_EQ(crank.degrees(), 1.0);
    crank.turnTo(400.0);
    crank.setCycle(360.0);
    EXPECT_EQ(crank.degrees(), 40.0);
}

TEST(MechanismPicture, APauseIsSeenAtOnce) {
    CrankAngle crank(0.0, 360.0);
    Framed picture(&crank);
    test::showAt(picture, {200, 100});
    for (const bool playing : {true, false, true, false}) {
        QApplication::processEvents();
        picture.setPlaying(playing);
        QApplication::processEvents();
        EXPECT_EQ(picture.showsPlaying, playing);
    }
}

TEST(Drawing, AnArrowThatWouldLeaveThePictureGoesBackAlongItsLine) {
    const QRectF picture(0.0, 0.0, 100.0, 60.0);
    const QLineF inside(10.0, 10.0, 60.0, 30.0);
    EXPECT_EQ(drawing::pulledInside(inside, picture), inside);
    for (const QLineF& arrow : {QLineF(50.0, 30.0, 140.0, 30.0), QLineF(50.0, 30.0, 50.0, -40.0),
                                QLineF(60.0, 40.0, 120.0, 100.0), QLineF(5.0, 5.0, -20.0, -7.0)}) {
        const QLineF moved = drawing::pulledInside(arrow, picture);
        EXPECT_TRUE(picture.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(moved.p2()));
        EXPECT_NEAR(moved.dx(), arrow.dx(), 1e-9);
        EXPECT_NEAR(moved.dy(), arrow.dy(), 1e-9);
        // On the same line.
        const QPointF d = moved.p2() - arrow.p2();
        EXPECT_NEAR(d.x() * arrow.dy() - d.y() * arrow.dx(), 0.0, 1e-6);
    }
}

int namesReported = 0;

TEST(ScrolledForm, TellsItsNameWhenItChangesAndNotAtEverySize) {
    auto* label = new QLabel(u"Title"_s);
    QWidget parent;
    QScrollArea* area = scrolled(label, &parent);
    QAccessible::setActive(true);
    const auto before = QAccessible::installUpdateHandler([](QAccessibleEvent* event) {
        namesReported += event->type() == QAccessible::NameChanged ? 1 : 0;
    });
    test::showAt(parent, {300, 200});
    for (int width = 200; width < 260; width += 10) {
        area->resize(width, 100);
        QApplication::processEvents();
    }
    EXPECT_EQ(area->accessibleName(), u"Title"_s);
    EXPECT_LE(namesReported, 1);
    QAccessible::installUpdateHandler(before);
    QAccessible::setActive(false);
}

}  // namespace
}  // namespace ravnoves
