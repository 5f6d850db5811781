// Commands on the pieces of composite parts, and on lists that are empty.
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/inspect/inspector.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "puzzle/edit/world/edited_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace trembler::edit {
namespace properties_test {
namespace {

/// The small level with two doorbells: "front" and "back".
LevelDocument withBells() {
    LevelDocument document = smallDocument();
    for (auto const& [name, x] : {std::pair{"front", -3.0}, std::pair{"back", 3.0}}) {
        document.run(addObject(document.tree(), {.part = "doorbell", .at = {x, 5}, .name = name}));
    }
    return document;
}

Json const& entryOf(LevelDocument const& document, std::string const& name) {
    return *findObject(document.tree(), name);
}

InspectedProperty const* propertyOf(LevelDocument const& document, std::string const& piece,
                                    std::string const& key) {
    static std::vector<InspectedProperty> all;
    all = inspectObjects(editData(), document.tree(), {"front"}, piece);
    auto const found = std::find_if(all.begin(), all.end(), [&](auto const& one) { return one.key == key; });
    return found == all.end() ? nullptr : &*found;
}

template <class P>
P valueOf(LevelDocument const& document, std::string const& object) {
    EditedWorld world;
    world.build(editData(), document.level(), document.tree());
    P const* const value = world.world()->find<P>(world.world()->store().find(object));
    return value == nullptr ? P{} : *value;
}

TEST(PieceCommands, ChangeWhatFilesStateAboutPieces) {
    LevelDocument document = withBells();
    std::string const before = document.text();
    std::size_t const steps = document.done();
    document.run(setField(editData(), document.tree(), {"front"}, "density", "", 4000, "striker"));
    EXPECT_EQ(document.undoName(), "Change density of piece 'striker' of front");
    EXPECT_EQ(entryOf(document, "front")["pieces"], Json::parse(R"({"striker": {"density": 4000}})"));
    EXPECT_FALSE(entryOf(document, "front").contains("properties"));
    EXPECT_NO_THROW(static_cast<void>(document.level()));
    // Overrides one field of a property of the part: the other fields keep the part's values.
    document.run(
        setField(editData(), document.tree(), {"front", "back"}, "acoustics", "/ringing", 0.5, "striker"));
    EXPECT_EQ(document.undoName(), "Change acoustics of piece 'striker' of 2 objects");
    EXPECT_EQ(entryOf(document, "back")["pieces"]["striker"]["acoustics"]["ringing"], 0.5);
    document.run(removeProperty(editData(), document.tree(), {"front"}, "friction", "striker"));
    EXPECT_EQ(entryOf(document, "front")["pieces"]["striker"]["friction"], false);
    document.run(addProperty(editData(), document.tree(), {"front"}, "magnet", "contact"));
    EXPECT_TRUE(entryOf(document, "front")["pieces"]["contact"].contains("magnet"));
    document.run(resetProperty(editData(), document.tree(), {"front"}, "magnet", "contact"));
    EXPECT_FALSE(entryOf(document, "front")["pieces"].contains("contact")) << "nothing is left of it";
    EXPECT_NO_THROW(static_cast<void>(document.level()));
    document.run(resetPiece(document.tree(), {"front", "back"}, "striker"));
    EXPECT_FALSE(entryOf(document, "front").contains("pieces"));
    document.goTo(steps);
    EXPECT_EQ(document.text(), before);
    document.goTo(std::numeric_limits<std::size_t>::max());
    EXPECT_FALSE(entryOf(document, "back").contains("pieces"));
}

TEST(PieceCommands, ChangeTheWorld) {
    LevelDocument document = withBells();
    EXPECT_FALSE(valueOf<Shape>(document, "front striker").pieces.empty());
    document.run(setField(editData(), document.tree(), {"front"}, "shape", "",
                          Json::parse(R"([{"form": "circle", "radius": 0.2}])"), "striker"));
    EXPECT_EQ(valueOf<Shape>(document, "front striker").pieces.size(), 1U);
    EXPECT_EQ(valueOf<Shape>(document, "back striker").pieces.size(), 2U) << "the other one is as it was";
}

TEST(PieceCommands, RefuseWhatPiecesCannotHave) {
    LevelDocument const document = withBells();
    Json const& tree = document.tree();
    auto const refused = [&](std::string const& name, std::string const& property, Json const& value,
                             std::string const& piece) {
        return refusalOf(
            [&] { static_cast<void>(setField(editData(), tree, {name}, property, "", value, piece)); });
    };
    EXPECT_EQ(refused("front", "density", 1, "clapper"), "'front' has no piece 'clapper'");
    EXPECT_NE(refused("ball", "density", 1, "striker"), "");
    EXPECT_NE(refused("front", "at", Json::array({0, 0}), "striker"), "");
    EXPECT_NE(refusalOf([&] {
                  Json changed = tree;
                  setField(editData(), tree, {"front"}, "density", "", -1, "striker").change(changed);
              }),
              "");
}

TEST(PieceCommands, GoWithTheObject) {
    LevelDocument document = withBells();
    document.run(addConnection(document.tree(), "left", "right"));
    document.run(changeConnection(document.tree(), 0, "left", "front coil", ""));
    document.run(addGoal(document.tree(), "/all/0", newCondition("moved", {"front striker"})));
    document.run(renameObject(editData(), document.tree(), "front", "door"));
    EXPECT_EQ(document.tree()["connections"][0], Json::array({"left", "door coil"}));
    EXPECT_NE(document.tree()["goals"].dump().find("door striker"), std::string::npos);
    EXPECT_EQ(document.tree()["goals"].dump().find("front"), std::string::npos);
    // References in the properties of pieces are renamed, too.
    document.run(
        {"Test", [](Json& tree) {
             for (Json& object : tree["objects"]) {
                 if (object["name"] == "door") {
                     object["pieces"]["striker"]["electric_motor"] = {{"torque", 1}, {"against", "right"}};
                 }
             }
         }});
    document.run(renameObject(editData(), document.tree(), "right", "east"));
    EXPECT_EQ(entryOf(document, "door")["pieces"]["striker"]["electric_motor"]["against"], "east");
    document.run(duplicateObjects(editData(), document.tree(), {"door"}, {1, 0}));
    EXPECT_TRUE(entryOf(document, "door 2")["pieces"].contains("striker"));
}

TEST(PieceCommands, AreInspected) {
    LevelDocument document = withBells();
    auto pieces = inspectPieces(editData(), document.tree(), {"front", "back"});
    ASSERT_EQ(pieces.size(), 8U);
    EXPECT_EQ(pieces.front().name, "backboard");
    EXPECT_TRUE(pieces.front().main);
    EXPECT_TRUE(std::none_of(pieces.begin(), pieces.end(), [](auto const& one) { return one.stated; }));
    EXPECT_TRUE(inspectPieces(editData(), document.tree(), {"front", "ball"}).empty());
    EXPECT_EQ(propertyOf(document, "striker", "at"), nullptr);
    ASSERT_NE(propertyOf(document, "striker", "density"), nullptr);
    EXPECT_EQ(propertyOf(document, "striker", "density")->origin, ValueOrigin::part);
    EXPECT_EQ(propertyOf(document, "striker", "density")->fields.front().value, 7800);
    EXPECT_EQ(propertyOf(document, "coil", "electromagnet")->origin, ValueOrigin::part) << "of its own part";
    // The inspector shows the main piece's properties for the object itself.
    ASSERT_NE(propertyOf(document, "", "material"), nullptr);
    EXPECT_EQ(propertyOf(document, "", "material")->fields.front().value, "wood");
    document.run(setField(editData(), document.tree(), {"front"}, "density", "", 4000, "striker"));
    EXPECT_EQ(propertyOf(document, "striker", "density")->origin, ValueOrigin::changed);
    EXPECT_EQ(propertyOf(document, "", "density"), nullptr);
    pieces = inspectPieces(editData(), document.tree(), {"front"});
    EXPECT_EQ(std::count_if(pieces.begin(), pieces.end(), [](auto const& one) { return one.stated; }), 1);
    auto const addable = addableProperties(editData(), document.tree(), {"front"}, "striker");
    EXPECT_TRUE(
        std::none_of(addable.begin(), addable.end(), [](auto const& one) { return one.key == "density"; }));
    EXPECT_TRUE(
        std::any_of(addable.begin(), addable.end(), [](auto const& one) { return one.key == "magnet"; }));
}

TEST(PieceCommands, OfAnotherPartAreAProblemThatLeadsToThem) {
    LevelDocument document = withBells();
    document.run(setField(editData(), document.tree(), {"front"}, "density", "", 4000, "striker"));
    document.run(setPart(document.tree(), {"front"}, "relay"));
    LiveProblems problems;
    problems.refresh(document);
    auto const found = std::find_if(problems.all().begin(), problems.all().end(),
                                    [](Problem const& one) { return !one.piece.empty(); });
    ASSERT_NE(found, problems.all().end());
    EXPECT_EQ(found->about, Problem::About::object);
    EXPECT_EQ(found->name, "front");
    EXPECT_EQ(found->piece, "striker");
    auto const pieces = inspectPieces(editData(), document.tree(), {"front"});
    EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [](auto const& one) {
        return one.name == "striker";
    })) << "so that it can be reset";
    document.run(resetPiece(document.tree(), {"front"}, "striker"));
    problems.refresh(document);
    EXPECT_TRUE(std::none_of(problems.all().begin(), problems.all().end(),
                             [](Problem const& one) { return !one.piece.empty(); }));
}

TEST(ListCommands, BeginListsThatAreEmpty) {
    LevelDocument document = smallDocument();
    auto const add = [&](std::string const& property, std::string const& list) {
        document.run(addListEntry(editData(), document.tree(), {"left"}, property, list, Json()));
        return entryOf(document, "left")["properties"][property];
    };
    document.run(addProperty(editData(), document.tree(), {"left"}, "acoustics"));
    EXPECT_EQ(add("acoustics", "/partials")["partials"].size(), 1U);
    EXPECT_EQ(add("acoustics", "/partials")["partials"].size(), 2U);
    document.run(addProperty(editData(), document.tree(), {"left"}, "drawing"));
    EXPECT_EQ(add("drawing", "/shapes")["shapes"].size(), 1U);
    document.run(setField(editData(), document.tree(), {"left"}, "drawing", "/shapes/0/form", "polygon"));
    EXPECT_EQ(add("drawing", "/shapes/0/corners")["shapes"][0]["corners"].size(), 1U);
    EXPECT_EQ(add("shape", "").size(), 2U);
    EXPECT_NE(refusalOf([&] { add("shape", "/7/corners"); }), "");
    EXPECT_NE(refusalOf([&] { add("mass", ""); }), "");
}

} // namespace
} // namespace properties_test
} // namespace trembler::edit
