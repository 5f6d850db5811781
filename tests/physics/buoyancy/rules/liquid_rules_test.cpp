#include "physics/buoyancy/hulls/liquid_area.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/moments.hpp"
#include "physics/buoyancy/rules/liquid_rules.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "runtime/placement.hpp"
#include "tests/physics/buoyancy/generators.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

namespace trembler::test {
namespace {

constexpr double allowed = 1e-4; // m²

class Liquids {
public:
    ObjectId add(Shape shape, Vec2 at, double angle = 0) {
        ObjectId const id = store.create(fmt::format("liquid {}", names_++));
        store.column<Liquid>().set(id, {});
        store.column<Shape>().set(id, std::move(shape));
        store.column<Position>().set(id, {at});
        store.column<Rotation>().set(id, {angle});
        return id;
    }
    Store store;

private:
    int names_ = 0;
};

double common(ShapePiece const& piece, Pose const& pose, LiquidPiece const& other) {
    std::vector<Vec2> const all = straightened(piece);
    std::size_t const step = all.size() + other.sides.size() > ClippedPolygon::capacity ? 5 : 1;
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < all.size(); i += step) {
        corners.push_back(pose.toWorld(all[i]));
    }
    ClippedPolygon polygon(corners);
    for (Side const& side : other.sides) {
        polygon.clip(side, 0);
    }
    return polygonMoments(polygon.corners()).area;
}

/// The rule by its definition, comparing every pair of pieces.
std::optional<std::string> bruteForce(Store const& store, ObjectId id) {
    auto const& shapes = *store.findColumn<Shape>();
    auto const pose = [&](ObjectId of) {
        return Pose(store.findColumn<Position>()->find(of)->value,
                    store.findColumn<Rotation>()->find(of)->angle);
    };
    Shape const* const shape = shapes.find(id);
    if (shape == nullptr) {
        return "it is a liquid without a shape; expected a shape, which is the liquid's area";
    }
    if (faultIn(*shape)) {
        return std::nullopt;
    }
    std::vector<LiquidPiece> const pieces = liquidPieces(*shape, pose(id));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (double const area = common(shape->pieces[i], pose(id), pieces[j]); area > allowed) {
                return fmt::format("its pieces {} and {} overlap by {:.3g} m²; expected pieces side by side",
                                   j + 1, i + 1, area);
            }
        }
    }
    for (ObjectId const other : store.findColumn<Liquid>()->owners()) {
        Shape const* const there = shapes.find(other);
        if (!(other < id) || there == nullptr || faultIn(*there)) {
            continue;
        }
        for (ShapePiece const& piece : there->pieces) {
            for (LiquidPiece const& mine : pieces) {
                if (double const area = common(piece, pose(other), mine); area > allowed) {
                    return fmt::format(
                        "it overlaps the liquid '{}' by {:.3g} m²; expected liquids side by side",
                        store.nameOf(other), area);
                }
            }
        }
    }
    return std::nullopt;
}

std::map<ObjectId, std::string> found(Store const& store) {
    std::map<ObjectId, std::string> all;
    ObjectId last{0, 0};
    for (ObjectFault const& fault : checkLiquids(store)) {
        EXPECT_TRUE(all.empty() || last < fault.object);
        last = fault.object;
        all[fault.object] = fault.text;
    }
    return all;
}

TEST(LiquidRules, AgreeWithComparingAllPairs) {
    std::size_t levels = 0;
    std::size_t faults = 0;
    std::size_t sound = 0;
    EXPECT_TRUE(rc::check([&] {
        ++levels;
        Liquids liquids;
        int const count = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, 14));
        double const room = *number(0, 12);
        for (int i = 0; i < count; ++i) {
            Shape shape{{*piece()}};
            if (*number(0, 1) > 0.6) {
                shape.pieces.push_back(*piece());
                shape.pieces.back().at += Vec2{*number(0, 3), 0};
            }
            ObjectId const id = liquids.add(std::move(shape), *point(room), *number(-3, 3));
            if (*number(0, 1) > 0.95) {
                liquids.store.column<Shape>().remove(id);
            } else if (*number(0, 1) > 0.95) {
                liquids.store.column<Shape>()[id].pieces.front().radius = -1; // invalid for round pieces
            }
        }
        std::map<ObjectId, std::string> expected;
        for (ObjectId const id : liquids.store.findColumn<Liquid>()->owners()) {
            if (auto fault = bruteForce(liquids.store, id)) {
                expected[id] = *fault;
                ++faults;
            } else {
                ++sound;
            }
        }
        RC_ASSERT(found(liquids.store) == expected);
    }));
    EXPECT_GT(faults, levels);
    EXPECT_GT(sound, levels);
}

TEST(LiquidRules, ReportOnlyTheFirstOverlap) {
    Liquids liquids;
    ObjectId const left = liquids.add({{boxPiece(2, 1)}}, {0, 0});
    ObjectId const right = liquids.add({{boxPiece(2, 1)}}, {2, 0}); // touching is allowed
    ObjectId const both = liquids.add({{boxPiece(2, 1)}}, {1, 0});
    ObjectId const folded = liquids.add({{boxPiece(1, 1), boxPiece(1, 1, {0.5, 0})}}, {0, 0});
    auto const all = found(liquids.store);
    EXPECT_EQ(all.count(left) + all.count(right), 0U);
    EXPECT_EQ(all.at(both), "it overlaps the liquid 'liquid 0' by 1 m²; expected liquids side by side");
    EXPECT_EQ(all.at(folded), "its pieces 1 and 2 overlap by 0.5 m²; expected pieces side by side");
}

TEST(LiquidRules, ReportNothingWithoutLiquids) {
    Store store;
    EXPECT_TRUE(checkLiquids(store).empty());
    (void)store.column<Liquid>();
    EXPECT_TRUE(checkLiquids(store).empty());
}

} // namespace
} // namespace trembler::test
