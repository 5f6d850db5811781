// The work in a picture depends on the cost of frames; the test needs no clock.
#include "game/ui/play/whatif/picture_pace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace trembler::ui {
namespace picture_pace_test {
namespace {

struct Done {
    std::uint64_t frames = 0;
    double seconds = 0;
};

/// One picture, in which frames cost that much.
Done picture(PicturePace& pace, double perFrame) {
    Done done;
    pace.begin();
    for (std::uint64_t batch = pace.next(); batch > 0; batch = pace.next()) {
        done.frames += batch;
        done.seconds += static_cast<double>(batch) * perFrame;
        pace.took(batch, static_cast<double>(batch) * perFrame);
    }
    return done;
}

TEST(PicturePace, ComputesAsMuchAsThereIsTimeFor) {
    for (double const perFrame : {1e-6, 1e-4, 4e-4, 1e-3, 3e-3}) {
        PicturePace pace;
        picture(pace, perFrame);
        Done const done = picture(pace, perFrame);
        EXPECT_LE(done.seconds, PicturePace::budget + perFrame) << perFrame;
        EXPECT_LE(done.frames, PicturePace::mostFrames);
        double const possible = PicturePace::budget / perFrame;
        EXPECT_GE(static_cast<double>(done.frames),
                  std::min(possible - 1, static_cast<double>(PicturePace::mostFrames)))
            << perFrame;
    }
}

TEST(PicturePace, ComputesAFrameInEachPictureHoweverSlow) {
    PicturePace pace;
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(picture(pace, 1).frames, 1U);
    }
}

TEST(PicturePace, SpendsLittleMoreWhenFramesSuddenlyCostMore) {
    PicturePace pace;
    for (int i = 0; i < 10; ++i) {
        picture(pace, 2e-4);
    }
    Done const done = picture(pace, 4e-3);
    EXPECT_LE(done.frames, 11U);
    EXPECT_LE(picture(pace, 4e-3).frames, 3U);
}

TEST(PicturePace, CountsOtherWork) {
    PicturePace pace;
    picture(pace, 1e-3);
    pace.begin();
    pace.spent(1);
    EXPECT_EQ(pace.next(), 1U);
    pace.took(1, 1e-3);
    EXPECT_EQ(pace.next(), 0U);
}

} // namespace
} // namespace picture_pace_test
} // namespace trembler::ui
