#include "balance-shaft/model/spread_places.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ravnoves {
namespace {

const QRectF all(0.0, 0.0, 1000.0, 1000.0);

double distanceOf(const QPointF& one, const QPointF& other) {
    return std::hypot(one.x() - other.x(), one.y() - other.y());
}

TEST(SpreadPlaces, TwoGoApartAboutTheirMiddle) {
    const QPointF middle(500.0, 400.0);
    for (const QPointF& half : {QPointF(3.0, 0.0), QPointF(-1.0, 2.0), QPointF(0.0, 0.0)}) {
        const auto places = spreadApart({middle - half, middle + half}, 15.0, all);
        EXPECT_NEAR(distanceOf(places[0], places[1]), 15.0, 1e-9);
        EXPECT_NEAR(distanceOf(0.5 * (places[0] + places[1]), middle), 0.0, 1e-9);
    }
}

TEST(SpreadPlaces, ThoseThatAreApartOrBeyondStay) {
    const std::vector<QPointF> apart{{100.0, 100.0}, {120.0, 100.0}, {100.0, 130.0}};
    EXPECT_EQ(spreadApart(apart, 15.0, all), apart);
    const std::vector<QPointF> beyond{{-5.0, 100.0}, {-4.0, 100.0}};
    EXPECT_EQ(spreadApart(beyond, 15.0, all), beyond);
    const std::vector<QPointF> near{{100.0, 100.0}, {101.0, 100.0}};
    EXPECT_EQ(spreadApart(near, 15.0, QRectF()), near);
}

TEST(SpreadPlaces, AHandfulAtOnePlaceFindsRoomAboutItsMiddle) {
    const std::vector<QPointF> given{{500, 500}, {502, 501}, {499, 503}, {501, 498}, {497, 500}};
    const auto places = spreadApart(given, 15.0, all);
    QPointF sum;
    for (std::size_t i = 0; i < places.size(); ++i) {
        sum += places[i] - given[i];
        for (std::size_t other = 0; other < i; ++other) {
            EXPECT_GT(distanceOf(places[i], places[other]), 13.0) << i << " and " << other;
        }
    }
    EXPECT_NEAR(std::hypot(sum.x(), sum.y()), 0.0, 1e-9);
}

}  // namespace
}  // namespace ravnoves
