// The cost of a frame in which nothing happens, by component: absent components, which the scene does not
// activate, and components that are asleep because their inputs have not changed. Wall time, medians over
// frames, one thread.
#include "bench/measure.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/world/world.hpp"

#include <array>
#include <utility>

namespace {

using namespace trembler;

constexpr std::size_t ofEachKind = 24;
constexpr std::size_t repetitions = 2001;

struct Trait {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Trait", "trait", "Activates all the components."};
    double value = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "value"}, self.value);
    }
};

// Two letters for every number, so that all components have unique names and keys.
template <std::size_t n>
struct Letters {
    static constexpr std::array<char, 2> characters{static_cast<char>('a' + n / 26),
                                                    static_cast<char>('a' + n % 26)};
    static constexpr std::string_view value{characters.data(), characters.size()};
};

template <std::size_t n>
struct Result {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{Letters<n>::value, Letters<n>::value, "A result."};
};
template <std::size_t n>
struct Role {
    static constexpr std::string_view name = Letters<n>::value;
    using Calls = CallList<>;
};
template <std::size_t n>
struct Simulation final : Resolver<Simulation<n>, Role<n>, Reads<Trait>, Writes<>> {
    static constexpr ComponentText text{
        .name = Letters<n>::value, .effect = "bench", .level = "", .work = "None."};
    using Activation = NeedsAny<Trait>;
    void advance(typename Resolver<Simulation<n>, Role<n>, Reads<Trait>, Writes<>>::Access&) {}
};
template <std::size_t n>
struct Deduction final : Dps<Deduction<n>, Reads<Trait>, Derives<Result<n>>> {
    static constexpr ComponentText text{
        .name = Letters<n>::value, .effect = "bench", .level = "", .work = "None."};
    using Activation = NeedsAny<Trait>;
    void update(typename Dps<Deduction<n>, Reads<Trait>, Derives<Result<n>>>::Access&) {}
};
template <std::size_t n>
struct Glue final : Interaction<Glue<n>, Role<n>, Reads<Result<n>, Trait>> {
    static constexpr ComponentText text{
        .name = Letters<n>::value, .effect = "bench", .level = "", .work = "None."};
    using Activation = NeedsAny<Trait>;
    void apply(typename Interaction<Glue<n>, Role<n>, Reads<Result<n>, Trait>>::Access&) {}
};

Registry const& crowd() {
    static Registry const registry = [] {
        Registry made;
        [&]<std::size_t... n>(std::index_sequence<n...>) {
            (made.component<Simulation<n>>(), ...);
            (made.component<Deduction<n>>(), ...);
            (made.component<Glue<n>>(), ...);
        }
        (std::make_index_sequence<ofEachKind>{});
        return made;
    }();
    return registry;
}
Registry const& emptyRegistry() {
    static Registry const registry;
    return registry;
}

// Median time of a frame, s.
double frameTime(Registry const& registry, bool activation, bool changing) {
    World world(registry);
    auto& traits = world.store().column<Trait>();
    if (activation) {
        traits.set(world.store().create("object"), {});
    }
    world.start();
    world.step();
    bench::Series series;
    for (std::size_t i = 0; i < repetitions; ++i) {
        if (changing) {
            traits.touch();
        }
        series.time([&] { world.step(); });
    }
    return series.median();
}

} // namespace

int main() {
    constexpr double components = 3.0 * ofEachKind;
    double const empty = frameTime(emptyRegistry(), false, false);
    bench::Table table("A frame in which nothing happens, " + std::to_string(3 * ofEachKind) +
                       " components: resolvers, derived property sets and interactions in equal parts");
    table.row("no component at all", 1e9 * empty, "ns per frame");
    table.row("absent", 1e9 * (frameTime(crowd(), false, false) - empty) / components, "ns per component");
    table.row("asleep", 1e9 * (frameTime(crowd(), true, false) - empty) / components, "ns per component");
    table.row("active, with nothing to do", 1e9 * (frameTime(crowd(), true, true) - empty) / components,
              "ns per component");
    table.print();
    return 0;
}
