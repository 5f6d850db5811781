// Parts that consist of pieces: their objects in a world, and the problems with them.
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/build/check_composites.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/level/write/write_level.hpp"
#include "runtime/placement.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace trembler {
namespace part_expander_test {
namespace {

/// A tray with a cup, which is eaten by its spoon, and a knot and a string between both.
std::string const tray = R"({"name": "tray", "main": "plate", "properties": {"weight": 9},
    "objects": [{"name": "plate", "properties": {"weight": 2, "tag": true}},
                {"name": "cup", "part": "cup", "at": [2, 1], "angle_deg": 90, "flipped": true}],
    "joints": [{"a": "cup", "b": "plate", "strength": 3}],
    "connections": [["plate", "cup handle"]]})";
std::string const cup = R"({"name": "cup",
    "objects": [{"name": "bowl", "properties": {"cake": {"eater": "handle", "middle": [1, 0]}}},
                {"name": "handle", "at": [1, 0], "part": "spoon"}]})";
std::string const spoon = R"({"name": "spoon", "properties": {"weight": 3, "tag": true}})";

class Composite : public testing::Test {
protected:
    Composite() {
        sample::fill(registry);
        library = sample::parts(registry, {tray, cup, spoon});
    }
    [[nodiscard]] LevelFile level(std::string const& objects, std::string const& more = "") const {
        return sample::read(registry,
                            R"({"version": 2, "title": "t", "objects": [)" + objects + "]" + more + "}");
    }
    [[nodiscard]] BuiltLevel build(LevelFile const& from,
                                   std::vector<Placement> const& placements = {}) const {
        return buildLevel(registry, from, library, placements);
    }
    [[nodiscard]] std::string problemsOf(LevelFile const& from) const {
        try {
            static_cast<void>(build(from));
            return "";
        } catch (InputError const& error) {
            return error.what();
        }
    }
    /// The errors in a library of these parts.
    [[nodiscard]] std::string libraryProblems(std::vector<std::string> const& texts) const {
        try {
            checkComposites(sample::parts(registry, texts));
            return "";
        } catch (InputError const& error) {
            return error.what();
        }
    }

    Registry registry;
    PartLibrary library;
};

template <class P>
P const& valueOf(World const& world, std::string const& name) {
    P const* const value = world.find<P>(world.store().find(name));
    EXPECT_NE(value, nullptr) << name;
    static P const none{};
    return value == nullptr ? none : *value;
}

TEST_F(Composite, BecomesAllItsPiecesWhereItLies) {
    LevelFile const file = level(R"({"name": "my tray", "part": "tray", "at": [10, 0]})");
    BuiltLevel const built = build(file);
    World const& world = *built.world;
    Store const& store = world.store();
    EXPECT_EQ(valueOf<Position>(world, "my tray plate").value, (Vec2{10, 0}));
    Vec2 const bowl = valueOf<Position>(world, "my tray cup bowl").value;
    EXPECT_NEAR(bowl.x, 12, 1e-12);
    EXPECT_NEAR(bowl.y, 1, 1e-12);
    Vec2 const handle = valueOf<Position>(world, "my tray cup handle").value;
    EXPECT_NEAR(handle.x, 12, 1e-12);
    EXPECT_NEAR(handle.y, 0, 1e-12) << "mirrored, then turned to the left";
    EXPECT_EQ(valueOf<sample::Cake>(world, "my tray cup bowl").middle, (Vec2{-1, 0})) << "mirrored";
    EXPECT_EQ(valueOf<sample::Cake>(world, "my tray cup bowl").eater, store.find("my tray cup handle"));
    EXPECT_EQ(valueOf<sample::Knot>(world, "my tray joint 1").a, store.find("my tray cup bowl"));
    EXPECT_EQ(valueOf<sample::Links>(world, "my tray cup handle").to,
              (std::vector<ObjectId>{store.find("my tray plate")}));
    EXPECT_EQ(store.objects().size(), 5U) << "the world, three pieces and a joint";
}

TEST_F(Composite, ItsNameRefersToItsMainPiece) {
    LevelFile const file =
        level(R"({"name": "my tray", "part": "tray"}, {"name": "pin", "properties": {"tag": true}})",
              R"(, "joints": [{"a": "my tray", "b": "my tray cup"}],
                                     "connections": [["pin", "my tray"]])");
    BuiltLevel const built = build(file);
    Store const& store = built.world->store();
    ObjectId const plate = store.find("my tray plate");
    EXPECT_EQ(store.find("my tray"), plate);
    EXPECT_EQ(store.find("my tray cup"), store.find("my tray cup bowl"))
        << "the first piece, as none is named";
    EXPECT_EQ(store.nameOf(plate), "my tray plate");
    EXPECT_EQ(built.objects[0], plate);
    EXPECT_EQ(valueOf<sample::Knot>(*built.world, "joint 1").a, plate);
    EXPECT_EQ(valueOf<sample::Links>(*built.world, "my tray").to.size(), 1U);
}

TEST_F(Composite, AnEntryOverridesPropertiesOfItsPieces) {
    EXPECT_EQ(valueOf<sample::Weight>(*build(level(R"({"name": "t", "part": "tray"})")).world, "t").value, 9)
        << "stated by the part, over its piece";
    LevelFile const file = level(R"({"name": "t", "part": "tray", "properties": {"weight": 4},
        "pieces": {"cup handle": {"weight": 5}, "cup": {"cake": {"eater": "other"}}}}, {"name": "other"})");
    BuiltLevel const built = build(file);
    EXPECT_EQ(valueOf<sample::Weight>(*built.world, "t plate").value, 4);
    EXPECT_EQ(valueOf<sample::Weight>(*built.world, "t cup handle").value, 5);
    EXPECT_EQ(valueOf<sample::Cake>(*built.world, "t cup bowl").eater, built.world->store().find("other"))
        << "names in the level are the level's";
}

TEST_F(Composite, EveryPieceKnowsItsOrigin) {
    LevelFile const file =
        level(R"({"name": "t", "part": "tray"})", R"(, "toolbox": [{"part": "tray", "count": 2}])");
    std::vector<Placement> const placements{{"tray", {5, 0}, 0, ""}, {"tray", {-5, 0}, 0, ""}};
    BuiltLevel const built = build(file, placements);
    Store const& store = built.world->store();
    EXPECT_EQ(store.nameOf(built.placements[0]), "tray 2 plate");
    for (std::size_t i = 0; i < 2; ++i) {
        std::vector<ObjectId> const& pieces = built.placementPieces.at(i);
        ASSERT_EQ(pieces.size(), 4U);
        std::set<std::uint32_t> numbers;
        for (ObjectId const id : pieces) {
            Origin const origin = store.originOf(id);
            EXPECT_EQ(origin.kind, Origin::Kind::placement);
            EXPECT_EQ(origin.number, i);
            EXPECT_EQ(pieces[origin.piece], id);
            EXPECT_EQ(origin.prototype.has_value(), id == built.placements[i])
                << "only the main piece is a tray";
        }
    }
    EXPECT_EQ(store.prototypeOf(built.objects[0])->name, "tray");
}

TEST_F(Composite, NeitherTheOrderInItsFileNorOfPlacingMatters) {
    std::string const other = R"({"name": "tray", "main": "plate", "properties": {"weight": 9},
        "connections": [["cup handle", "plate"]],
        "joints": [{"a": "cup", "b": "plate", "strength": 3}],
        "objects": [{"name": "cup", "part": "cup", "at": [2, 1], "angle_deg": 90, "flipped": true},
                    {"name": "plate", "properties": {"weight": 2, "tag": true}}]})";
    LevelFile const file =
        level(R"({"name": "t", "part": "tray"})", R"(, "toolbox": [{"part": "tray", "count": 3}])");
    Placement const left{"tray", {-5, 0}, 0, ""};
    Placement const right{"tray", {5, 0}, 0, "", true};
    Placement const rightToo{"tray", {5, 0}, 0, ""};
    std::uint64_t const hash = build(file, {left, right, rightToo}).world->stateHash();
    EXPECT_EQ(build(file, {rightToo, right, left}).world->stateHash(), hash);
    library = sample::parts(registry, {spoon, cup, other});
    EXPECT_EQ(build(file, {left, rightToo, right}).world->stateHash(), hash);
}

TEST_F(Composite, ProblemsNameTheFileAndThePlace) {
    EXPECT_SAYS(problemsOf(level(R"({"name": "t", "part": "tray", "pieces": {"cub": {"weight": 5}}})")),
                "/objects/0/pieces/cub: 'tray' has no piece 'cub' (did you mean 'cup'?)");
    EXPECT_SAYS(
        problemsOf(level(R"({"name": "t", "part": "tray", "pieces": {"cup handle": {"weight": 13}}})")),
        "/objects/0/pieces/cup handle/weight: t cup handle: the weight is 13");
    EXPECT_SAYS(problemsOf(level(R"({"name": "t", "part": "tray", "properties": {"weight": 13}})")),
                "/objects/0/properties/weight: t plate: the weight is 13");
    EXPECT_SAYS(problemsOf(level(R"({"name": "t", "part": "spoon", "pieces": {"cup": {"weight": 5}}})")),
                "/objects/0/pieces/cup: 't' has no pieces");
    EXPECT_SAYS(problemsOf(level(R"({"name": "t", "part": "tray"}, {"name": "t plate"})")),
                "the name 't plate' is taken");
    EXPECT_SAYS(
        problemsOf(level(R"({"name": "t", "part": "tray"})", R"(, "connections": [["t", "t knob"]])")),
        "/connections/0: there is no object 't knob'");
    library = sample::parts(
        registry, {R"({"name": "box", "objects": [{"name": "lid", "properties": {"weight": 13}}]})"});
    EXPECT_SAYS(problemsOf(level(R"({"name": "t", "part": "box"})")),
                "part.json:1:70: /objects/0/properties/weight: t lid: the weight is 13");
}

TEST_F(Composite, ALibraryIsCheckedAsAWhole) {
    EXPECT_EQ(libraryProblems({tray, cup, spoon}), "");
    EXPECT_SAYS(libraryProblems({tray, spoon}), "/objects/1/part: there is no part 'cup'");
    std::string const egg = R"({"name": "egg", "objects": [{"name": "hen", "part": "hen"}]})";
    std::string const hen = R"({"name": "hen", "objects": [{"name": "egg", "part": "egg"}]})";
    EXPECT_SAYS(libraryProblems({egg, hen}), "/objects/0/part: the part 'egg' would contain itself");
    EXPECT_SAYS(libraryProblems({R"({"name": "box", "objects": [{"name": "lid"}],
                                     "connections": [["lid", "lit"]]})"}),
                "/connections/0: there is no piece 'lit' (did you mean 'lid'?)");
    EXPECT_SAYS(libraryProblems({R"({"name": "box", "objects": [{"name": "lid"}],
                                     "joints": [{"a": "lit"}]})"}),
                "/joints/0: there is no piece 'lit'");
    std::vector<std::string> nested{R"({"name": "p0", "objects": [{"name": "x"}]})"};
    for (int i = 1; i <= 9; ++i) {
        nested.push_back(R"({"name": "p)" + std::to_string(i) + R"(", "objects": [{"name": "x", "part": "p)" +
                         std::to_string(i - 1) + R"("}]})");
    }
    EXPECT_SAYS(libraryProblems(nested),
                "/objects/0/part: too many parts inside one another; expected at most 8");
    std::string many = R"({"name": "hundred", "objects": [)";
    for (int i = 0; i < 100; ++i) {
        many += (i == 0 ? "" : ",") + std::string(R"({"name": "x)") + std::to_string(i) + R"("})";
    }
    std::string more = R"({"name": "thousands", "objects": [)";
    for (int i = 0; i < 11; ++i) {
        more += (i == 0 ? "" : ",") + std::string(R"({"name": "x)") + std::to_string(i) +
                R"(", "part": "hundred"})";
    }
    EXPECT_SAYS(libraryProblems({many + "]}", more + "]}"}), "the part 'hundred' has too many pieces");
}

TEST_F(Composite, AFileThatIsWrongIsRefused) {
    auto const said = [&](std::string const& text) {
        try {
            static_cast<void>(sample::parts(registry, {text}));
            return std::string();
        } catch (InputError const& error) {
            return std::string(error.what());
        }
    };
    EXPECT_SAYS(said(R"({"name": "a", "objects": []})"), "/objects: is empty; expected at least one piece");
    EXPECT_SAYS(said(R"({"name": "a", "joints": []})"), "/joints: is stated for a part without pieces");
    EXPECT_SAYS(said(R"({"name": "a", "main": "b"})"), "/main: is stated for a part without pieces");
    EXPECT_SAYS(said(R"({"name": "a", "main": "lit", "objects": [{"name": "lid"}]})"),
                "/main: there is no piece 'lit' (did you mean 'lid'?)");
    EXPECT_SAYS(said(R"({"name": "a", "objects": [{"name": "lid"}, {"name": "lid"}]})"),
                "the name 'lid' is taken by /objects/0/name");
    EXPECT_SAYS(said(R"({"name": "a", "objects": [{"name": "lid", "flipped": 1}]})"), "/objects/0/flipped");
}

TEST_F(Composite, PiecesAreKnownBeforeThereIsAWorld) {
    std::vector<PlacedPiece> const pieces = placedPieces(library, {"tray", {1, 0}, 0, "", true});
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_EQ(pieces[0].name, "cup bowl");
    EXPECT_EQ(pieces[2].name, "plate");
    EXPECT_TRUE(pieces[2].main);
    EXPECT_FALSE(pieces[0].main);
    EXPECT_NEAR(pieces[0].properties.find<Position>()->value.x, -1, 1e-12);
    EXPECT_EQ(pieces[0].properties.find<sample::Cake>()->middle, (Vec2{1, 0})) << "mirrored twice";
    EXPECT_EQ(placedPieces(library, {"spoon", {1, 0}, 0, ""}).front().name, "spoon");
    EXPECT_TRUE(placedPieces(library, {"fork", {1, 0}, 0, ""}).empty());
}

TEST_F(Composite, JointsOfAPlacementReferToItsPieces) {
    std::vector<PropertySet> const joints = placedJoints(library, {"tray", {1, 0}, 0, "", true});
    ASSERT_EQ(joints.size(), 1U);
    auto const* const knot = joints[0].find<sample::Knot>();
    ASSERT_NE(knot, nullptr);
    EXPECT_EQ(knot->a.index, 0U) << "the cup is its bowl";
    EXPECT_EQ(knot->b.index, 2U) << "the plate";
    EXPECT_EQ(knot->strength, 3);
    EXPECT_TRUE(placedJoints(library, {"spoon", {1, 0}, 0, ""}).empty());
    EXPECT_TRUE(placedJoints(library, {"fork", {1, 0}, 0, ""}).empty());
}

TEST_F(Composite, LevelsWithThemAreWrittenAsTheyAreRead) {
    LevelFile const file = level(R"({"name": "t", "part": "tray", "flipped": true,
        "pieces": {"cup": {"tag": true, "cake": false}}})");
    std::string const text = levelText(file);
    LevelFile const again = sample::read(registry, text);
    EXPECT_TRUE(again.objects[0].flipped);
    EXPECT_EQ(again.objects[0].pieces.at("cup").entries().size(), 2U);
    EXPECT_EQ(levelText(again), text);
    EXPECT_EQ(build(again).world->stateHash(), build(file).world->stateHash());
}

TEST_F(Composite, AliasesEndWithTheirObject) {
    Store store;
    ObjectId const id = store.create("bell coil");
    EXPECT_TRUE(store.alias("bell", id));
    EXPECT_FALSE(store.alias("bell", id));
    EXPECT_FALSE(store.alias("other", {}));
    EXPECT_EQ(store.find("bell"), id);
    store.destroy({id});
    EXPECT_FALSE(store.find("bell").valid());
}

} // namespace
} // namespace part_expander_test
} // namespace trembler
