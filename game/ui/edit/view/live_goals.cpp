#include "game/ui/edit/view/live_goals.hpp"

#include "runtime/level/json/diagnostic.hpp"

#include <utility>

namespace trembler::ui {

void LiveGoals::begin(LevelFile const& level, std::vector<std::string> places) {
    level_ = level;
    places_ = std::move(places);
    judged_.clear();
    ready_ = false;
    states_.clear();
}

void LiveGoals::end() {
    judged_.clear();
    ready_ = false;
}

void LiveGoals::prepare(World const& world) {
    judged_.clear();
    for (std::string const& place : places_) {
        try {
            auto level = std::make_unique<LevelFile>(level_);
            level->document = nullptr; // the places of its conditions are others than in the file
            level->goals = level_.goals.at(nlohmann::json::json_pointer(place));
            auto judge = std::make_unique<GoalJudge>(*level, world);
            judged_.push_back({place, std::move(level), std::move(judge)});
        } catch (InputError const&) { // it is about "it", or wrong: then it is a problem of the level
        } catch (nlohmann::json::exception const&) {
        }
    }
}

void LiveGoals::follow(Session const& session) {
    World const& world = session.world();
    if (session.mode() == SessionMode::building) {
        // Set up again in every picture: another world may be at the address of the last one.
        prepare(world);
        ready_ = true;
        return; // the states of the last run stay
    }
    if (!ready_) {
        return; // the run began before the first call
    }
    for (Judged& one : judged_) {
        one.judge->update(world);
        State& state = states_[one.place];
        std::vector<GoalStatus> const& goals = one.judge->status();
        bool met = !goals.empty();
        for (GoalStatus const& goal : goals) {
            met = met && goal.met;
        }
        state.met = met;
        state.once = state.once || one.judge->solved();
    }
}

} // namespace trembler::ui
