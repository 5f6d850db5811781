// The smallest world in which every rule of access can be broken: two object properties, a resolver property,
// a derived property and two roles. Each case adds one component; compiled as the control, the component
// obeys the rules.
#pragma once

#include "runtime/component/dps.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/world/registry.hpp"

#include <array>

namespace trembler {

struct Heat {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Heat", "heat", "How warm the object is."};
    double value = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "K", .meaning = "temperature"}, self.value);
    }
};

struct Colour {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Colour", "colour", "What colour the object has."};
    double hue = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "rad", .meaning = "hue"}, self.hue);
    }
};

struct HotSpots {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Hot spots", "hot_spots", "The objects that are hot."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "what is hot";
    std::vector<ObjectId> objects;
};

/// News: a property of events, which are merged in frames of several parts.
struct Sparks {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Sparks", "sparks", "What has just gone off."};
    static constexpr Coverage coverage = hashed;
    std::vector<ObjectId> objects;

    static void gather(Sparks& frame, Sparks const& part, PartSpan) {
        frame.objects.insert(frame.objects.end(), part.objects.begin(), part.objects.end());
    }
};

struct Glow {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Glow", "glow", "How brightly each object glows."};
    std::vector<double> watts;
};

struct Shadow {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Shadow", "shadow", "Where each object's shadow falls."};
    double area = 0;
};

struct AddHeat {
    static constexpr CallText text{"addHeat", "(object, power)", "Heats the object."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    ObjectId object;
    double power = 0; ///< W
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "power", .unit = "W", .meaning = "heat", .required = true}, self.power);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};
struct Paint {
    static constexpr CallText text{"paint", "(object)", "Paints the object."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
};

struct HeatRole {
    static constexpr std::string_view name = "Heat";
    using Calls = CallList<AddHeat>;
};
struct PaintRole {
    static constexpr std::string_view name = "Paint";
    using Calls = CallList<Paint>;
};

/// The name of the cases' completions, and the objects that they complete.
struct Warming {
    static constexpr CompletionText text{.name = "Warmth", .work = "Warms."};
    using Activation = NeedsAll<Colour>;
};
/// A completion that obeys the rules if its reads allow it.
template <class Seen>
struct WarmthAfter final : Warming, Completion<WarmthAfter<Seen>, Seen, Adds<Heat>> {
    static void complete(typename Completion<WarmthAfter<Seen>, Seen, Adds<Heat>>::Access& access) {
        access.add(Heat{});
    }
};

} // namespace trembler
