// Test properties, one for every kind of field: the level reader must not depend on their meaning.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/registry.hpp"

#include <array>
#include <string>

/// Expects that a text contains another.
#define EXPECT_SAYS(text, part) EXPECT_PRED_FORMAT2(testing::IsSubstring, part, text)

namespace trembler {

enum class Flavour : int { sweet, sour, bitter };
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<Flavour>{"sweet", "sour", "bitter"};

namespace sample {

struct Weight {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Weight", "weight", "How heavy it is."};
    double value = 1;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "kg",
                        .meaning = "all of it",
                        .minimum = 0,
                        .maximum = 100,
                        .minimumExcluded = true},
              self.value);
    }
};

struct Tag {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Tag", "tag", "Says nothing but that it is there."};
};

struct Topping {
    Flavour flavour = Flavour::sour;
    std::int32_t count = 3;
    double turn = 0.5; // rad
    std::vector<Vec2> spots;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "flavour", .unit = "", .meaning = "its taste", .required = true},
              self.flavour);
        visit(FieldInfo{.key = "count", .unit = "", .meaning = "how many", .minimum = 0, .maximum = 10},
              self.count);
        visit(FieldInfo{.key = "turn_deg",
                        .unit = "rad",
                        .meaning = "turned",
                        .minimum = -10,
                        .maximum = 10,
                        .geometry = FieldGeometry::turning},
              self.turn);
        visit(FieldInfo{.key = "spots",
                        .unit = "m",
                        .meaning = "where",
                        .minimum = -5,
                        .maximum = 5,
                        .geometry = FieldGeometry::ownOutline},
              self.spots);
    }
};

struct Cake {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Cake", "cake", "A bit of everything."};
    Flavour flavour = Flavour::sweet;
    bool burnt = false;
    std::string note = "plain";
    Vec2 middle{1, 2};
    double tilt = 0; // rad if sour, else m
    ObjectId eater;
    std::vector<Topping> toppings;
    std::vector<ObjectId> guests;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "flavour", .unit = "", .meaning = "its taste"}, self.flavour);
        visit(FieldInfo{.key = "burnt", .unit = "", .meaning = "too long in the oven"}, self.burnt);
        visit(FieldInfo{.key = "note", .unit = "", .meaning = "on its box"}, self.note);
        visit(FieldInfo{.key = "middle",
                        .unit = "m",
                        .meaning = "its centre",
                        .minimum = -10,
                        .maximum = 10,
                        .geometry = FieldGeometry::ownVector},
              self.middle);
        bool const turns = self.flavour == Flavour::sour; // fields may depend on a choice
        visit(FieldInfo{.key = turns ? "tilt_deg" : "shift",
                        .unit = turns ? "rad" : "m",
                        .meaning = "oddly",
                        .minimum = -100,
                        .maximum = 100},
              self.tilt);
        visit(FieldInfo{.key = "eater", .unit = "", .meaning = "whose it is"}, self.eater);
        visit(FieldInfo{.key = "toppings", .unit = "", .meaning = "on top"}, self.toppings);
        visit(FieldInfo{.key = "guests", .unit = "", .meaning = "who else comes"}, self.guests);
    }
};

struct Climate {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Climate", "climate", "Of the whole world.", PropertyPlace::world};
    Vec2 wind;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "m/s", .meaning = "wind", .minimum = -50, .maximum = 50},
              self.wind);
    }
};

/// Joins objects: a property with the key "joint" is stated in the list of joints.
struct Knot {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Knot", "joint", "Ties two objects together."};
    ObjectId a;
    ObjectId b;
    double strength = 1;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "one end", .required = true}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "other end"}, self.b);
        visit(FieldInfo{.key = "strength", .unit = "N", .meaning = "at most", .minimum = 0, .maximum = 1e3},
              self.strength);
    }
};

/// The connections of an object, in the order in which they were made.
struct Links {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Links", "links", "Whom it is connected to.", PropertyPlace::hidden};
    std::vector<ObjectId> to;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "to", .unit = "", .meaning = "others"}, self.to);
    }
};

/// The runtime's own properties and those above, one rule and a connector.
void fill(Registry& registry);

[[nodiscard]] LevelFile read(Registry const& registry, std::string text);
[[nodiscard]] PartLibrary parts(Registry const& registry, std::vector<std::string> const& texts);
/// All problems of a level text, printed; empty if there are none.
[[nodiscard]] std::vector<std::string> problemsOf(Registry const& registry, std::string text);

/// The one problem, or all of them in one text if there is not exactly one.
[[nodiscard]] std::string only(std::vector<std::string> const& problems);

} // namespace sample
} // namespace trembler
