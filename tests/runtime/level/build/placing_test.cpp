// Placements of a player compared with an independent count of the rules; names and order for every order of
// placing.
#include "runtime/level/build/placing.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace trembler {
namespace placing_test {
namespace {

class Placing : public testing::Test {
protected:
    Placing() {
        sample::fill(registry);
        library = sample::parts(registry, {partOf("steel bar"), partOf("crate"), partOf("lamp")});
    }
    static std::string partOf(std::string const& name) {
        return R"({"name": ")" + name + R"(", "properties": {"weight": 5}})";
    }
    [[nodiscard]] LevelFile level(std::string const& members) const {
        return sample::read(registry, R"({"version": 2, "title": "t", "objects": [], "toolbox": [)"
                                      R"({"part": "steel bar", "count": 2}, {"part": "crate"}])" +
                                          members + "}");
    }
    [[nodiscard]] static Placement at(double x, double y, std::string part = "crate") {
        return {std::move(part), {x, y}, 0, ""};
    }
    /// The reason why it may not be placed; "" if it may.
    [[nodiscard]] std::string refusal(LevelFile const& in, Placement const& candidate,
                                      std::vector<Placement> const& others = {}) const {
        return checkPlacement(in, library, others, candidate).value_or("");
    }
    Registry registry;
    PartLibrary library;
};

TEST_F(Placing, OfAnUnlimitedPartHasNoEnd) {
    LevelFile const any = sample::read(registry, R"({"version": 2, "title": "t", "objects": [], "toolbox": [)"
                                                 R"({"part": "crate", "count": "unlimited"}]})");
    PlacementCount count(any, library);
    for (int i = 0; i < 5000; ++i) { // five times as many as a number may state
        ASSERT_EQ(count.add(at(i, 0)).value_or(""), "") << i;
    }
}

TEST_F(Placing, OfAnUnknownPartIsReportedWithASimilarName) {
    LevelFile const any = level("");
    EXPECT_SAYS(refusal(any, at(0, 0, "crat")), "crat");
    EXPECT_SAYS(refusal(any, at(0, 0, "crat")), "did you mean 'crate'?");
    EXPECT_SAYS(refusal(any, at(0, 0, "lamp")), "toolbox of this level has no 'lamp'");
}

TEST_F(Placing, TakesNoMoreThanTheToolboxHas) {
    LevelFile const any = level("");
    EXPECT_EQ(refusal(any, at(0, 0)), "");
    EXPECT_SAYS(refusal(any, at(0, 0), {at(1, 0)}), "only one 'crate'");
    EXPECT_EQ(refusal(any, at(0, 0, "steel bar"), {at(1, 0), at(0, 0, "steel bar")}), "");
    EXPECT_SAYS(refusal(any, at(0, 0, "steel bar"), {at(1, 0, "steel bar"), at(2, 0), at(3, 0, "steel bar")}),
                "only 2 of 'steel bar'");
    LevelFile none = any;
    none.toolbox[1].count = 0;
    EXPECT_SAYS(refusal(none, at(0, 0)), "only 0 of 'crate'");
}

TEST_F(Placing, PlacesMustBeFinite) {
    LevelFile const any = level("");
    double const none = std::numeric_limits<double>::quiet_NaN();
    double const infinite = std::numeric_limits<double>::infinity();
    for (Placement const& bad : {at(none, 0), at(0, -infinite), Placement{"crate", {0, 0}, none, ""},
                                 Placement{"crate", {0, 0}, infinite, ""}}) {
        EXPECT_NE(refusal(any, bad), "");
    }
}

TEST_F(Placing, IsLimitedToTheBoundsIncludingTheirEdgesIfThereAreNoAreas) {
    std::string const bounds = R"(, "world": {"bounds": [-2, -1, 4, 2]})";
    LevelFile const bounded = level(bounds);
    for (Vec2 const corner : {Vec2{-2, -1}, Vec2{2, 1}, Vec2{0, 0}}) {
        EXPECT_EQ(refusal(bounded, at(corner.x, corner.y)), "");
    }
    for (Vec2 const outside : {Vec2{-2.001, 0}, Vec2{2.001, 0}, Vec2{0, 1.001}, Vec2{0, -1.001}}) {
        EXPECT_SAYS(refusal(bounded, at(outside.x, outside.y)), "outside the level");
    }
    LevelFile const areas =
        level(bounds + R"(, "placing": [[0, 0, 1, 1], [[-2, -1], [0, -1], [-1, 0], [-2, 0]]])");
    EXPECT_EQ(refusal(areas, at(1, 1)), "");
    EXPECT_EQ(refusal(areas, at(-1.5, -0.5)), "");
    EXPECT_SAYS(refusal(areas, at(-0.25, -0.5)), "Nothing can be placed there");
    EXPECT_SAYS(refusal(areas, at(1.5, 0.5)), "Nothing can be placed there");
    EXPECT_SAYS(refusal(level(R"(, "placing": [])"), at(0, 0)), "Nothing can be placed there");
}

// Counting parts incrementally gives the same answer for each placement as counting all earlier ones.
TEST_F(Placing, AnIncrementalCountAgreesWithACountOfAllEarlierOnes) {
    LevelFile const bounded = level(R"(, "world": {"bounds": [-5, -2, 10, 6]})");
    EXPECT_TRUE(rc::check([&] {
        std::vector<Placement> placements(*rc::gen::inRange<std::size_t>(0, 12));
        std::map<std::string, int> left{{"steel bar", 2}, {"crate", 1}};
        PlacementCount count(bounded, library);
        for (std::size_t i = 0; i < placements.size(); ++i) {
            Placement& placement = placements[i];
            placement.part = *rc::gen::element<std::string>("steel bar", "crate", "lamp", "no such part");
            placement.at = {static_cast<double>(*rc::gen::inRange(-10, 10)),
                            static_cast<double>(*rc::gen::inRange(-4, 8))};
            std::optional<std::string> const why = count.add(placement);
            RC_ASSERT(why == checkPlacement(bounded, library, std::span(placements).first(i), placement));
            bool const inside = std::abs(placement.at.x) <= 5 && std::abs(placement.at.y - 1) <= 3;
            RC_ASSERT(why.has_value() == !(left[placement.part]-- > 0 && inside));
        }
    }));
}

double someNumber() {
    return *rc::gen::element(-1.0, -0.0, 0.0, 1.0, 0.5);
}

std::vector<Placement> somePlacements() {
    std::vector<Placement> placements(*rc::gen::inRange<std::size_t>(0, 9));
    for (Placement& placement : placements) {
        placement = {*rc::gen::element<std::string>("crate", "steel bar", "lamp"),
                     {someNumber(), someNumber()},
                     someNumber(),
                     ""};
    }
    return placements;
}

std::vector<std::string> bitsOf(std::vector<Placement> const& placements) {
    std::vector<std::string> bits;
    for (Placement const& placement : placements) {
        std::string all = placement.part;
        for (double const number : {placement.at.x, placement.at.y, placement.angle}) {
            all += std::signbit(number) ? " -" : " +";
            all += std::to_string(std::abs(number));
        }
        bits.push_back(all);
    }
    return bits;
}

TEST_F(Placing, TheOrderInWhichPartsWerePlacedNeverMatters) {
    LevelFile const any = level("");
    EXPECT_TRUE(rc::check([&] {
        std::vector<Placement> placements = somePlacements();
        std::vector<Placement> const ordered = inCanonicalOrder(placements);
        std::vector<std::string> const names = placementNames(any, placements);
        std::size_t const shift =
            placements.empty() ? 0 : *rc::gen::inRange<std::size_t>(0, placements.size());
        std::rotate(placements.begin(), placements.begin() + static_cast<std::ptrdiff_t>(shift),
                    placements.end());
        if (*rc::gen::arbitrary<bool>()) {
            std::reverse(placements.begin(), placements.end());
        }
        for (Placement& placement : placements) { // zero may have either sign
            placement.angle =
                placement.angle == 0 && *rc::gen::arbitrary<bool>() ? -placement.angle : placement.angle;
        }
        RC_ASSERT(bitsOf(inCanonicalOrder(placements)) == bitsOf(ordered));
        RC_ASSERT(bitsOf(inCanonicalOrder(ordered)) == bitsOf(ordered));
        RC_ASSERT(placementNames(any, placements) == names);
    }));
}

TEST_F(Placing, NamesAreThePartsNameAndAFreeNumber) {
    LevelFile const taken = sample::read(registry, R"({"version": 2, "title": "t", "objects": [
        {"name": "crate 2", "properties": {"weight": 1}}, {"name": "lamp 1", "properties": {"weight": 1}}],
        "joints": [{"a": "crate 2", "strength": 1}, {"name": "crate 3", "a": "lamp 1"}]})");
    EXPECT_EQ(placementNames(taken, std::vector{at(2, 0), at(0, 0, "lamp"), at(0, 0), at(0, 0, "steel bar")}),
              (std::vector<std::string>{"crate 1", "crate 4", "lamp 2", "steel bar 1"}))
        << "in canonical order: the crate at x = 0 comes first";
    EXPECT_TRUE(rc::check([&] {
        std::vector<Placement> const placements = somePlacements();
        std::vector<Placement> const ordered = inCanonicalOrder(placements);
        std::vector<std::string> const names = placementNames(taken, placements);
        std::set<std::string> known{"crate 2", "lamp 1", "crate 3", "joint 1"};
        RC_ASSERT(names.size() == placements.size());
        for (std::size_t i = 0; i < names.size(); ++i) {
            RC_ASSERT(names[i].starts_with(ordered[i].part + " "));
            RC_ASSERT(known.insert(names[i]).second);
        }
    }));
    EXPECT_TRUE(placementNames(taken, {}).empty());
}

} // namespace
} // namespace placing_test
} // namespace trembler
