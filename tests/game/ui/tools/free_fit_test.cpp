// The largest view beside cards: nothing lies under one, and it is better than between margins.
#include "game/ui/tools/free_fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <optional>
#include <vector>

namespace trembler::ui {
namespace {

using render::Camera;
using render::Extent;
using render::Point;

Extent extentAt(Point low, Point high) {
    Extent extent;
    extent.add(low);
    extent.add(high);
    return extent;
}

bool isSeen(Camera const& camera, Extent const& extent, std::vector<Rect> const& obstacles, double margin) {
    Point const a = camera.toScreen({extent.lower.x, extent.upper.y});
    Point const b = camera.toScreen({extent.upper.x, extent.lower.y});
    double const eps = 1e-6;
    bool free = a.x >= margin - eps && a.y >= margin - eps && b.x <= camera.viewport.width - margin + eps &&
                b.y <= camera.viewport.height - margin + eps;
    for (Rect const& obstacle : obstacles) {
        free = free && !Rect{a + Point{eps, eps}, b - Point{eps, eps}}.overlaps(obstacle);
    }
    return free;
}

std::optional<Camera> fitBeside(std::vector<Extent> const& machine, std::vector<Rect> const& cards,
                                double least, double most) {
    FitGroup const group{machine, cards};
    return freeFit({1280, 720}, {&group, 1}, 16, least, most);
}

TEST(FreeFit, UsesTheRoomBesideCards) {
    // A flat machine below two cards in the upper corners.
    std::vector<Extent> const machine{extentAt({-4, 0}, {4, 1}), extentAt({0, 1}, {1, 2})};
    std::vector<Rect> const cards{{{0, 0}, {320, 320}}, {{1000, 0}, {1280, 320}}};
    auto const camera = fitBeside(machine, cards, 1, 1e6);
    ASSERT_TRUE(camera);
    EXPECT_GT(camera->pixelsPerMetre, 140) << "between the cards' edges it would be 83";
    for (Extent const& extent : machine) {
        EXPECT_TRUE(isSeen(*camera, extent, cards, 16));
    }
    EXPECT_FALSE(fitBeside(machine, cards, 200, 1e6)) << "not that large";
    EXPECT_FALSE(fitBeside({}, cards, 1, 1e6));
    EXPECT_NEAR(fitBeside(machine, {}, 1, 50)->pixelsPerMetre, 50, 1e-9);
}

TEST(FreeFit, EachGroupHasObstaclesOfItsOwn) {
    std::vector<Extent> const machine{extentAt({-4, 0}, {4, 1})};
    std::vector<Extent> const air{extentAt({-4, 1}, {4, 3})};
    std::vector<Rect> const card{{{0, 0}, {320, 500}}};
    std::array const groups{FitGroup{machine, card}, FitGroup{air, {}}};
    auto const camera = freeFit({1280, 720}, groups, 16, 1, 1e6);
    ASSERT_TRUE(camera);
    EXPECT_TRUE(isSeen(*camera, machine[0], card, 16));
    EXPECT_TRUE(isSeen(*camera, air[0], {}, 16)) << "inside the window";
    EXPECT_FALSE(isSeen(*camera, air[0], card, 16)) << "it may lie under the card, and so be larger";
}

RC_GTEST_PROP(FreeFit, NothingIsHidden, ()) {
    auto const number = [](int low, int high) { return static_cast<double>(*rc::gen::inRange(low, high)); };
    std::vector<Extent> machine;
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
        Point const low{number(-50, 50) / 10, number(-30, 30) / 10};
        machine.push_back(extentAt(low, low + Point{number(1, 30) / 10, number(1, 20) / 10}));
    }
    std::vector<Rect> cards;
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
        Point const low{number(0, 900), number(0, 500)};
        cards.push_back({low, low + Point{number(10, 300), number(10, 300)}});
    }
    auto const camera = fitBeside(machine, cards, 5, 1e6);
    if (camera) {
        for (Extent const& extent : machine) {
            RC_ASSERT(isSeen(*camera, extent, cards, 16));
        }
    }
}

} // namespace
} // namespace trembler::ui
