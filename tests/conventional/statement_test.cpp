// The statements by which simulations are judged, compared with results worked out by hand.
#include "tests/conventional/statement.hpp"

#include <gtest/gtest.h>

namespace trembler::conventional {
namespace {

struct Bench {
    Facts facts;
    Setting setting;
    Film film;

    Bench() {
        setting.level = {{"connections", nlohmann::json::array()}};
        film.poses.resize(2);
    }
    void put(std::string const& name, Vec2 at, Fact fact) {
        fact.conductor = true;
        facts.emplace(name, std::move(fact));
        for (auto& frame : film.poses) {
            frame[name] = {at, 0, true};
        }
    }
    void wire(std::string const& a, std::string const& b) { setting.level["connections"].push_back({a, b}); }
    [[nodiscard]] bool on(std::string const& name, std::uint64_t frame = 1) const {
        return Statement(facts, setting, film).inCircuit(name, frame);
    }
};

TEST(Statement, ADeadEndIsInNoCircuit) {
    Bench bench;
    bench.put("plus", {}, {.source = true});
    bench.put("lamp", {}, {});
    bench.put("end", {}, {});
    bench.put("minus", {}, {.earth = true});
    bench.wire("plus", "lamp");
    bench.wire("lamp", "minus");
    bench.wire("lamp", "end");
    EXPECT_TRUE(bench.on("lamp"));
    EXPECT_FALSE(bench.on("end"));
    bench.setting.cuts.push_back({1, "minus", "lamp"});
    EXPECT_FALSE(bench.on("lamp", 1));
    EXPECT_TRUE(bench.on("lamp", 0));
}

TEST(Statement, WhatTouchesConducts) {
    Bench bench;
    Fact box;
    box.shape = {{boxPiece(1, 1)}};
    bench.put("bar", {0, 0}, box);
    box.source = true;
    bench.put("left", {-1.005, 0}, box);
    box.source = false;
    box.earth = true;
    bench.put("right", {1.005, 0}, box);
    EXPECT_TRUE(bench.on("bar"));
    bench.film.poses[1]["right"].at.x = 1.05;
    EXPECT_FALSE(bench.on("bar"));
}

TEST(Statement, AForceIsCoulombs) {
    Bench bench;
    bench.put("magnet", {0, 2}, {.strength = 1000, .poles = {{0, 0}}});
    bench.put("iron", {}, {.susceptibility = 500});
    Statement const statement(bench.facts, bench.setting, bench.film);
    EXPECT_NEAR(statement.force("iron", {0, 0}, 0).y, 1e-7 * 1000 * 500 / 4, 1e-12);
}

TEST(Statement, DistancesBetweenForms) {
    Pose const here{{0, 0}, 0, true};
    Pose const there{{3, 0}, 0, true};
    Shape const box{{boxPiece(2, 2)}};
    Shape const ball{{circlePiece(0.5)}};
    EXPECT_NEAR(distance(outlinesOf(box, here), outlinesOf(box, there)), 1, 1e-12);
    EXPECT_NEAR(distance(outlinesOf(box, here), outlinesOf(ball, there)), 1.5, 1e-12);
    EXPECT_EQ(distance(outlinesOf(box, here), outlinesOf(ball, here)), 0);
    Pose const turned{{3, 0}, 3.14159265358979 / 4, true};
    EXPECT_NEAR(distance(outlinesOf(box, here), outlinesOf(box, turned)), 2 - std::sqrt(2), 1e-12);
}

} // namespace
} // namespace trembler::conventional
