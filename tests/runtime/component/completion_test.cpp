// Completions: declared, ordered by their declarations, and never overwriting stated properties.
#include "runtime/component/completion.hpp"
#include "runtime/notation/notation.hpp"
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

using namespace heat;

constexpr std::array<std::string_view, 4> stageNames{"Stage 0", "Stage 1", "Stage 2", "Stage 3"};
constexpr std::array<std::string_view, 4> stageKeys{"stage_0", "stage_1", "stage_2", "stage_3"};

template <std::size_t n>
struct Stage {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{stageNames[n], stageKeys[n], "For tests."};
    double value = 0;
    ObjectId other;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "a number"}, self.value);
        visit(FieldInfo{.key = "other", .unit = "", .meaning = "another object"}, self.other);
    }
};

// Every object with stage n-1 gets stage n, whose value is greater by one.
template <std::size_t n>
struct NextStage final : Completion<NextStage<n>, Reads<Stage<n - 1>>, Adds<Stage<n>>> {
    using Base = Completion<NextStage, Reads<Stage<n - 1>>, Adds<Stage<n>>>;
    static constexpr CompletionText text{.name = stageNames[n], .work = "One more."};
    using Activation = NeedsAll<Stage<n - 1>>;
    static void complete(typename Base::Access& access) {
        auto const* const before = access.template find<Stage<n - 1>>();
        access.add(Stage<n>{before->value + 1, {}});
    }
};

TEST(Completions, StatedPropertiesAreKept) {
    Registry registry;
    registry.completion<NextStage<1>>();
    World world(registry);
    ObjectId const plain = world.store().create("plain");
    ObjectId const stated = world.store().create("stated");
    for (ObjectId const id : {plain, stated}) {
        world.store().column<Stage<0>>().set(id, {5, {}});
    }
    world.store().column<Stage<1>>().set(stated, {-1, {}});
    world.start();
    EXPECT_EQ(world.find<Stage<1>>(plain)->value, 6);
    EXPECT_EQ(world.find<Stage<1>>(stated)->value, -1);
}

TEST(Completions, RunInTheOrderOfTheirReadsInAnyOrderOfRegistration) {
    Registry forwards;
    forwards.completion<NextStage<1>>();
    forwards.completion<NextStage<2>>();
    forwards.completion<NextStage<3>>();
    Registry backwards;
    backwards.completion<NextStage<3>>();
    backwards.completion<NextStage<2>>();
    backwards.completion<NextStage<1>>();
    for (Registry const* registry : {&forwards, &backwards}) {
        World world(*registry);
        ObjectId const id = world.store().create("thing");
        world.store().column<Stage<0>>().set(id, {});
        world.start();
        ASSERT_NE(world.find<Stage<3>>(id), nullptr);
        EXPECT_EQ(world.find<Stage<3>>(id)->value, 3);
    }
}

// Reads the stage 1 of another object, which is also added by completion.
struct Companion final : Completion<Companion, Reads<Stage<0>, Stage<1>>, Adds<Stage<2>>> {
    static constexpr CompletionText text{.name = "Companion", .work = "The other one's stage."};
    using Activation = NeedsAll<Stage<0>>;
    static void complete(Access& access) {
        auto const* const theirs = access.find<Stage<1>>(access.find<Stage<0>>()->other);
        access.add(Stage<2>{theirs == nullptr ? -1 : theirs->value, {}});
    }
};

TEST(Completions, DoNotDependOnTheOrderOfObjects) {
    Registry registry;
    registry.completion<Companion>();
    registry.completion<NextStage<1>>();
    World world(registry);
    ObjectId const first = world.store().create("first");
    ObjectId const second = world.store().create("second");
    world.store().column<Stage<0>>().set(first, {10, second});
    world.store().column<Stage<0>>().set(second, {20, first});
    world.start();
    EXPECT_EQ(world.find<Stage<2>>(first)->value, 21);
    EXPECT_EQ(world.find<Stage<2>>(second)->value, 11);
}

struct BackToTheStart final : Completion<BackToTheStart, Reads<Stage<2>>, Adds<Stage<0>>> {
    static constexpr CompletionText text{.name = "Back to the start", .work = "A circle."};
    using Activation = NeedsAll<Stage<2>>;
    static void complete(Access& access) { access.add(Stage<0>{}); }
};
struct Rival final : Completion<Rival, Reads<>, Adds<Stage<1>>> {
    static constexpr CompletionText text{.name = "Rival", .work = "Adds what another one adds."};
    using Activation = NeedsAll<Heat>;
    static void complete(Access& access) { access.add(Stage<1>{}); }
};
struct SameName final : Completion<SameName, Reads<>, Adds<Stage<3>>> {
    static constexpr CompletionText text{.name = "Stage 1", .work = "Has another one's name."};
    using Activation = NeedsAll<Heat>;
    static void complete(Access&) {}
};

template <class... C>
std::string refusalOf() {
    Registry registry;
    (registry.completion<C>(), ...);
    try {
        World const world(registry);
    } catch (RuleBroken const& error) {
        return error.what();
    }
    return "(accepted)";
}

TEST(Completions, ACircleIsRefusedByName) {
    std::string const why = refusalOf<NextStage<1>, NextStage<2>, BackToTheStart, NextStage<3>>();
    for (char const* words : {"no order", "Stage 1 Completion reads Stage 0, which the Back to the start",
                              "Stage 2 Completion reads Stage 1, which the Stage 1 Completion adds"}) {
        EXPECT_NE(why.find(words), std::string::npos) << why;
    }
    EXPECT_EQ(why.find("Stage 3 Completion"), std::string::npos) << "it only depends on the circle: " << why;
}

TEST(Completions, TwoThatAddOnePropertyAreRefusedByName) {
    std::string const why = refusalOf<NextStage<1>, Rival>();
    EXPECT_NE(why.find("the Stage 1 Completion and the Rival Completion both add Stage 1"), std::string::npos)
        << why;
}

TEST(Completions, TwoOfOneNameAreRefused) {
    EXPECT_NE((refusalOf<NextStage<1>, SameName>().find("two completions are called Stage 1 Completion")),
              std::string::npos);
}

TEST(Completions, AddedPropertiesAreKnownToFiles) {
    Registry registry;
    registry.completion<NextStage<1>>();
    EXPECT_EQ(registry.objectProperty("stage_0"), &propertyInfo<Stage<0>>());
    EXPECT_EQ(registry.objectProperty("stage_1"), &propertyInfo<Stage<1>>());
}

TEST(Completions, TheNotationPrintsThemInTheirOrder) {
    Registry registry;
    registry.completion<NextStage<2>>();
    registry.completion<NextStage<1>>();
    std::string const text = notationText(registry);
    EXPECT_LT(text.find("Stage 1 Completion"), text.find("Stage 2 Completion"));
    std::string const box = notationBox(Companion::describeSelf());
    for (char const* line :
         {"Companion Completion", "Properties read:      {Stage 0, Stage 1}",
          "Properties added:     {Stage 2}", "Work on complete():   The other one's stage.",
          "objects with all of {Stage 0}"}) {
        EXPECT_NE(box.find(line), std::string::npos) << box;
    }
}

// An interaction that makes calls in the setup: its resolver receives them in its first advance.
struct HeatFromFuelAtOnce final : Interaction<HeatFromFuelAtOnce, HeatRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Heat <- Fuel at once", .effect = "heat", .level = "", .work = "Burns."};
    using Activation = NeedsAll<Fuel, Heat>;
    static constexpr bool inSetup = true;
    void apply(Access& access) {
        forEach([&](ObjectId id, Fuel const& f) { access.call(AddHeat{id, f.rate}); }, access.read<Fuel>());
    }
};

template <class I>
double heatAfterOneFrame(bool trace = false, std::vector<std::uint64_t>* frames = nullptr) {
    Registry registry;
    registry.component<Furnace>();
    registry.component<I>();
    World world(registry, {.detail = {}, .periods = {}, .trace = trace});
    ObjectId const coal = world.store().create("coal");
    world.store().column<Heat>().set(coal, {0});
    world.store().column<Fuel>().set(coal, {60});
    world.start();
    world.step();
    if (frames != nullptr) {
        for (Event const& event : world.tracer()->events()) {
            frames->push_back(event.frame);
        }
    }
    return world.find<Heat>(coal)->value;
}

TEST(Setup, CallsMadeInItAreCarriedOutInTheFirstAdvance) {
    EXPECT_EQ(heatAfterOneFrame<HeatFromFuel>(), 0) << "others make their first calls at the end of frame 1";
    EXPECT_EQ(heatAfterOneFrame<HeatFromFuelAtOnce>(), 1);
    std::vector<std::uint64_t> frames;
    EXPECT_EQ(heatAfterOneFrame<HeatFromFuelAtOnce>(true, &frames), 1);
    EXPECT_EQ(frames, std::vector<std::uint64_t>{0}) << "an event of frame 0, which is not repeated";
}

} // namespace
} // namespace trembler
