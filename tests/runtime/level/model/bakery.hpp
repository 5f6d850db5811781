// A small made-up effect whose accuracy can be changed while a world runs: an oven with settings, two detail
// levels that differ in their physics where there is a soufflé, and one that cannot be constructed.
#pragma once

#include "runtime/component/dps.hpp"
#include "runtime/level/model/recorded_change.hpp"
#include "runtime/world/registry.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <utility>

namespace trembler::bakery {

struct Dough {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Dough", "dough", "Can be baked."};
    double weight = 1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "kg", .meaning = "weight"}, self.weight);
    }
};

struct Souffle {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Soufflé", "souffle", "Only exact baking computes how it rises."};
};

/// A number of each kind, and a field that is no number.
struct Oven {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Oven", "oven", "The oven of the world.", PropertyPlace::world};
    std::int32_t layers = 0;
    double tolerance = 0.5; // K
    double heat = 200;      // K
    bool fan = false;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "layers",
                        .unit = "",
                        .meaning = "accuracy, whole, or automatic",
                        .minimum = 0,
                        .maximum = 64,
                        .accuracy = {1, 16, true}},
              self.layers);
        visit(FieldInfo{.key = "tolerance",
                        .unit = "K",
                        .meaning = "accuracy, above zero",
                        .minimum = 0,
                        .maximum = 10,
                        .minimumExcluded = true,
                        .accuracy = {0, 1}},
              self.tolerance);
        visit(FieldInfo{.key = "heat", .unit = "K", .meaning = "physics", .minimum = 0, .maximum = 500},
              self.heat);
        visit(FieldInfo{.key = "fan", .unit = "", .meaning = "physics"}, self.fan);
    }
};

struct Browning {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Browning", "browning", "How many objects are baked."};
    double total = 0;
};
struct Minutes {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Minutes", "minutes", "How many objects are timed."};
    double total = 0;
};

template <class Access>
double countOf(Access const& access) {
    return static_cast<double>(access.template read<Dough>().size());
}

/// May run in every second, third or fourth frame.
struct ExactBaking final : Dps<ExactBaking, Reads<Dough>, Derives<Browning>> {
    static constexpr ComponentText text{
        .name = "Exact Baking", .effect = "baking", .level = "exact", .work = "Bakes.", .rank = 2};
    static constexpr int longestPeriod = 4;
    using Activation = NeedsAny<Dough>;
    void update(Access& access) { access.derive<Browning>().total = countOf(access); }
};
/// Computes the same physics unless there is a soufflé.
struct RoughBaking final : Dps<RoughBaking, Reads<Dough>, Derives<Browning>> {
    static constexpr ComponentText text{
        .name = "Rough Baking", .effect = "baking", .level = "rough", .work = "Bakes.", .rank = 1};
    using Activation = NeedsAny<Dough>;
    static bool faithful(Store const& store) {
        auto const* const souffles = store.findColumn<Souffle>();
        return souffles == nullptr || souffles->size() == 0;
    }
    static bool suits(Store const& store) { return faithful(store); }
    void update(Access& access) { access.derive<Browning>().total = countOf(access); }
};
struct LaboratoryBaking final : Dps<LaboratoryBaking, Reads<Dough>, Derives<Browning>> {
    static constexpr ComponentText text{
        .name = "Laboratory Baking", .effect = "baking", .level = "laboratory", .work = "Bakes.", .rank = 3};
    static constexpr std::string_view missing = "there is no laboratory";
    using Activation = NeedsAny<Dough>;
    void update(Access& access) { access.derive<Browning>().total = countOf(access); }
};
/// Runs in every third frame; no other period is permitted.
struct Timer final : Dps<Timer, Reads<Dough>, Derives<Minutes>> {
    static constexpr ComponentText text{.name = "Timer", .effect = "timer", .level = "", .work = "Counts."};
    static constexpr int period = 3;
    using Activation = NeedsAny<Dough>;
    void update(Access& access) { access.derive<Minutes>().total = countOf(access); }
};

[[nodiscard]] inline Registry const& bakeryRegistry() {
    static Registry const shared = [] {
        Registry made;
        made.property<Souffle>();
        made.property<Oven>();
        made.component<ExactBaking>();
        made.component<RoughBaking>();
        made.component<LaboratoryBaking>();
        made.component<Timer>();
        return made;
    }();
    return shared;
}

/// A running world with the oven's default settings and one object.
struct Bakery {
    World world;
    ObjectId owner; ///< of the oven

    explicit Bakery(WorldOptions options = {}, bool souffle = false)
        : world(bakeryRegistry(), std::move(options)), owner(world.store().create("world")) {
        ObjectId const cake = world.store().create("cake");
        world.store().column<Oven>().set(owner, {});
        world.store().column<Dough>().set(cake, {});
        if (souffle) {
            world.store().column<Souffle>().set(cake, {});
        }
        world.start();
        world.step();
    }
};

[[nodiscard]] inline RecordedChange settingTo(std::string subject, std::string field, double value) {
    RecordedChange change;
    change.kind = RecordedChange::Kind::setting;
    change.subject = std::move(subject);
    change.field = std::move(field);
    change.value = value;
    return change;
}
[[nodiscard]] inline RecordedChange periodTo(std::string subject, double value) {
    RecordedChange change;
    change.kind = RecordedChange::Kind::period;
    change.subject = std::move(subject);
    change.value = value;
    return change;
}
[[nodiscard]] inline RecordedChange detailTo(std::string subject, std::string level) {
    RecordedChange change;
    change.kind = RecordedChange::Kind::detail;
    change.subject = std::move(subject);
    change.level = std::move(level);
    return change;
}

} // namespace trembler::bakery
