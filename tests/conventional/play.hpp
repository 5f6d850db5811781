// Runs a perturbed scene: with all of physics, with rigid bodies only, or with scripts.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "runtime/level/model/level.hpp"
#include "tests/conventional/game.hpp"

namespace trembler::conventional {

/// The parts and the component sets that all runs share.
class Stage {
public:
    Stage();

    struct Watch {
        std::uint64_t frames = 600;
        std::pair<std::string, std::string> pair{}; ///< the two objects whose contacts are counted
        std::vector<std::string> devices{};         ///< checked at the end for being on
    };
    /// Throws InputError if the level is wrong.
    [[nodiscard]] Film play(Setting const& setting, Kind kind, Watch const& watch,
                            ScriptSet const& scripts = {}) const;
    /// The scene's statements about its objects, parts and defaults included.
    [[nodiscard]] Facts factsOf(Setting const& setting) const;
    [[nodiscard]] nlohmann::json levelOf(std::string const& file) const; ///< relative to the repository

private:
    [[nodiscard]] LevelFile read(Registry const& registry, Setting const& setting, bool cuts) const;

    GameData data_;
    Registry bodies_;
};

} // namespace trembler::conventional
