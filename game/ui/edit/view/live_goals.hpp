// Whether each condition of a level holds while the level is test-played, inner ones included.
#pragma once

#include "puzzle/goals/goal_judge.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/model/level.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trembler::ui {

/// Each condition is judged as if it were the level's only goal. One about "it", inside a count, cannot be
/// judged alone and has no state. Not thread-safe.
class LiveGoals {
public:
    /// `places` are JSON pointers below "goals", see puzzle/edit/commands/goals.hpp.
    void begin(LevelFile const& level, std::vector<std::string> places);
    /// To be called for every picture, while building, too: a world is judged from its first frame on.
    void follow(Session const& session);
    void end();

    struct State {
        bool met = false;  ///< at present, or at the end of the last run
        bool once = false; ///< in any frame of the run
    };
    /// Of the present or last run, by place.
    [[nodiscard]] std::map<std::string, State> const& states() const { return states_; }
    void forget() { states_.clear(); }

private:
    struct Judged {
        std::string place;
        std::unique_ptr<LevelFile> level; // the judge may refer to it
        std::unique_ptr<GoalJudge> judge;
    };
    void prepare(World const& world);

    LevelFile level_;
    std::vector<std::string> places_;
    std::vector<Judged> judged_;
    bool ready_ = false; // the judges are those of the session's world
    std::map<std::string, State> states_;
};

} // namespace trembler::ui
