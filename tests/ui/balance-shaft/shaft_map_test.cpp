#include <gtest/gtest.h>

#include <QLabel>
#include <QPainterPath>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <cmath>
#include <random>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/shaft_map_plot.h"
#include "balance-shaft/shaft_tabs.h"
#include "model/background_job.h"
#include "model/reference_case.h"
#include "numerics/constants.h"
#include "page_fixture.h"
#include "pictures/model/stroke.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {
namespace {

using balance_shaft::Obstacle;
using balance_shaft::PositionStudy;
using Position = ShaftMapModel::Position;
using Criterion = ShaftMapModel::Criterion;

constexpr double mm = 1e-3;

class ShaftMapTest : public test::PageTest<BalanceShaftPage> {
  protected:
    ShaftMapTest() {
        // A shaft small enough to have a choice of places.
        change([](balance_shaft::Input& input) { input.envelope.shaft_swing_radius = 12 * mm; });
        model->history()->clear();
        test::showAt(page, {1280, 800});
        bring(view);
        wait();
        plot->setFocus();
    }

    void change(const std::function<void(balance_shaft::Input&)>& mutate) {
        model->edit(QStringLiteral("Change"), mutate);
    }
    void wait() {
        QTRY_VERIFY_WITH_TIMEOUT(!map->job()->isRunning(), 30000);
        QApplication::processEvents();
    }
    void move(const QPointF& to, Qt::MouseButtons buttons = Qt::LeftButton) {
        test::movePointer(plot, to, buttons);
    }
    QPointF handle() const { return plot->pixelOf(map->present()); }
    double length() const { return model->input().centre_distance; }
    double angle() const { return model->input().shaft_angle; }
    QString words() { return find<QLabel>("shaft_map_words")->text(); }
    bool says(const char* text) { return words().contains(QString::fromUtf8(text)); }
    ShaftMapModel* map = model->shaftMap();
    QWidget* view = find<QWidget>("map");
    ShaftMapPlot* plot = page.findChild<ShaftMapPlot*>();
    PartPlot* sizes = partPlot(page, "front");
    QPushButton* best = find<QPushButton>("go_best_place");
};

TEST_F(ShaftMapTest, ShowsTheNumbersOfTheStudy) {
    ASSERT_NE(map->map(), nullptr);
    const PositionStudy study(model->solver());
    const balance_shaft::PositionMap& field = map->map()->field;
    ASSERT_EQ(map->field().changes.size(), field.columns * field.rows);
    const auto place = [&](std::size_t element) {
        const auto along = [](double from, double to, std::size_t i, std::size_t count) {
            return from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
        };
        return Position{along(field.left, field.right, element % field.columns, field.columns),
                        along(field.bottom, field.top, element / field.columns, field.rows)};
    };
    for (const Criterion criterion : {Criterion::range, Criterion::rms}) {
        model->setCriterion(criterion);
        for (std::size_t i = 0; i < map->field().changes.size(); i += 977) {
            const auto at = study.at(place(i));
            EXPECT_NEAR(map->field().changes[i],
                        map->byRange() ? at.range / study.range_without() - 1.0
                                       : at.rms / study.rms_without() - 1.0,
                        1e-9);
        }
    }
    // The lines are where the field has their levels; 0 is among them.
    const auto& levels = map->field().levels;
    EXPECT_EQ(std::count(levels.begin(), levels.end(), 0.0), 1);
    EXPECT_TRUE(std::is_sorted(levels.begin(), levels.end()));
    for (const ChangeContours::Contour& contour : map->field().contours) {
        for (const QPolygonF& line : contour.lines) {
            for (qsizetype i = 0; i < line.size(); i += 37) {
                EXPECT_NEAR(*map->change(study.at({line[i].x() * mm, line[i].y() * mm})),
                            contour.level, 0.004);
            }
        }
    }
}

TEST_F(ShaftMapTest, ADragMovesTheAxisInOneStep) {
    const ShaftMap* before = map->map();
    const double l = length();
    const double alpha = angle();
    const QPoint from = handle().toPoint();
    const QPointF away(-37.0, 21.0);
    const Position there = plot->placeAt(handle() + away);
    QSignalSpy computed(map, &ShaftMapModel::mapChanged);
    QTest::mousePress(plot, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 20; ++step) {
        move(from + away * step / 20.0);
        EXPECT_FALSE(map->job()->isRunning());
    }
    const double step = 0.75 * mm;  // half of 0.5 mm along and of 0.5° across
    EXPECT_NEAR(map->present().x, there.x, step);
    EXPECT_NEAR(map->present().y, there.y, step);
    EXPECT_DOUBLE_EQ(2.0 * length() / mm, std::round(2.0 * length() / mm));
    EXPECT_DOUBLE_EQ(2.0 * model->shaftAngleDeg(), std::round(2.0 * model->shaftAngleDeg()));
    EXPECT_EQ(model->history()->count(), 1);  // however far it goes
    EXPECT_EQ(words(), map->placeText(map->present()));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, (from + away).toPoint());
    EXPECT_EQ(model->history()->count(), 1);
    // All follows: the sliders, the moments, the field of the form.
    EXPECT_NEAR(*field("place_distance_mm")->value(), length() / mm, 1e-9);
    EXPECT_NEAR(*field("shaft_angle_deg")->value(), model->shaftAngleDeg(), 1e-9);
    const auto& result = model->result();
    EXPECT_NEAR(result.M_ups.range, map->map()->study.at(map->present()).range, 1e-6);
    EXPECT_NEAR(*field("centre_distance_mm")->value(), length() / mm, 1e-9);
    // The map is the one that was there.
    QApplication::processEvents();
    EXPECT_EQ(map->map(), before);
    EXPECT_EQ(computed.count(), 0);
    model->undo();
    EXPECT_EQ(length(), l);
    EXPECT_EQ(angle(), alpha);
    model->redo();
    EXPECT_NEAR(map->present().x, there.x, step);
}

TEST_F(ShaftMapTest, EscapeBringsTheAxisBackAndLeavesNoStep) {
    model->setShaftAngleDeg(70.0);
    model->finishDrag();
    const double l = length();
    const double alpha = angle();
    QTest::mousePress(plot, Qt::LeftButton, {}, handle().toPoint());
    move(handle() + QPointF(40.0, 40.0));
    EXPECT_NE(length(), l);
    QTest::keyClick(plot, Qt::Key_Escape);
    EXPECT_EQ(length(), l);
    EXPECT_EQ(angle(), alpha);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, handle().toPoint() + QPoint(40, 40));
    EXPECT_EQ(length(), l);
    EXPECT_EQ(model->history()->index(), 1);
    EXPECT_EQ(model->history()->count(), 1);
    model->undo();
    EXPECT_NE(angle(), alpha);
}

TEST_F(ShaftMapTest, GoesToMarkersAndPlaces) {
    ASSERT_FALSE(map->markers().empty());
    const ShaftMapModel::Marker marker = map->markers().front();
    QTest::mouseDClick(plot, Qt::LeftButton, {}, plot->pixelOf(marker.position).toPoint());
    EXPECT_NEAR(map->present().x, marker.position.x, 1e-12);
    EXPECT_NEAR(model->result().M_ups.range, marker.criteria.range, 1e-6);
    EXPECT_EQ(model->history()->count(), 1);
    const QPoint free = plot->pixelOf({-60 * mm, -90 * mm}).toPoint();
    QTest::mouseDClick(plot, Qt::LeftButton, {}, free);
    EXPECT_NEAR(map->present().x, -60 * mm, 1.0 * mm);
    EXPECT_NEAR(map->present().y, -90 * mm, 1.0 * mm);
    EXPECT_EQ(model->history()->count(), 2);
    // By keys they are read, as the points of any plot.
    QTest::keyClick(plot, Qt::Key_Right);
    ASSERT_TRUE(plot->data().pointRead);
    EXPECT_EQ(plot->data().curve(0).text(0).section(QLatin1Char('\n'), 0, 0),
              map->placeLines(marker.position).front());
}

TEST_F(ShaftMapTest, HatchesWhatCannotBeBuiltAndSaysWhy) {
    const ShaftMap& all = *map->map();
    QPainterPath hatched;
    for (const QPolygonF& line : all.blocked) {
        hatched.addPolygon(line);
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> within(-all.view, all.view);
    int blocked = 0;
    int wrong = 0;
    for (int i = 0; i < 500; ++i) {
        const Position place{within(random), within(random)};
        const bool is = all.study.obstacle(place) != Obstacle::none;
        blocked += is ? 1 : 0;
        wrong += hatched.contains(QPointF(place.x, place.y)) != is ? 1 : 0;
        EXPECT_EQ(map->reasonAt(place).isEmpty(), !is);
    }
    EXPECT_GT(blocked, 50);
    EXPECT_LT(blocked, 450);
    EXPECT_LE(wrong, 2);  // at the very edge
    // Under the pointer it says why, and what the place would give.
    move(plot->pixelOf({0.0, 20 * mm}), Qt::NoButton);
    const QString over = words();
    EXPECT_TRUE(over.contains(QStringLiteral("20.0\u00A0mm"))) << over.toStdString();
    EXPECT_TRUE(over.contains(QStringLiteral("N·m"))) << over.toStdString();
    EXPECT_TRUE(over.contains(map->reasonAt({0.0, 20 * mm}))) << over.toStdString();
    EXPECT_FALSE(map->reasonAt({0.0, 20 * mm}).isEmpty());
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(plot, &leave);
    EXPECT_EQ(words(), map->answer());
}

/// However far the area reaches, as that of a map does that is zoomed into.
TEST(Hatch, HasNoMoreLinesThanAreSeen) {
    QPainterPath area;
    area.addRect(QRectF(-1e7, -1e7, 2e7, 2e7));
    EXPECT_NEAR(static_cast<double>(hatchLines(area, QRectF(0, 0, 100, 50), 1.0, 1.0).size()),
                150.0, 2.0);
}

TEST_F(ShaftMapTest, AnotherInputMakesANewMapAndPalesTheOldOne) {
    const ShaftMap* before = map->map();
    change([](balance_shaft::Input& input) { input.angular_speed *= 0.8; });
    EXPECT_TRUE(map->isStale());
    EXPECT_TRUE(plot->isFaded());
    EXPECT_EQ(map->map(), before);  // still shown
    wait();
    EXPECT_FALSE(plot->isFaded());
    EXPECT_NE(map->map(), before);
    // A tab that nobody sees computes nothing.
    page.findChild<ShaftTabs*>()->setCurrentIndex(0);
    change([](balance_shaft::Input& input) { input.angular_speed *= 0.8; });
    EXPECT_FALSE(map->job()->isRunning());
    showTabOf(view);
    EXPECT_TRUE(map->job()->isRunning());
    wait();
    // A shaft outside of the picture makes a larger one.
    const double seen = map->map()->view;
    change([&](balance_shaft::Input& input) { input.centre_distance = 1.5 * seen; });
    wait();
    EXPECT_GT(map->map()->view, 1.5 * seen);
    EXPECT_NEAR(*field("place_distance_mm")->value(), 1.5 * seen / mm, 0.01);
}

TEST_F(ShaftMapTest, AgainstAReferenceItShowsItsBestPlacesToo) {
    model->keepVariant(QStringLiteral("old"));
    change([](balance_shaft::Input& input) { input.crank_radius *= 1.2; });
    wait();
    ASSERT_TRUE(test::comes([&] { return plot->data().hasGhosts(); }));
    const auto* other = static_cast<const BalanceShaftModel*>(model->referenceCase().model());
    ASSERT_NE(other, nullptr);
    EXPECT_NE(other->shaftMap()->best()->criteria.range, map->best()->criteria.range);
    model->setCriterion(Criterion::rms);
    EXPECT_EQ(other->criterion(), Criterion::rms);
    model->chooseReference(-1);
    EXPECT_FALSE(plot->data().hasGhosts());
}

TEST_F(ShaftMapTest, ASecondSliderSetsTheDistance) {
    const double alpha = angle();
    QSlider* slider = find<QSlider>("place_distance_mm_slider");
    slider->setFocus();
    const double before = length();
    QTest::keyClick(slider, Qt::Key_Right);
    EXPECT_NEAR(length(), before + 0.1 * mm, 0.051 * mm);
    QTest::keyClick(slider, Qt::Key_PageUp);
    EXPECT_GT(length(), before + 9 * mm);
    EXPECT_EQ(angle(), alpha);
    QTest::keyClick(slider, Qt::Key_Home);
    EXPECT_EQ(length(), 0.0);
    EXPECT_EQ(angle(), alpha);
    EXPECT_NEAR(model->result().M_ups.range, map->map()->study.range_without(), 1e-6);
    model->undo();
    EXPECT_EQ(length(), before);
}

TEST_F(ShaftMapTest, AClickInTheChartGoesToItsPlace) {
    view->findChild<QTabWidget*>()->setCurrentWidget(sizes);
    QApplication::processEvents();
    const auto& front = map->map()->front;
    ASSERT_GT(front.size(), 3U);
    const balance_shaft::BestPosition& place = front[front.size() / 2];
    QTest::mouseClick(
        sizes, Qt::LeftButton, {},
        sizes->toPixel(place.criteria.size / 1e-4, 100.0 * *map->change(place.criteria)).toPoint());
    EXPECT_NEAR(*map->change(map->map()->study.at(map->present())), *map->change(place.criteria),
                0.02);
    EXPECT_TRUE(model->result().is_buildable);
    EXPECT_EQ(model->history()->count(), 1);
}

// As parts of one, they are rounded once.
TEST(ShaftMapText, APercentageReadsTheSameWhereverItIs) {
    for (int i = 1; i < 2000; ++i) {
        const double value = 1.0 + (i + 0.5) * 1e-3;
        const QString text = messageText(balance_shaft::trade_off({1.0, 1.0}, {value, 1.0}));
        const QString percent = percentText(balance_shaft::relative_change(1.0, value));
        EXPECT_EQ(text, QStringLiteral("range %1 larger, RMS unchanged").arg(percent));
    }
}

TEST_F(ShaftMapTest, ResultsFoldByTheWidthAloneNotByTheOneBefore) {
    const auto* columns = page.findChild<PageColumns*>();
    const auto foldedAt = [&](int width) {
        page.resize(width, 800);
        QApplication::processEvents();
        return columns->isFolded();
    };
    for (int width = 1100; width <= 1300; width += 25) {
        foldedAt(1600);
        const bool isFolded = foldedAt(width);
        for (const int before : {900, 1100, 1400}) {
            foldedAt(900);
            foldedAt(before);
            EXPECT_EQ(foldedAt(width), isFolded) << before << " to " << width;
        }
    }
}

TEST_F(ShaftMapTest, LimitsAreHatchedAndSaid) {
    view->findChild<QTabWidget*>()->setCurrentIndex(1);
    QApplication::processEvents();
    type("left_mm", QStringLiteral("80"));
    EXPECT_NEAR(*model->input().place_limits.left, 80 * mm, 1e-12);
    wait();
    const Position beyond{75 * mm, -80 * mm};
    EXPECT_EQ(map->map()->study.obstacle(beyond), Obstacle::limits);
    EXPECT_FALSE(map->reasonAt(beyond).isEmpty());
    for (const Criterion criterion : {Criterion::range, Criterion::rms}) {
        model->setCriterion(criterion);
        ASSERT_NE(map->best(), nullptr);
        EXPECT_TRUE(map->best()->isBuildable);
        EXPECT_GE(map->best()->position.x, 80 * mm - 1e-9);
    }
    model->undo();
    EXPECT_FALSE(model->input().place_limits.left);
}

/// Whole hundredths of a unit.
bool isShort(double value) {
    return std::abs(100.0 * value - std::round(100.0 * value)) < 1e-6;
}

TEST_F(ShaftMapTest, PlacesGoneToAreShortNumbersThatCanBeBuilt) {
    const ShaftMap& all = *map->map();
    const auto expectShort = [&](const Position& exact, double part) {
        EXPECT_TRUE(isShort(length() / mm)) << length() / mm;
        EXPECT_TRUE(isShort(angle() / degree)) << angle() / degree;
        EXPECT_TRUE(model->result().is_buildable);
        EXPECT_EQ(all.study.obstacle(map->present()), Obstacle::none);
        EXPECT_NEAR(map->present().x, exact.x, 0.15 * mm);
        EXPECT_NEAR(map->present().y, exact.y, 0.15 * mm);
        EXPECT_LT(*map->change(all.study.at(map->present())),
                  *map->change(all.study.at(exact)) + part);
    };
    for (const Criterion criterion : {Criterion::range, Criterion::rms}) {
        model->setCriterion(criterion);
        const auto& best = criterion == Criterion::range ? all.smallRange : all.smallRms;
        ASSERT_TRUE(best);
        map->goToBest();
        expectShort(best->position, 1e-3);
        EXPECT_TRUE(map->isAtBest());
        // The words say what the fields of the form show, and all of it.
        const QString l = QLocale().toString(length() / mm, 'f', 2);
        const QString alpha = QLocale().toString(angle() / degree, 'f', 2);
        EXPECT_TRUE(words().contains(QStringLiteral("l %1\u00A0mm, α %2°").arg(l, alpha)))
            << words().toStdString();
        EXPECT_NEAR(*field("centre_distance_mm")->value(), l.toDouble(), 1e-12);
    }
    model->setCriterion(Criterion::range);
    for (const balance_shaft::BestPosition& place : all.front) {
        map->moveTo(map->shortened(place.position, Criterion::range));
        expectShort(place.position, 2e-3);
    }
}

TEST_F(ShaftMapTest, TheBestPlaceIsTheSmallestWithinAHundredth) {
    const ShaftMap& all = *map->map();
    for (const int criterion : {0, 1}) {
        choose("map_criterion", criterion);
        const auto& exact = criterion == 0 ? all.buildable.range : all.buildable.rms;
        ASSERT_TRUE(exact);
        map->goTo(Position::at(length() + 30.0 * mm, angle()));
        ASSERT_TRUE(best->isEnabled());
        EXPECT_TRUE(best->toolTip().contains(QStringLiteral("From here: range ")))
            << best->toolTip().toStdString();
        EXPECT_TRUE(best->toolTip().contains(QStringLiteral(", box ")));
        best->click();
        EXPECT_NEAR(map->present().x, map->best()->position.x, 1e-12);
        EXPECT_LE(1.0 + *map->change(all.study.at(map->present())),
                  1.0101 * (1.0 + *map->change(exact->criteria)));
        EXPECT_LE(all.study.at(map->present()).size, 1.001 * exact->criteria.size);
        EXPECT_TRUE(model->result().is_buildable);
        EXPECT_FALSE(best->isEnabled());
        EXPECT_TRUE(best->toolTip().contains(QStringLiteral("Already there")))
            << best->toolTip().toStdString();
    }
    EXPECT_TRUE(says("with the RMS within 1 %")) << words().toStdString();
}

TEST_F(ShaftMapTest, SaysWhatTheBestPlaceChangesFromWhereTheShaftIsNow) {
    best->click();
    ASSERT_TRUE(says("Already there")) << words().toStdString();
    view->hide();  // another tab
    change([](balance_shaft::Input& input) { input.shaft_angle += 0.5; });
    view->show();
    wait();
    EXPECT_TRUE(says("From here: ")) << words().toStdString();
}

TEST_F(ShaftMapTest, AMoveAfterEscapeWaitsForTheHandToLetGo) {
    const QPointF from = handle();
    QTest::mousePress(plot, Qt::LeftButton, {}, from.toPoint());
    move(from + QPointF(40.0, 40.0));
    QTest::keyClick(plot, Qt::Key_Escape);
    const QString here = map->placeText(map->present());
    EXPECT_EQ(words(), here);
    QSignalSpy cursor(plot, &PlotView::cursorMoved);
    move(from + QPointF(60.0, 20.0));
    move(from + QPointF(80.0, -20.0));
    EXPECT_EQ(cursor.count(), 0);  // no read-out, no dotted line
    EXPECT_EQ(words(), here);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, (from + QPointF(80.0, -20.0)).toPoint());
    move(from + QPointF(90.0, -30.0), Qt::NoButton);
    EXPECT_NE(words(), here);
    EXPECT_EQ(model->history()->count(), 0);
}

TEST_F(ShaftMapTest, WhatIsShownRestsDuringADragAndFollowsAfterIt) {
    const ShaftMap* before = map->map();
    const double view = before->view;
    const QPointF from = handle();
    QTest::mousePress(plot, Qt::LeftButton, {}, from.toPoint());
    const QPointF corner = plot->plotArea().topRight() + QPointF(300.0, -300.0);
    for (int step = 1; step <= 5; ++step) {
        move(from + (corner - from) * step / 5.0);
        QApplication::processEvents();
        EXPECT_EQ(map->map(), before);
    }
    const double reached = length();
    EXPECT_GT(reached, view);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, corner.toPoint());
    EXPECT_TRUE(test::comes([&] { return map->map() != before && !map->isStale(); }));
    EXPECT_EQ(length(), reached);
    EXPECT_GT(map->map()->view, reached);
    // Back where it was, so is what is shown.
    model->undo();
    EXPECT_TRUE(test::comes([&] { return map->map()->view == view; }));
}

TEST_F(ShaftMapTest, ASmallerMapFillsThePanelThoughTheLargerOneWasZoomed) {
    map->goTo(Position::at(4.0 * map->map()->view, angle()));
    wait();
    plot->grab();
    QTest::keyClick(plot, Qt::Key_Plus);
    QTest::keyClick(plot, Qt::Key_Plus);
    ASSERT_TRUE(plot->isZoomed());
    best->click();
    wait();
    plot->grab();
    const QSizeF filled = plot->plotArea().size();
    plot->resetZoom();
    plot->grab();
    EXPECT_EQ(filled, plot->plotArea().size());
    // Another one of the same size stays zoomed.
    QTest::keyClick(plot, Qt::Key_Plus);
    model->setCriterion(Criterion::rms);
    EXPECT_TRUE(plot->isZoomed());
}

TEST_F(ShaftMapTest, SaysThatTheBestPlaceIsWorseThanNone) {
    const QString worse = QStringLiteral("Worse than without a shaft");
    EXPECT_FALSE(map->answer().contains(worse));
    // So far away that every place adds more than it takes.
    change([](balance_shaft::Input& input) { input.place_limits.centre_distance_min = 400 * mm; });
    wait();
    ASSERT_NE(map->best(), nullptr);
    ASSERT_TRUE(map->best()->isBuildable);
    EXPECT_GT(*map->change(map->best()->criteria), 0.0);
    EXPECT_TRUE(map->answer().contains(worse)) << map->answer().toStdString();
    EXPECT_TRUE(best->isEnabled());
}

TEST_F(ShaftMapTest, WhereNothingCanBeBuiltTheButtonSaysWhy) {
    EXPECT_FALSE(sizes->isFaded());
    change([](balance_shaft::Input& input) { input.place_limits.centre_distance_max = 30 * mm; });
    wait();
    const QString none = QStringLiteral("No place within the limits");
    EXPECT_FALSE(best->isEnabled());
    EXPECT_TRUE(best->toolTip().contains(none)) << best->toolTip().toStdString();
    EXPECT_TRUE(words().startsWith(none)) << words().toStdString();
    EXPECT_TRUE(says("does not fit"));
    EXPECT_FALSE(says("Best place")) << "of limits that exclude every place";
    EXPECT_TRUE(sizes->isFaded());  // it says so in its middle
    EXPECT_FALSE(model->result().is_buildable);
    EXPECT_TRUE(model->result().buildable.stretches.empty());
    model->undo();
    wait();
    EXPECT_TRUE(best->isEnabled());
    EXPECT_FALSE(sizes->isFaded());
}

TEST_F(ShaftMapTest, CurvesThatAreReadOutHaveNames) {
    for (int i = 0; i < std::ssize(sizes->data().curves); ++i) {
        EXPECT_FALSE(sizes->data().curve(i).style.name.isEmpty()) << i;
    }
}

TEST_F(ShaftMapTest, TheFieldIsACsv) {
    const QStringList lines = plot->dataAsCsv().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    ASSERT_GT(lines.size(), 20'000);
    const QStringList row = lines[1234].split(QLatin1Char(','));
    ASSERT_EQ(row.size(), 5);
    const Position place{row[0].toDouble() * mm, row[1].toDouble() * mm};
    EXPECT_NEAR(row[2].toDouble(), map->map()->study.at(place).range, 1e-6);
    EXPECT_NEAR(row[3].toDouble(), map->map()->study.at(place).rms, 1e-6);
    EXPECT_EQ(row[4].toInt(), map->isBuildable(place) ? 1 : 0);
}

TEST_F(ShaftMapTest, ATorqueWithoutARangeSaysSo) {
    change([](balance_shaft::Input& input) {
        input.torque.table = {{0, 180, 360, 540, 720}, {0, 0, 0, 0, 0}};
    });
    wait();
    EXPECT_TRUE(map->field().levels.empty());
    EXPECT_FALSE(words().isEmpty());
    EXPECT_FALSE(page.grab().isNull());
}

}  // namespace
}  // namespace ravnoves
