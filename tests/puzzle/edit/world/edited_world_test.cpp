#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/edit/world/edited_world.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace trembler::edit {
namespace edited_world_test {
namespace {

/// Two carts, named so that the name of a wheel of the first begins with the name of the second, and a ball
/// whose name begins with that of a cart.
char const* const carts = R"({"version": 2, "title": "Carts", "objects": [
    {"name": "a left", "part": "cart", "at": [2, 1]},
    {"name": "a", "part": "cart", "at": [-2, 1]},
    {"name": "a ball", "part": "rubber ball", "at": [0, 3]}],
    "joints": [{"name": "a hinge", "form": "hinge", "a": "a bed", "at": [-2, 1]}]})";

LevelDocument documentOf(char const* text) {
    auto const file = testFolder() / "carts.json";
    writeText(file, text);
    return LevelDocument::open(editData(), file);
}

TEST(EditedWorld, KnowsEntriesByOriginsWhateverTheirNames) {
    LevelDocument const document = documentOf(carts);
    EditedWorld world;
    world.build(editData(), document.level(), document.tree());
    ASSERT_EQ(world.leftOut(), 0U);
    Store const& store = std::as_const(*world.world()).store();
    auto const entryOf = [&](char const* object) { return world.entryOf(store.find(object)); };
    EXPECT_EQ(entryOf("a left wheel"), "a") << "the left wheel of a, not the wheel of a left";
    EXPECT_EQ(entryOf("a right wheel"), "a");
    EXPECT_EQ(entryOf("a bed"), "a");
    EXPECT_EQ(entryOf("a left left wheel"), "a left");
    EXPECT_EQ(entryOf("a left bed"), "a left");
    EXPECT_EQ(entryOf("a ball"), "a ball");
    EXPECT_EQ(entryOf("a hinge"), "") << "a joint is no object's piece";
    EXPECT_EQ(entryOf("a left axle"), "") << "nor is a joint of a part";
    EXPECT_EQ(entryOf("world"), "");
    EXPECT_EQ(world.entryOf(ObjectId{}), "");
    EXPECT_EQ(EditedWorld().entryOf(store.find("a bed")), "") << "without a world";
}

TEST(EditedWorld, NumbersPiecesAsTheirPartDoes) {
    LevelDocument const document = documentOf(carts);
    EditedWorld world;
    world.build(editData(), document.level(), document.tree());
    Store const& store = std::as_const(*world.world()).store();
    PartStatements parts(editData());
    std::vector<PartPiece> const& pieces = parts.pieces("cart");
    for (char const* const entry : {"a", "a left"}) {
        std::vector<std::string> found;
        for (ObjectId const object : world.objectsOf(entry)) {
            PartPiece const& piece = pieces.at(world.pieceOf(object));
            EXPECT_EQ(store.nameOf(object), std::string(entry) + " " + piece.name);
            EXPECT_EQ(world.entryOf(object), entry);
            found.push_back(piece.name);
        }
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, (std::vector<std::string>{"bed", "left wheel", "right wheel"})) << entry;
    }
}

} // namespace
} // namespace edited_world_test
} // namespace trembler::edit
