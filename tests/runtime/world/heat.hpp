// A small made-up effect for tests of the world: objects have heat and fuel, burn, glow, and are struck. Not
// real physics, but all four kinds of components, every kind of call and two detail levels.
#pragma once

#include "runtime/component/dps.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/registry.hpp"
#include "runtime/world/world.hpp"

#include <array>

namespace trembler::heat {

struct Heat {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Heat", "heat", "How hot the object is."};
    double value = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "J", .meaning = "heat"}, self.value);
    }
};

struct Fuel {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Fuel", "fuel", "How fast the object burns."};
    double rate = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "W", .meaning = "rate"}, self.rate);
    }
};

/// The stove's inputs in its last advance.
struct StoveLog {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Stove log", "stove_log", "What was asked of the stove."};
    static constexpr Coverage coverage =
        leftOut("a log for tests: it counts turns, which may be had although nothing has changed");
    static constexpr std::string_view standing = "counts over all parts";
    int advances = 0;
    double duration = 0;
    int held = 0; ///< calls
    int once = 0; ///< calls
    int onceEver = 0;
};

/// The sum of all heat at the last update, and the component that computed it.
struct Glow {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Glow", "glow", "How brightly everything glows."};
    double total = 0;
    int updatesByExact = 0;
    int updatesByRough = 0;
};

struct AddHeat {
    static constexpr CallText text{"addHeat", "(object, power)",
                                   "Heats the object for as long as it is held."};
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
struct Strike {
    static constexpr CallText text{"strike", "(object, energy)", "Heats the object once."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    double energy = 0; ///< J
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "energy", .unit = "J", .meaning = "heat", .required = true}, self.energy);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};

struct HeatRole {
    static constexpr std::string_view name = "Heat";
    using Calls = CallList<AddHeat, Strike>;
};

/// Carries out the calls. Not restless: it runs only when calls or heat have changed; Furnace is restless.
struct Stove final : Resolver<Stove, HeatRole, Reads<>, Writes<Heat>, Provides<StoveLog>> {
    static constexpr ComponentText text{
        .name = "Stove", .effect = "heat", .level = "stove", .work = "Heats."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) { carryOut(access); }

    template <class Access>
    static void carryOut(Access& access) {
        StoveLog& log = access.template provide<StoveLog>();
        ++log.advances;
        log.duration = access.duration();
        log.held = 0;
        log.once = 0;
        auto& column = access.template write<Heat>();
        access.template forCalls<AddHeat>([&](AddHeat const& call, CallOrigin) {
            ++log.held;
            if (Heat* const heat = column.find(call.object)) {
                heat->value += call.power * access.duration();
            }
        });
        access.template forCalls<Strike>([&](Strike const& call, CallOrigin origin) {
            ++log.once;
            ++log.onceEver;
            if (Heat* const heat = column.find(call.object)) {
                heat->value += call.energy;
                access.event("struck", {call.object}, {origin.cause});
            }
        });
    }
};
/// The same, but burns in every frame.
struct Furnace final : Resolver<Furnace, HeatRole, Reads<>, Writes<Heat>, Provides<StoveLog>> {
    static constexpr ComponentText text{
        .name = "Furnace", .effect = "heat", .level = "furnace", .work = "Heats all the time.", .rank = 1};
    using Activation = NeedsAny<Heat>;
    [[nodiscard]] bool restless() const { return true; }
    void advance(Access& access) { Stove::carryOut(access); }
};

template <class Access>
double totalHeat(Access const& access) {
    double sum = 0;
    forEach([&](ObjectId, Heat const& heat) { sum += heat.value; }, access.template read<Heat>());
    return sum;
}
struct ExactGlow final : Dps<ExactGlow, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{
        .name = "Exact Glow", .effect = "glow", .level = "exact", .work = "Adds up all heat.", .rank = 2};
    using Activation = NeedsAny<Heat>;
    void update(Access& access) {
        Glow& glow = access.derive<Glow>();
        glow.total = totalHeat(access);
        ++glow.updatesByExact;
    }
};
/// Suits scenes with at most two hot objects, for which it is the cheaper level.
struct RoughGlow final : Dps<RoughGlow, Reads<Heat>, Derives<Glow>> {
    static constexpr ComponentText text{.name = "Rough Glow",
                                        .effect = "glow",
                                        .level = "rough",
                                        .work = "Adds up all heat, roughly.",
                                        .rank = 1};
    using Activation = NeedsAny<Heat>;
    static bool suits(Store const& store) {
        auto const* const heat = store.findColumn<Heat>();
        return heat != nullptr && heat->size() <= 2;
    }
    void update(Access& access) {
        Glow& glow = access.derive<Glow>();
        glow.total = totalHeat(access);
        ++glow.updatesByRough;
    }
};

/// Objects with fuel heat themselves: held calls from inputs that hardly ever change.
struct HeatFromFuel final : Interaction<HeatFromFuel, HeatRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Heat <- Fuel", .effect = "heat", .level = "", .work = "Burns."};
    using Activation = NeedsAll<Fuel, Heat>;
    void apply(Access& access) {
        auto const& fuel = access.read<Fuel>();
        access.forChunks(fuel.size(), [&](Caller& caller, std::size_t begin, std::size_t end) {
            forEachInRows(
                begin, end,
                [&](ObjectId id, Fuel const& f) {
                    caller.call(AddHeat{id, f.rate});
                },
                fuel);
        });
    }
};
/// Strikes every hot object once whenever the glow was computed again.
struct HeatFromGlow final : Interaction<HeatFromGlow, HeatRole, Reads<Glow, Heat>> {
    static constexpr ComponentText text{
        .name = "Heat <- Glow", .effect = "heat", .level = "", .work = "Strikes."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
        forEach([&](ObjectId id, Heat const&) { access.call(Strike{id, 1}); }, access.read<Heat>());
    }
};

inline ComponentStatus statusOf(World const& world, std::string_view name) {
    for (ComponentStatus const& status : world.status()) {
        if (status.info->text.name == name) {
            return status;
        }
    }
    return {};
}

} // namespace trembler::heat
