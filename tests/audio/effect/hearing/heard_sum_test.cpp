// The sum of all sounds at a listener, compared bit for bit with a sum that leaves out nothing.
#include "audio/effect/hearing/heard_sum.hpp"
#include "audio/effect/hearing/sound_path.hpp"
#include "audio/effect/properties/decibel.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace {

double anyNumber(int from, int to) {
    return *rc::gen::inRange(from * 100, to * 100) / 100.0 + 0.0017;
}

double oneWay(ObstacleField const& field, SoundSource const& source, SoundListener const& listener,
              double least) {
    return source.loudness * transmission(field, std::span(&listener.object, 1), source.at, listener.at,
                                          source.frequency, PathDetail::straight, least / source.loudness);
}

struct Sum {
    double heard = 0;
    std::optional<std::uint32_t> loudest;
    std::size_t ways = 0; // computed
};

Sum ofAll(ObstacleField const& field, std::span<SoundSource const> sources, SoundListener const& listener,
          double silence) {
    Sum all;
    double most = 0;
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        if (reaches(sources[i], listener)) {
            double const heard = oneWay(field, sources[i], listener, silence);
            all.heard += heard;
            ++all.ways;
            if (heard > most) {
                most = heard;
                all.loudest = i;
            }
        }
    }
    return all;
}

Sum ofNeeded(ObstacleField const& field, std::span<SoundSource const> sources, SoundListener const& listener,
             double silence, double neglected) {
    SourceTree const tree(sources);
    HeardSum sum;
    Sum needed;
    sum.begin(listener, tree, silence, neglected);
    while (sum.next(tree, field)) {
        for (HeardSum::Way& way : sum.ways()) {
            way.heard = oneWay(field, sources[way.source], listener, sum.least());
            ++needed.ways;
        }
    }
    needed.heard = sum.sum();
    needed.loudest = sum.loudest();
    return needed;
}

double const silence = 0x1p-80 * meanSquareOf(silentLevel);

TEST(HeardSum, HasTheBitsOfTheSumOfAllWays) {
    EXPECT_TRUE(rc::check("in a corridor of many boxes", [] {
        std::vector<Obstacle> boxes;
        std::vector<SoundSource> sources;
        double const gap = 0.1 + anyNumber(0, 2);
        auto const count = static_cast<std::uint32_t>(*rc::gen::inRange(0, 300));
        for (std::uint32_t i = 0; i < count; ++i) {
            Vec2 const at{(0.4 + gap) * i, 0.4 * anyNumber(-1, 1)};
            addObstacles(boxes, ObjectId{i, 0}, Shape{{boxPiece(0.1 + 0.2 * anyNumber(0, 1), 0.8)}}, at,
                         anyNumber(-3, 3), 1 + anyNumber(0, 8000));
            sources.push_back({{i, 0},
                               at + 0.3 * Vec2{anyNumber(-1, 1), anyNumber(-1, 1)},
                               meanSquareOf(anyNumber(-20, 120)),
                               30 + anyNumber(0, 5000),
                               {}});
        }
        ObstacleField const field(boxes);
        SoundListener const ear{{static_cast<std::uint32_t>(*rc::gen::inRange(0, 400)), 0},
                                true,
                                {anyNumber(-5, 200), anyNumber(-2, 3)},
                                meanSquareOf(anyNumber(-20, 60))};
        Sum const all = ofAll(field, sources, ear, silence);
        // A share that is too great must be noticed, and only cost time.
        for (double const neglected : {HeardSum::usuallyNeglected, 0x1p-56, 0x1p-40, 0x1p-10, 1.0, 0.0}) {
            Sum const needed = ofNeeded(field, sources, ear, silence, neglected);
            RC_ASSERT(needed.heard == all.heard);
            RC_ASSERT(needed.loudest == all.loudest);
            RC_ASSERT(neglected > 0 || needed.ways == all.ways);
        }
    }));
}

// A row of steel boxes, each of which sounds at the floor, and an ear above.
std::size_t waysInARow(std::uint32_t count) {
    std::vector<Obstacle> boxes;
    std::vector<SoundSource> sources;
    for (std::uint32_t i = 0; i < count; ++i) {
        addObstacles(boxes, ObjectId{i, 0}, Shape{{boxPiece(0.5, 0.5)}}, {1.0 * i, 0.25}, 0, 7800);
        sources.push_back({{i, 0}, {1.0 * i, 0.01}, meanSquareOf(80), 2000, {}});
    }
    ObstacleField const field(boxes);
    SoundListener const ear{{count, 0}, true, {count / 2 + 0.3, 1}, meanSquareOf(-10)};
    Sum const needed = ofNeeded(field, sources, ear, silence, HeardSum::usuallyNeglected);
    EXPECT_EQ(needed.heard, ofAll(field, sources, ear, silence).heard);
    return needed.ways;
}

TEST(HeardSum, ComputesNoMoreWaysWhenSourcesBehindWallsAreAdded) {
    std::size_t const few = waysInARow(1000);
    EXPECT_LT(few, 400U);
    EXPECT_LE(waysInARow(8000), few + 50);
}

TEST(HeardSum, IsZeroWithoutSourcesOrPlace) {
    ObstacleField const field({});
    std::vector<SoundSource> const one{{{1, 0}, {0, 0}, 1, 1000, {}}};
    SoundListener const somewhere{{2, 0}, true, {1, 0}, 1e-12};
    SoundListener const nowhere{{2, 0}, false, {}, 1e-12};
    EXPECT_EQ(ofNeeded(field, {}, somewhere, silence, 0x1p-68).heard, 0);
    EXPECT_EQ(ofNeeded(field, one, nowhere, silence, 0x1p-68).heard, 0);
    Sum const heard = ofNeeded(field, one, somewhere, silence, 0x1p-68);
    EXPECT_EQ(heard.heard, 1);
    EXPECT_EQ(heard.loudest, 0U);
}

} // namespace
} // namespace trembler
