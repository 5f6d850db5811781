// A world whose positions, contacts and electrical states a test sets directly, so that the expected
// judgement follows from the test alone.
#pragma once

#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/goals/goal_judge.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

class GoalStage {
public:
    /// The objects: floor, electromagnet (fixed, above), metal object, crate, object 1, ball a, ball b (both
    /// made from the part "iron ball"), idea (without a position), and as conductors lamp and lantern, which
    /// are electrical devices made of glass, and lamp 2 and toy lamp, which are not. In the toolbox are a
    /// "night light", of the same kind as lamp, and a "desk lamp", of the same kind as lamp 2. Throws as the
    /// judge does.
    explicit GoalStage(std::string const& goals, int crowd = 0);

    [[nodiscard]] GoalJudge const& judge() const { return *judge_; }
    [[nodiscard]] World& world() { return *world_; }
    [[nodiscard]] LevelFile const& level() const { return level_; }
    [[nodiscard]] ObjectId id(std::string const& name) const;
    /// For each goal "1" if it is met, else "0".
    [[nodiscard]] std::string met() const;

    void put(std::string const& name, Vec2 at);
    /// Contacts have an event id, which may be 0.
    void touch(std::string const& a, std::string const& b, std::uint64_t event = 0);
    void part(std::string const& a, std::string const& b, std::uint64_t event = 0);
    /// Touches for less than a frame: an impact that bounces.
    void hit(std::string const& a, std::string const& b, std::uint64_t event = 0);
    void turn(std::string const& name, bool on, std::uint64_t event = 0);
    /// Computes frames of the world with the values set, and lets the judge evaluate the goals.
    void step(int frames = 1);
    /// Computes one frame in four parts, of which the world runs the first and the last, as there is no work
    /// in the others: `set` is called, and the goals are evaluated, in each part.
    void stepInParts(std::function<void(std::uint32_t part)> const& set);

private:
    void write();

    Registry registry_;
    LevelFile level_;
    std::unique_ptr<World> world_;
    std::unique_ptr<GoalJudge> judge_;
    Contacts contacts_;
    ElectricalState state_;
    std::vector<std::pair<ObjectId, Vec2>> places_;
};

/// The judge's reason for rejecting the goals, or "" if it accepts them.
[[nodiscard]] std::string refusalOf(std::string const& goals, int crowd = 0);
/// Whether the reason contains these words.
[[nodiscard]] testing::AssertionResult isRefused(std::string const& goals, std::string const& words,
                                                 int crowd = 0);
/// The text that the player sees for a single goal.
[[nodiscard]] std::string wordsOf(std::string const& goals);

} // namespace trembler
