#include "lua/binding/vocabulary.hpp"
#include "lua/reference/reference.hpp"
#include "puzzle/data/effects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace trembler::lua {
namespace {

struct Known {
    Known() {
        registerEffects(registry);
        reference = makeReference(registry);
    }
    ReferenceProperty const& property(std::string_view name) const {
        return *std::find_if(reference.properties.begin(), reference.properties.end(),
                             [&](ReferenceProperty const& one) { return one.info->text.name == name; });
    }
    ReferenceFunction const& function(std::string_view name) const {
        return *std::find_if(reference.functions.begin(), reference.functions.end(),
                             [&](ReferenceFunction const& one) { return one.call->text.name == name; });
    }
    Registry registry;
    Reference reference;
};

ReferenceField const& field(std::vector<ReferenceField> const& fields, std::string_view key) {
    return *std::find_if(fields.begin(), fields.end(),
                         [&](ReferenceField const& one) { return one.info.key == key; });
}

TEST(Reference, HasWhateverScriptsCanDeclare) {
    Known const known;
    Vocabulary const vocabulary(known.registry);
    std::set<std::string_view> names;
    for (ReferenceProperty const& property : known.reference.properties) {
        names.insert(property.info->text.name);
        names.insert(property.info->text.key);
    }
    for (std::string const& name : vocabulary.propertyNames()) {
        PropertyInfo const* const info = vocabulary.property(name);
        bool const readable = info->fields != nullptr || info->kind == PropertyKind::object;
        EXPECT_EQ(names.contains(name), readable) << name;
    }
    std::set<std::string_view> functions;
    for (ReferenceFunction const& function : known.reference.functions) {
        functions.insert(function.call->text.name);
    }
    std::size_t count = 0;
    for (std::string const& role : vocabulary.roleNames()) {
        for (CallDescription const& call : vocabulary.role(role)->calls) {
            EXPECT_TRUE(functions.contains(call.text.name)) << call.text.name;
            ++count;
        }
    }
    EXPECT_EQ(known.reference.functions.size(), count);
}

// The fields are found by visiting a value; scripts find them by their places in it.
TEST(Reference, HasTheFieldsThatScriptsRead) {
    Known const known;
    for (ReferenceProperty const& property : known.reference.properties) {
        if (property.info->fields == nullptr) {
            EXPECT_TRUE(property.fields.empty()) << property.info->text.name;
            continue;
        }
        std::vector<FieldPlace> const places = property.info->fields();
        EXPECT_EQ(places.size(), property.fields.size()) << property.info->text.name;
        for (FieldPlace const& place : places) {
            auto const at =
                std::find_if(property.fields.begin(), property.fields.end(),
                             [&](ReferenceField const& one) { return one.info.key == place.info.key; });
            ASSERT_NE(at, property.fields.end()) << property.info->text.name << "." << place.info.key;
            EXPECT_EQ(at->kind, place.kind) << property.info->text.name << "." << place.info.key;
        }
    }
}

TEST(Reference, StatesUnitsRangesAndWhatMayBeLeftOut) {
    Known const known;
    ReferenceField const& mass = field(known.property("Mass").fields, "value");
    EXPECT_EQ(mass.info.unit, "kg");
    EXPECT_EQ(kindText(mass), "number");
    EXPECT_EQ(rangeText(mass), "1e-06 to 1e+09");
    auto const& tellRate = known.function("tellRate").arguments;
    EXPECT_EQ(field(tellRate, "rate").initial, "") << "it is required";
    EXPECT_EQ(field(tellRate, "swings").initial, "true");
    EXPECT_EQ(field(tellRate, "foreseen").initial, "false");
    EXPECT_EQ(rangeText(field(tellRate, "rate")), "0 to 1e+12");
    EXPECT_EQ(field(known.function("createObject").arguments, "velocity").initial, "vec2(0, 0)");
    EXPECT_EQ(kindText(field(known.property("Magnetic poles").fields, "poles")),
              "one of none, north, south, both");
}

TEST(Reference, ListsTheFieldsOfEntriesWhateverTheirForm) {
    Known const known;
    ReferenceField const& pieces = field(known.property("Shape").fields, "value");
    EXPECT_TRUE(pieces.entriesHaveFields);
    std::set<std::string_view> keys;
    for (ReferenceField const& entry : pieces.entry) {
        keys.insert(entry.info.key);
    }
    for (char const* const key : {"form", "radius", "width", "height", "corners", "at"}) {
        EXPECT_TRUE(keys.contains(key)) << key;
    }
}

TEST(Reference, SaysWhereAPropertyIsRead) {
    Known const known;
    EXPECT_EQ(expressionOf(known.property("Mass")), "object.Mass");
    EXPECT_EQ(expressionOf(known.property("Gravity")), "world.Gravity");
    EXPECT_EQ(expressionOf(known.property("Angular Velocity")), "object.angular_velocity_deg");
    EXPECT_EQ(expressionOf(known.property("C_C, C_N, C_P")), "world.contacts");
    EXPECT_EQ(known.property("Frame parts").offeredBy, std::vector<std::string>{"Frame"});
}

} // namespace
} // namespace trembler::lua
