#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/material.hpp"
#include "runtime/level/build/check_composites.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/placement.hpp"
#include "tests/levels/level_kit.hpp"

#include <gtest/gtest.h>

#include <set>

namespace trembler {
namespace {

TEST(Parts, HaveTextsForPlayersAndABody) {
    ASSERT_GE(levelKit().parts.all().size(), 60U);
    std::set<std::string> titles;
    for (PartDefinition const* part : levelKit().parts.all()) {
        EXPECT_FALSE(part->text.empty()) << part->name;
        EXPECT_TRUE(titles.insert(part->title).second) << part->title;
        std::vector<PlacedPiece> const pieces = placedPieces(levelKit().parts, {part->name, {}, 0, ""});
        EXPECT_FALSE(pieces.empty()) << part->name;
        for (PlacedPiece const& piece : pieces) {
            if (piece.main || piece.properties.find<Shape>() != nullptr) {
                EXPECT_NE(piece.properties.find<Shape>(), nullptr) << part->name;
                EXPECT_NE(piece.properties.find<MadeOf>(), nullptr) << part->name << ", " << piece.name;
            }
        }
    }
}

TEST(Parts, ThatAreCompositesHaveAllTheirPieces) {
    EXPECT_NO_THROW(checkComposites(levelKit().parts));
}

// The kinds of parts that players and designers may expect, and balls of seven materials.
TEST(Parts, AreThereForEveryEffect) {
    for (char const* const name : {"iron weight",
                                   "plank",
                                   "ramp",
                                   "domino",
                                   "seesaw",
                                   "hinge",
                                   "spring",
                                   "trampoline",
                                   "rope",
                                   "chain",
                                   "pulley",
                                   "bucket",
                                   "crate",
                                   "door",
                                   "latch",
                                   "small cog",
                                   "small wooden cog",
                                   "belt",
                                   "wheel",
                                   "cart",
                                   "truck",
                                   "bar magnet",
                                   "horseshoe magnet",
                                   "electromagnet",
                                   "compass",
                                   "battery",
                                   "mains",
                                   "wire",
                                   "plug",
                                   "socket",
                                   "push switch",
                                   "toggle",
                                   "pressure plate",
                                   "relay",
                                   "fuse",
                                   "lamp",
                                   "motor",
                                   "generator",
                                   "bell",
                                   "doorbell",
                                   "sound sensor",
                                   "metronome",
                                   "water tank",
                                   "float",
                                   "raft",
                                   "cork",
                                   "balloon"}) {
        EXPECT_NE(levelKit().parts.find(name), nullptr) << name;
    }
    std::set<Material> ofBalls;
    for (PartDefinition const* part : levelKit().parts.all()) {
        if (part->name.ends_with(" ball") && !part->composite()) {
            ofBalls.insert(part->properties.find<MadeOf>()->material);
        }
    }
    EXPECT_GE(ofBalls.size(), 7U);
}

TEST(Parts, AreAllValidTogetherInOneWorld) {
    std::string objects;
    int place = 0;
    for (PartDefinition const* part : levelKit().parts.all()) {
        objects += (objects.empty() ? "" : ", ") + std::string("{\"name\": \"my ") + part->name +
                   "\", \"part\": \"" + part->name + "\", \"at\": [" + std::to_string(5 * place++) + ", 0]}";
    }
    LevelFile const level =
        readLevel(levelKit().registry,
                  JsonDocument::parse("{\"version\": 1, \"title\": \"t\", \"objects\": [" + objects + "]}",
                                      "parts.json"));
    auto const world = buildWorld(levelKit().registry, level, levelKit().parts);
    for (int frame = 0; frame < 60; ++frame) {
        world->step();
    }
    for (PartDefinition const* part : levelKit().parts.all()) {
        Position const* const position = world->find<Position>(world->store().find("my " + part->name));
        ASSERT_NE(position, nullptr);
        EXPECT_TRUE(isFinite(position->value)) << part->name;
    }
}

TEST(Parts, ConductAndAttractAsTheirMaterialDoes) {
    for (PartDefinition const* part : levelKit().parts.all()) {
        if (part->composite()) {
            continue; // its pieces may differ
        }
        Material const material = part->properties.find<MadeOf>()->material;
        bool const conducts = part->properties.find<Conductor>() != nullptr;
        bool const isMetal = material == Material::steel || material == Material::iron ||
                             material == Material::copper || material == Material::gold;
        bool const device = part->properties.find<ElectricalDevice>() != nullptr;
        EXPECT_EQ(conducts, isMetal || device) << part->name;
        auto const* const magnetic = part->properties.find<MagneticStrength>();
        if (magnetic != nullptr && magnetic->susceptibility > 0) {
            EXPECT_TRUE(material == Material::steel || material == Material::iron) << part->name;
        }
    }
}

} // namespace
} // namespace trembler
