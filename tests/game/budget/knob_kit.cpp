#include "tests/game/budget/knob_kit.hpp"

#include "runtime/level/model/world_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::budget {

LevelFile starDisc(GameData const& gameData, int count, std::string const& more) {
    std::string text =
        R"({"version": 2, "title": "stars", "world": {"gravity_law": {"constant": 1, "softening": 0.5}},
        "objects": [)";
    for (int i = 0; i < count; ++i) {
        double const radius = 30 * std::pow((i + 0.5) / count, 0.8);
        double const angle = i * pi * (3 - std::sqrt(5.0));
        Vec2 const at{radius * std::cos(angle), radius * std::sin(angle)};
        Vec2 const velocity = 3.0 / std::sqrt(radius + 1) * Vec2{-at.y, at.x};
        text += fmt::format(
            R"({}{{"name": "star {:03}", "at": [{}, {}], "properties": {{"shape": [{{"form": "circle",)"
            R"( "radius": 0.05}}], "mass": {}, "velocity": [{}, {}]}}}})",
            i == 0 ? "" : ", ", i, at.x, at.y, 1 + i % 5, velocity.x, velocity.y);
    }
    return readLevel(gameData.registry, JsonDocument::parse(text + "]" + more + "}", "stars.json"));
}

LevelFile KnobTest::levelOf(std::string const& members) {
    return readLevel(gameData().registry,
                     JsonDocument::parse(R"({"version": 2, "title": "t", )" + members + "}", "knob.json"));
}

Option const& KnobTest::named(Knob const& knob, std::string const& name) {
    auto const at = std::find_if(knob.options.begin(), knob.options.end(),
                                 [&](Option const& option) { return option.name == name; });
    if (at == knob.options.end()) {
        ADD_FAILURE() << "no option '" << name << "' of " << knob.effect;
        return knob.options.front();
    }
    return *at;
}

void KnobTest::expectOptionsAreMade(Maker const& of) {
    std::optional<Knob> const first = of(world());
    ASSERT_TRUE(first);
    std::size_t made = 0;
    for (Option const& option : first->options) {
        bool const allowed =
            option.cannot.empty() &&
            std::none_of(option.makes.begin(), option.makes.end(), [&](RecordedChange const& change) {
                return faultIn(gameData().registry, world(), change).has_value();
            });
        if (!allowed) {
            continue;
        }
        for (RecordedChange const& change : option.makes) {
            session().change(change);
        }
        step();
        std::optional<Knob> const now = of(world());
        ASSERT_TRUE(now) << option.name;
        EXPECT_EQ(now->options[now->current].name, option.name);
        for (RecordedChange const& change : now->options[now->current].makes) {
            EXPECT_TRUE(holds(gameData().registry, world(), change))
                << option.name << ": " << inWords(change);
        }
        ++made;
    }
    EXPECT_GT(made, 1U) << "there was nothing to choose";
}

} // namespace trembler::budget
