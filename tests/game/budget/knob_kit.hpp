// Shared by the tests of all knobs: scenes as text, and checks that options have the effect that they state.
#pragma once

#include "game/budget/knobs.hpp"
#include "tests/support/experiment.hpp"

#include <functional>
#include <optional>
#include <string>

namespace trembler::budget {

/// A rotating disc of stars, small enough for a test. `more` are further members of the file.
[[nodiscard]] LevelFile starDisc(GameData const& gameData, int count, std::string const& more = {});

class KnobTest : public Experiment {
protected:
    using Maker = std::function<std::optional<Knob>(World const&)>;

    /// A level with these members: R"("world": {...}, "objects": [...])".
    [[nodiscard]] static LevelFile levelOf(std::string const& members);
    /// The option of that name; fails the test if there is none.
    [[nodiscard]] static Option const& named(Knob const& knob, std::string const& name);
    /// Selects each allowed option in the open world, and checks that the world then has it.
    void expectOptionsAreMade(Maker const& of);
};

} // namespace trembler::budget
