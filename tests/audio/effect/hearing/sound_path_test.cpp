// Sound transmitted through walls and diffracted around them, compared with brute force and closed forms.
#include "audio/effect/hearing/sound_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace trembler {
namespace {

Obstacle boxAt(Vec2 at, double width, double height, double angle = 0, double density = 2000) {
    std::vector<Obstacle> made;
    addObstacles(made, ObjectId{7, 0}, Shape{{boxPiece(width, height)}}, at, angle, density);
    return made.front();
}
bool inside(Obstacle const& obstacle, Vec2 p) {
    for (std::size_t i = 0; i < obstacle.corners.size(); ++i) {
        Vec2 const a = obstacle.corners[i];
        Vec2 const b = obstacle.corners[(i + 1) % obstacle.corners.size()];
        if (cross(b - a, p - a) < 0) {
            return false;
        }
    }
    return true;
}
double wayOut(std::vector<Obstacle> const& obstacles, Vec2 from, Vec2 to) {
    std::vector<Obstacle const*> all;
    for (Obstacle const& obstacle : obstacles) {
        all.push_back(&obstacle);
    }
    return shortestWay(all, from, to);
}
double somewhere(int from, int to) {
    return *rc::gen::inRange(from * 100, to * 100) / 100.0 + 0.0017;
}

TEST(Obstacles, ChordsAgreeWithSampling) {
    EXPECT_TRUE(rc::check("the chord is the share of points inside, times the length", [] {
        Obstacle const box = boxAt({somewhere(-2, 2), somewhere(-2, 2)}, 0.1 + somewhere(0, 2),
                                   0.1 + somewhere(0, 2), somewhere(-3, 3));
        Vec2 const from{somewhere(-4, 4), somewhere(-4, 4)};
        Vec2 const to{somewhere(-4, 4), somewhere(-4, 4)};
        int const samples = 4000;
        int hits = 0;
        for (int i = 0; i < samples; ++i) {
            hits += inside(box, from + (i + 0.5) / samples * (to - from)) ? 1 : 0;
        }
        double const expected = length(to - from) * hits / samples;
        RC_ASSERT(std::abs(chordOf(box, from, to) - expected) <= 2 * length(to - from) / samples + 1e-12);
    }));
}

TEST(ObstacleField, FindsEveryObstacleOnALine) {
    EXPECT_TRUE(rc::check("against a look at every obstacle", [] {
        std::vector<Obstacle> boxes;
        for (int i = *rc::gen::inRange(0, 60); i > 0; --i) {
            boxes.push_back(boxAt({somewhere(-20, 20), somewhere(-4, 4)}, 0.02 + somewhere(0, 2),
                                  0.02 + somewhere(0, 2), somewhere(-3, 3)));
        }
        ObstacleField const field(boxes);
        Vec2 const from{somewhere(-22, 22), somewhere(-5, 5)};
        bool const upright = *rc::gen::arbitrary<bool>();
        Vec2 const to{upright ? from.x : somewhere(-22, 22), somewhere(-5, 5)};
        std::vector<std::uint32_t> visited;
        RC_ASSERT(field.along(from, to, [&](std::uint32_t number) {
            visited.push_back(number);
            return true;
        }));
        if (!visited.empty()) { // the search stops when the visitor returns false
            std::size_t const enough = 1 + *rc::gen::inRange(std::size_t{0}, visited.size());
            std::size_t seen = 0;
            RC_ASSERT(!field.along(from, to, [&](std::uint32_t number) {
                RC_ASSERT(number == visited[seen]);
                return ++seen < enough;
            }));
            RC_ASSERT(seen == enough);
        }
        std::vector<std::uint32_t> found = visited;
        std::sort(found.begin(), found.end());
        RC_ASSERT(std::adjacent_find(found.begin(), found.end()) == found.end());
        for (std::uint32_t n = 0; n < boxes.size(); ++n) {
            bool const listed = std::binary_search(found.begin(), found.end(), n);
            bool const met =
                chordOf(boxes[n], from, to) > 0 || inside(boxes[n], from) || inside(boxes[n], to);
            RC_ASSERT(listed || !met);
            // Obstacles far from the line are not visited.
            bool const far = std::max(from.x, to.x) < boxes[n].low.x - 0.01 ||
                             std::min(from.x, to.x) > boxes[n].high.x + 0.01 ||
                             std::max(from.y, to.y) < boxes[n].low.y - 0.01 ||
                             std::min(from.y, to.y) > boxes[n].high.y + 0.01;
            RC_ASSERT(!(listed && far));
        }
    }));
}

TEST(Obstacles, RoundPiecesAreEnclosed) {
    std::vector<Obstacle> made;
    addObstacles(made, ObjectId{1, 0}, Shape{{circlePiece(0.5), capsulePiece(2, 0.2, {0, 3})}}, {}, 0, 1000);
    ASSERT_EQ(made.size(), 2U);
    EXPECT_NEAR(chordOf(made[0], {-2, 0}, {2, 0}), 1, 0.03);
    EXPECT_GE(chordOf(made[0], {-2, 0.3}, {2, 0.3}), 2 * std::sqrt(0.25 - 0.09) - 1e-9);
    EXPECT_NEAR(chordOf(made[1], {-2, 3}, {2, 3}), 2, 0.03);
    EXPECT_NEAR(chordOf(made[1], {0.3, 2}, {0.3, 4}), 0.4, 1e-9);
}

TEST(Obstacles, TheDetourAroundAWallIsTheTautString) {
    Obstacle const wall = boxAt({0, 0}, 0.2, 2);
    Vec2 const from{-1, 0};
    Vec2 const to{1, 0};
    double const expected = 2 * std::hypot(0.9, 1.0) + 0.2;
    EXPECT_NEAR(detourAround(wall, from, to), expected, 1e-9);
    EXPECT_NEAR(detourAround(wall, {-1, 0.9}, {1, 0.9}), 2 * std::hypot(0.9, 0.1) + 0.2, 1e-9)
        << "the near end";
}

TEST(Obstacles, TheShortestWayAroundOneIsThatDetour) {
    EXPECT_TRUE(rc::check("both find the same way around a single obstacle", [] {
        Obstacle const box = boxAt({0, 0}, 0.4 + somewhere(0, 1), 0.4 + somewhere(0, 2), somewhere(-3, 3));
        Vec2 const from{-3, somewhere(-1, 1)};
        Vec2 const to{3, -from.y + 0.1 * somewhere(-1, 1)};
        RC_ASSERT(chordOf(box, from, to) > 0.05);
        double const way = wayOut({box}, from, to);
        RC_ASSERT(std::abs(way - detourAround(box, from, to)) < 0.03);
        RC_ASSERT(way >= length(to - from));
    }));
}

// Walls around a room of 4 m by 3 m; the last one, on the right, is optional.
std::vector<Obstacle> room(bool closed) {
    std::vector<Obstacle> walls{boxAt({0, -1.6}, 4.4, 0.2), boxAt({0, 1.6}, 4.4, 0.2),
                                boxAt({-2.1, 0}, 0.2, 3.2)};
    if (closed) {
        walls.push_back(boxAt({2.1, 0}, 0.2, 3.2));
    }
    return walls;
}

TEST(Obstacles, NoWayLeadsOutOfAClosedRoom) {
    EXPECT_LT(wayOut(room(true), {0, 0}, {-4, 0}), 0);
    double const way = wayOut(room(false), {0, 0}, {-4, 0});
    // Out at the right end, above or below, and back along the outside.
    double const expected = std::hypot(2.2, 1.5) + 0.2 + 4.4 + std::hypot(1.8, 1.7);
    EXPECT_NEAR(way, expected, 0.05);
}

TEST(Obstacles, PathsNeverCrossObstaclesAndAreShortest) {
    // Compared with Dijkstra's algorithm on a grid of free cells: the path is never much longer than the
    // grid's, and both agree whether a path exists.
    EXPECT_TRUE(rc::check("a grid of 5 cm finds a way of about the same length", [] {
        std::vector<Obstacle> boxes;
        std::vector<Obstacle> wider; // no gap between them is too narrow for the grid
        for (int i = 0; i < 4; ++i) {
            Vec2 const middle{somewhere(-1, 1), somewhere(-1, 1)};
            double const width = 0.3 + somewhere(0, 1);
            double const angle = somewhere(-3, 3);
            boxes.push_back(boxAt(middle, width, 0.3, angle));
            wider.push_back(boxAt(middle, width + 0.15, 0.45, angle));
        }
        Vec2 const from{-2, 0};
        Vec2 const to{2, 0};
        constexpr int n = 121;
        auto const at = [](int x, int y) { return Vec2{(x - 60) * 0.05, (y - 60) * 0.05}; };
        std::vector<double> reach(n * n, 1e9);
        std::vector<char> blocked(n * n, 0);
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                for (Obstacle const& box : boxes) {
                    if (inside(box, at(x, y))) {
                        blocked[static_cast<std::size_t>(y * n + x)] = 1;
                    }
                }
            }
        }
        reach[static_cast<std::size_t>(60 * n + 20)] = 0;
        using Reached = std::pair<double, int>; // m, and the cell
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
        for (open.emplace(0, 60 * n + 20); !open.empty();) {
            auto const [far, cell] = open.top();
            open.pop();
            if (far > reach[static_cast<std::size_t>(cell)]) {
                continue; // a shorter path to this cell was found later
            }
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    int const x = cell % n + dx;
                    int const y = cell / n + dy;
                    if (x < 0 || y < 0 || x >= n || y >= n) {
                        continue;
                    }
                    auto const next = static_cast<std::size_t>(y * n + x);
                    double const way = far + 0.05 * std::hypot(dx, dy);
                    if (blocked[next] == 0 && way < reach[next]) {
                        reach[next] = way;
                        open.emplace(way, y * n + x);
                    }
                }
            }
        }
        double const grid = reach[static_cast<std::size_t>(60 * n + 100)];
        double const way = wayOut(boxes, from, to);
        RC_ASSERT(way >= 4 - 1e-9);
        // Eight directions are at most 8.3 % too long; cells cut corners by up to a cell each.
        RC_ASSERT(way <= grid + 0.4);
        double const wide = wayOut(wider, from, to);
        RC_ASSERT(wide < 0 || grid <= 1.083 * wide + 0.4);
    }));
}

TEST(SoundPath, FreeAirIsTheInverseSquare) {
    for (double const r : {0.5, 1.0, 3.0, 20.0}) {
        EXPECT_NEAR(transmission(ObstacleField({}), {}, {0, 0}, {r, 0}, 1000, PathDetail::straight),
                    1 / (r * r), 1e-12);
        EXPECT_NEAR(transmission(ObstacleField({}), {}, {0, 0}, {0, r}, 1000, PathDetail::around),
                    1 / (r * r), 1e-12);
    }
    EXPECT_NEAR(transmission(ObstacleField({}), {}, {1, 1}, {1, 1}, 1000, PathDetail::around), 100, 1e-9);
}

TEST(SoundPath, NeitherSourceNorListenerShieldsItself) {
    std::vector<Obstacle> const wall{boxAt({2, 0}, 1, 4)};
    std::vector<ObjectId> const exempt{wall.front().object};
    EXPECT_LT(transmission(ObstacleField(wall), {}, {0, 0}, {4, 0}, 1000, PathDetail::around), 0.01 / 16);
    EXPECT_EQ(transmission(ObstacleField(wall), exempt, {0, 0}, {4, 0}, 1000, PathDetail::around), 1.0 / 16);
    EXPECT_EQ(transmission(ObstacleField(wall), {}, {0, 0}, {2, 0}, 1000, PathDetail::straight), 1.0 / 4)
        << "let into the wall";
}

TEST(SoundPath, MassLawAndScreens) {
    // Twice the mass, or the frequency: 6 dB less. 20 mm of steel at 500 Hz: 20 log(157·500) - 47 = 50.9 dB.
    EXPECT_NEAR(shareThrough(200, 1000) / shareThrough(400, 1000), 4, 0.01);
    EXPECT_NEAR(-10 * std::log10(shareThrough(157, 500)), 50.9, 0.05);
    EXPECT_EQ(shareThrough(0.01, 20), 1);
    // Maekawa: on the edge of the shadow 4.8 dB; a Fresnel number of 1 gives 13.6 dB; never above 24.
    EXPECT_NEAR(-10 * std::log10(shareAround(0, 1000)), 4.77, 0.01);
    EXPECT_NEAR(-10 * std::log10(shareAround(343.0 / 2000, 1000)), 13.6, 0.05);
    EXPECT_NEAR(-10 * std::log10(shareAround(100, 1000)), 24, 1e-9);
}

TEST(SoundPath, AClosedRoomIsQuieterThanAnOpenOne) {
    double const distance = 4;
    auto const level = [&](bool closed, PathDetail detail) {
        std::vector<Obstacle> const walls = room(closed);
        return 10 * std::log10(transmission(ObstacleField(walls), {}, {0, 0}, {-distance, 0}, 1000, detail));
    };
    double const free = -20 * std::log10(distance);
    EXPECT_NEAR(level(true, PathDetail::around), free - (20 * std::log10(400.0 * 1000) - 47), 0.1)
        << "only the sound through 20 cm of stone";
    EXPECT_GT(level(false, PathDetail::around), level(true, PathDetail::around) + 20);
    EXPECT_LT(level(false, PathDetail::around), free - 15);
    EXPECT_NEAR(level(true, PathDetail::straight), level(false, PathDetail::straight), 1e-9)
        << "the cheap level considers only the wall in between";
}

TEST(SoundPath, IsOmittedOnlyIfInaudible) {
    EXPECT_TRUE(rc::check("with a limit: the same, or 0 if it is below", [] {
        std::vector<Obstacle> boxes;
        for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
            boxes.push_back(boxAt({somewhere(0, 20), 0.4 * somewhere(-1, 1)}, 0.05 + 0.5 * somewhere(0, 1),
                                  0.05 + 0.5 * somewhere(0, 1), somewhere(-3, 3), 1 + somewhere(0, 3000)));
        }
        ObstacleField const field(boxes);
        Vec2 const from{0, 0.5 * somewhere(-1, 1)};
        Vec2 const to{somewhere(1, 20), 0.5 * somewhere(-1, 1)};
        double const frequency = 50 + somewhere(0, 4000);
        double const all = transmission(field, {}, from, to, frequency, PathDetail::straight);
        double const least = all * std::pow(10, 0.1 * somewhere(-1, 1));
        double const heard = transmission(field, {}, from, to, frequency, PathDetail::straight, least);
        RC_PRE(std::abs(all - least) > 1e-9 * all);
        RC_ASSERT(heard == (all < least ? 0 : all));
    }));
}

TEST(SoundPath, NeverLouderThanFreeAir) {
    EXPECT_TRUE(rc::check("walls only take away", [] {
        std::vector<Obstacle> boxes;
        for (int i = 0; i < 3; ++i) {
            boxes.push_back(boxAt({somewhere(-2, 2), somewhere(-2, 2)}, 0.1 + somewhere(0, 2), 0.1,
                                  somewhere(-3, 3), 1 + somewhere(0, 3000)));
        }
        Vec2 const from{somewhere(-3, 3), somewhere(-3, 3)};
        Vec2 const to{somewhere(-3, 3), somewhere(-3, 3)};
        double const frequency = 50 + somewhere(0, 4000);
        double const r = std::max(0.1, length(to - from));
        for (PathDetail const detail : {PathDetail::straight, PathDetail::around}) {
            double const share = transmission(ObstacleField(boxes), {}, from, to, frequency, detail);
            RC_ASSERT(share > 0 && share <= 1 / (r * r) * (1 + 1e-12));
        }
    }));
}

} // namespace
} // namespace trembler
