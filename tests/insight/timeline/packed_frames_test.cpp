// Unpacked frames equal the packed ones, however their values change from frame to frame.
#include "insight/timeline/packed_frames.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>

namespace trembler::insight {
namespace {

bool unpackedTheSame(std::vector<RecordedFrame> const& frames) {
    std::vector<RecordedFrame> const back = PackedFrames(frames).unpacked();
    bool same = back.size() == frames.size();
    for (std::size_t i = 0; same && i < frames.size(); ++i) {
        same = back[i].number == frames[i].number && back[i].values.size() == frames[i].values.size();
        for (std::size_t part = 0; same && part < frames[i].values.size(); ++part) {
            Words const* const expected = frames[i].of(part);
            Words const* const found = back[i].of(part);
            same =
                (expected == nullptr) == (found == nullptr) && (expected == nullptr || *expected == *found);
        }
    }
    return same;
}

TEST(PackedFrames, AreBitForBitTheSame) {
    EXPECT_TRUE(rc::check([](std::vector<std::vector<std::vector<std::uint64_t>>> const& random) {
        std::vector<RecordedFrame> frames;
        std::uint64_t number = 0;
        for (auto const& parts : random) {
            RecordedFrame& frame = frames.emplace_back();
            frame.number = number += 1 + parts.size();
            for (Words const& words : parts) {
                bool const repeats = words.size() % 3 == 0 && frames.size() > 1 &&
                                     frame.values.size() < frames[frames.size() - 2].values.size();
                // Some values are those of the frame before, some are absent.
                frame.values.push_back(repeats ? frames[frames.size() - 2].values[frame.values.size()]
                                       : words.size() % 5 == 4 ? nullptr
                                                               : std::make_shared<Words const>(words));
            }
        }
        RC_ASSERT((frames.empty() || unpackedTheSame(frames)));
    }));
}

/// Single precision on a path through the air, as Box2D has it.
std::vector<RecordedFrame> flights(std::size_t count, std::size_t bodies) {
    std::vector<RecordedFrame> frames(count);
    for (std::size_t i = 0; i < count; ++i) {
        double const t = static_cast<double>(i) / 60;
        Words words;
        for (std::size_t body = 0; body < bodies; ++body) {
            auto const y = static_cast<float>(9.0 + static_cast<double>(body) * t - 4.905 * t * t);
            words.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(y)));
        }
        frames[i].number = i;
        frames[i].values = {std::make_shared<Words const>(words), nullptr};
    }
    return frames;
}

TEST(PackedFrames, OfFlyingBodiesTakeAboutAQuarter) {
    std::vector<RecordedFrame> const frames = flights(64, 100);
    EXPECT_TRUE(unpackedTheSame(frames));
    EXPECT_LT(PackedFrames(frames).bytes(), 64U * 100U * sizeof(double) / 3);
}

TEST(PackedFrames, OfThingsAtRestTakeNextToNothing) {
    auto const words = std::make_shared<Words const>(1000, 0x3ff123456789abcdU);
    std::vector<RecordedFrame> frames;
    for (std::uint64_t i = 0; i < 64; ++i) {
        frames.push_back({i, {words, words}});
    }
    EXPECT_TRUE(unpackedTheSame(frames));
    EXPECT_LT(PackedFrames(frames).bytes(), 2000U);
}

} // namespace
} // namespace trembler::insight
