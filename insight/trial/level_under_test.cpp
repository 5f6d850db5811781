#include "insight/trial/level_under_test.hpp"

#include "insight/trial/level_identity.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "runtime/level/build/build_world.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace trembler::insight {
namespace {

/// The seconds of all "for" in the goals, whatever condition they belong to.
double secondsStated(nlohmann::json const& goals) {
    double sum = 0;
    if (goals.is_object() && goals.contains("for") && goals["for"].is_number()) {
        sum += std::clamp(goals["for"].get<double>(), 0.0, 3600.0);
    }
    if (goals.is_structured()) {
        for (nlohmann::json const& inner : goals) {
            sum += secondsStated(inner);
        }
    }
    return sum;
}

} // namespace

LevelUnderTest::LevelUnderTest(GameData const& data, std::filesystem::path const& file)
    : LevelUnderTest(data, loadPlayable(data.registry, data.parts, file), data.shortName(file)) {}

LevelUnderTest::LevelUnderTest(GameData const& data, ReadyLevel ready, std::string name)
    : LevelUnderTest(data, std::move(ready.level), std::move(ready.built.world), std::move(name)) {}

LevelUnderTest::LevelUnderTest(GameData const& data, LevelFile level, std::string name)
    : LevelUnderTest(data, std::move(level), nullptr, std::move(name)) {}

/// `world` is that of the level, or nullptr: it is built.
LevelUnderTest::LevelUnderTest(GameData const& data, LevelFile level, std::unique_ptr<World> world,
                               std::string name)
    : data_(data), task_(level.demonstration && !level.task.is_null()),
      level_(asPlayed(std::move(level), "")), name_(std::move(name)) {
    if (level_.goals.is_null()) {
        throw std::invalid_argument(fmt::format("{}: the level has no goals, so nothing solves it", name_));
    }
    identity_ = identityOf(level_);
    world_ = world != nullptr ? std::move(world) : buildWorld(data.registry, level_, data.parts);
    holdingFrames_ = static_cast<std::uint64_t>(std::ceil(60 * secondsStated(level_.goals)));
}

} // namespace trembler::insight
