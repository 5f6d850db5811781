// A level that is run many times.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/session/ready_level.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace trembler::insight {

/// Reading it from several threads at once is safe. The game data must outlive it.
class LevelUnderTest {
public:
    /// Throws InputError if the level cannot be read or built, std::invalid_argument if it has no goals. A
    /// demonstration with a task is tested as it is played: its goals are the task.
    LevelUnderTest(GameData const& data, std::filesystem::path const& file);
    /// The same of a level that may be in no file, such as one that is being edited.
    LevelUnderTest(GameData const& data, LevelFile level, std::string name);

    [[nodiscard]] GameData const& data() const { return data_; }
    [[nodiscard]] LevelFile const& level() const { return level_; }
    /// As a person would name it.
    [[nodiscard]] std::string const& name() const { return name_; }
    /// The identity of the level, for keys of work on it: see level_identity.hpp.
    [[nodiscard]] std::string const& identity() const { return identity_; }
    /// The level's world before its first frame, without any part of the toolbox.
    [[nodiscard]] World const& world() const { return *world_; }
    /// Whether its goals are the task of a demonstration. Its recorded solutions are then expected to reach
    /// what the demonstration reaches by itself, and some of them the task.
    [[nodiscard]] bool isTask() const { return task_; }
    /// How long the goals' conditions must hold altogether, in frames: a world at rest has no other future
    /// than this to offer to them.
    [[nodiscard]] std::uint64_t holdingFrames() const { return holdingFrames_; }

private:
    LevelUnderTest(GameData const& data, ReadyLevel ready, std::string name);
    LevelUnderTest(GameData const& data, LevelFile level, std::unique_ptr<World> world, std::string name);

    GameData const& data_;
    bool task_;
    LevelFile level_;
    std::string name_;
    std::string identity_;
    std::unique_ptr<World> world_;
    std::uint64_t holdingFrames_ = 0;
};

} // namespace trembler::insight
