// Properties for tests: one of plain numbers, one with padding, one with every kind of field.
#pragma once

#include "runtime/property/column.hpp"

#include <array>
#include <string>
#include <vector>

namespace trembler::sample {

struct Place {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Place", "place", "Where it is."};
    Vec2 value;

    friend bool operator==(Place const&, Place const&) = default;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "m", .meaning = "place"}, self.value);
    }
};

struct Speed {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Speed", "speed", "How it moves."};
    Vec2 value;

    friend bool operator==(Speed const&, Speed const&) = default;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "m/s", .meaning = "speed"}, self.value);
    }
};

/// Three bytes of padding after `on` and four at the end.
struct Padded {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Padded", "padded", "Has holes."};
    bool on = false;
    std::int32_t number = 0;
    double weight = 0;
    std::int32_t last = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "on", .unit = "", .meaning = "on"}, self.on);
        visit(FieldInfo{.key = "number", .unit = "", .meaning = "number"}, self.number);
        visit(FieldInfo{.key = "weight", .unit = "kg", .meaning = "weight"}, self.weight);
        visit(FieldInfo{.key = "last", .unit = "", .meaning = "last"}, self.last);
    }
};

enum class Mood : int { calm, cross, glad };

struct Part {
    double size = 1;
    Mood mood = Mood::calm;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "size", .unit = "m", .meaning = "size", .minimum = 0, .maximum = 9},
              self.size);
        visit(FieldInfo{.key = "mood", .unit = "", .meaning = "mood"}, self.mood);
    }
};

struct Everything {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Everything", "everything", "One field of every kind."};
    bool flag = false;
    std::int32_t count = 0;
    double ratio = 0;
    Vec2 point;
    std::string label;
    ObjectId other;
    Mood mood = Mood::calm;
    std::vector<double> numbers;
    std::vector<std::string> words;
    std::vector<Part> parts;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "flag", .unit = "", .meaning = "flag"}, self.flag);
        visit(FieldInfo{.key = "count", .unit = "", .meaning = "count", .minimum = 0, .maximum = 7},
              self.count);
        visit(FieldInfo{.key = "ratio", .unit = "", .meaning = "ratio"}, self.ratio);
        visit(FieldInfo{.key = "point", .unit = "m", .meaning = "point", .required = true}, self.point);
        visit(FieldInfo{.key = "label", .unit = "", .meaning = "label"}, self.label);
        visit(FieldInfo{.key = "other", .unit = "", .meaning = "other"}, self.other);
        visit(FieldInfo{.key = "mood", .unit = "", .meaning = "mood"}, self.mood);
        visit(FieldInfo{.key = "numbers", .unit = "s", .meaning = "numbers", .minimum = -5, .maximum = 5},
              self.numbers);
        visit(FieldInfo{.key = "words", .unit = "", .meaning = "words"}, self.words);
        visit(FieldInfo{.key = "parts", .unit = "", .meaning = "parts"}, self.parts);
    }
};

/// A property without objects: it is stored in a slot.
struct Kept {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Kept", "kept", "What a resolver keeps."};
    static constexpr Coverage coverage = hashed;
    int number = 3;
};

} // namespace trembler::sample

template <>
inline constexpr std::array<std::string_view, 3> trembler::choiceNames<trembler::sample::Mood>{
    "calm", "cross", "glad"};
template <>
inline constexpr bool trembler::hashableAsBytes<trembler::sample::Place> = true;
