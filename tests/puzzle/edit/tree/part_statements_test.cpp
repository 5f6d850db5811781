// The statements of composite parts about their pieces, compared with the values from which a world is built.
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/property/property_writer.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::edit {
namespace part_statements_test {
namespace {

TEST(PartStatements, AreWhatEachPieceOfEveryPartIsMadeOf) {
    GameData const& data = editData();
    PartStatements statements(data);
    int composites = 0;
    for (PartDefinition const* const part : data.parts.all()) {
        if (!part->composite()) {
            EXPECT_TRUE(statements.pieces(part->name).empty()) << part->name;
            continue;
        }
        ++composites;
        LevelObject entry;
        entry.name = "thing";
        entry.part = part->name;
        NameTable const names;
        StatementScope const scope{&names, "", nullptr};
        PartExpander expander(data.parts, [](auto const&...) {});
        ExpandedEntry const made = expander.expand(entry, scope);
        std::size_t count = 0;
        for (std::size_t i = 0; i < made.objects.size(); ++i) {
            MadeObject const& object = made.objects[i];
            if (object.joint) {
                continue;
            }
            std::string const name = object.name.substr(entry.name.size() + 1);
            ASSERT_LT(count, statements.pieces(part->name).size());
            PartPiece const& piece = statements.pieces(part->name)[count++];
            EXPECT_EQ(piece.name, name);
            EXPECT_EQ(piece.main, i == made.main);
            // A piece that the part neither moves nor mirrors has its properties as stated.
            PropertySet const all = object.properties();
            for (PropertyInfo const* const info : data.registry.objectProperties()) {
                if (info->text.place != PropertyPlace::properties) {
                    continue;
                }
                Json const stated = statements.of(part->name, name, *info);
                EXPECT_EQ(stated.is_null(), all.find(*info) == nullptr) << part->name << " " << name;
                if (piece.main) {
                    EXPECT_EQ(statements.of(part->name, "", *info), stated) << part->name;
                }
            }
        }
        EXPECT_EQ(count, statements.pieces(part->name).size()) << part->name;
    }
    EXPECT_GT(composites, 20);
}

TEST(PartStatements, KnowWhatNamesMean) {
    PartStatements statements(editData());
    EXPECT_EQ(statements.pieceNamed("doorbell", "striker"), "striker");
    EXPECT_EQ(statements.pieceNamed("doorbell", "pivot"), "") << "a joint";
    EXPECT_EQ(statements.pieceNamed("doorbell", ""), "");
    EXPECT_EQ(statements.pieceNamed("steel ball", "striker"), "");
    EXPECT_EQ(statements.pieceNamed("unheard", "striker"), "");
    auto const& inside = statements.namesInside("doorbell");
    EXPECT_NE(std::find(inside.begin(), inside.end(), "pivot"), inside.end());
    EXPECT_NE(std::find(inside.begin(), inside.end(), "coil"), inside.end());
}

TEST(PartStatements, GiveTheNamesThatALevelMayUse) {
    Json level = Json::parse(smallLevel());
    addObject(level, {.part = "doorbell", .at = {0, 5}, .name = "front"}).change(level);
    std::vector<std::string> const names = namesOfObjectsAndPieces(editData(), level);
    for (char const* const name : {"table", "ball", "front", "front striker", "front coil"}) {
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    }
    EXPECT_EQ(std::count(names.begin(), names.end(), "front pivot"), 0);
}

} // namespace
} // namespace part_statements_test
} // namespace trembler::edit
