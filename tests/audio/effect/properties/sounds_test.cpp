// The sound of a frame in several parts: the impacts of all parts at their times, and the same amount of
// noise.
#include "audio/effect/properties/sounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler {
namespace {

Sounds soundsOf(ObjectId impactOf, double since, ObjectId scrapeOf, double noise) {
    Sounds made;
    made.impacts.push_back(
        {.object = impactOf, .other = {}, .at = {}, .since = since, .first = 0, .count = 2});
    made.amplitudes = {1, 2};
    made.scrapes.push_back({.object = scrapeOf, .other = {}, .at = {}, .first = 2, .count = 1});
    made.amplitudes.push_back(noise);
    return made;
}

TEST(Sounds, OfAFrameContainTheImpactsOfAllPartsAtTheirTimes) {
    ObjectId const bell{1, 1};
    ObjectId const plate{2, 1};
    Sounds frame;
    Sounds const first = soundsOf(bell, 0.001, plate, 3);
    Sounds second = soundsOf(plate, 0.002, bell, 5);
    second.frame = 7;
    Sounds::gather(frame, first, {.first = true, .begin = 0, .share = 0.5});
    Sounds::gather(frame, second, {.first = false, .begin = 1.0 / 120, .share = 0.5});
    ASSERT_EQ(frame.impacts.size(), 2U);
    EXPECT_EQ(frame.impacts[0].object, bell);
    EXPECT_DOUBLE_EQ(frame.impacts[0].since, 0.001);
    EXPECT_EQ(frame.impacts[1].object, plate);
    EXPECT_DOUBLE_EQ(frame.impacts[1].since, 0.002 + 1.0 / 120);
    EXPECT_EQ(frame.amplitudes[frame.impacts[1].first], 1);
    EXPECT_EQ(frame.amplitudes[frame.impacts[1].first + 1], 2);
    ASSERT_EQ(frame.scrapes.size(), 2U);
    EXPECT_NEAR(frame.amplitudes[frame.scrapes[0].first], 3 / std::sqrt(2), 1e-12);
    EXPECT_NEAR(frame.amplitudes[frame.scrapes[1].first], 5 / std::sqrt(2), 1e-12);
    EXPECT_EQ(frame.frame, 7U);
}

TEST(Sounds, ANoiseThroughoutAFrameIsTheSameInAnyNumberOfParts) {
    ObjectId const bell{1, 1};
    for (int const parts : {2, 4, 8}) {
        Sounds frame;
        for (int part = 0; part < parts; ++part) {
            Sounds one;
            one.scrapes.push_back({.object = bell, .other = {}, .at = {}, .first = 0, .count = 2});
            one.amplitudes = {3, 4};
            Sounds::gather(frame, one,
                           {.first = part == 0, .begin = part / 60.0 / parts, .share = 1.0 / parts});
        }
        ASSERT_EQ(frame.scrapes.size(), 1U);
        EXPECT_NEAR(frame.amplitudes[frame.scrapes[0].first], 3, 1e-12);
        EXPECT_NEAR(frame.amplitudes[frame.scrapes[0].first + 1], 4, 1e-12);
    }
}

} // namespace
} // namespace trembler
