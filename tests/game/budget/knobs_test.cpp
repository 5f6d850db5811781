// The error unit of all effects, compared with much more exact runs.
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "runtime/placement.hpp"
#include "tests/game/budget/knob_kit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::budget {
namespace knobs_test {
namespace {

class Knobs : public KnobTest {};

/// The positions of all stars a second after frame 30, from which on these changes hold; and the errors
/// estimated in frame 30 for the options of these names.
std::vector<Vec2> aSecondLater(GameData const& gameData, LevelFile const& level,
                               std::vector<std::pair<std::string, std::string>> const& options,
                               double* estimate) {
    Session session(gameData.registry, gameData.parts, level);
    MotionLog log;
    for (int i = 0; i <= 30; ++i) {
        log.look(session.world());
        if (i < 30) {
            session.step();
        }
    }
    double sum = 0;
    for (Knob const& knob : knobsOf(session.world(), log)) {
        for (Option const& option : knob.options) {
            for (auto const& [effect, name] : options) {
                if (knob.effect == effect && option.name == name) {
                    sum += option.error.metres * option.error.metres;
                    for (RecordedChange const& change : option.makes) {
                        session.change(change);
                    }
                }
            }
        }
    }
    if (estimate != nullptr) {
        *estimate = std::sqrt(sum);
    } else { // far more steps than usual
        RecordedChange exact;
        exact.kind = RecordedChange::Kind::setting;
        exact.subject = "solver";
        exact.field = "substeps";
        exact.value = 64;
        session.change(exact);
    }
    for (int i = 0; i < 60; ++i) {
        session.step();
    }
    std::vector<Vec2> places;
    for (ObjectId const id : session.world().store().findColumn<Mass>()->owners()) {
        places.push_back(session.world().find<Position>(id)->value);
    }
    return places;
}

// The unit of all effects' errors is the real displacement.
TEST_F(Knobs, TheErrorIsTheDisplacementOfBodiesAfterASecond) {
    LevelFile level = starDisc(gameData(), 150);
    DynamicsSettings settings;
    settings.substeps = 4;
    level.world.set(settings);
    auto const right = aSecondLater(gameData(), level, {{"gravity", "real"}}, nullptr);
    using Options = std::vector<std::pair<std::string, std::string>>;
    for (Options const& options : {Options{{"dynamics", "16 steps"}, {"gravity", "tree, opening angle 0.7"}},
                                   Options{{"dynamics", "16 steps"}, {"gravity", "real, every 4 frames"}},
                                   Options{{"dynamics", "2 steps"}, {"gravity", "real"}}}) {
        double estimate = 0;
        auto const found = aSecondLater(gameData(), level, options, &estimate);
        ASSERT_EQ(found.size(), right.size());
        double squares = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            squares += lengthSquared(found[i] - right[i]);
        }
        double const off = std::sqrt(squares / static_cast<double>(found.size()));
        std::string const what = options[0].second + ", " + options[1].second;
        RecordProperty(what, fmt::format("estimated {:.3g} m, found {:.3g} m", estimate, off));
        EXPECT_LT(off, 3 * estimate) << what;
        EXPECT_GT(off, estimate / 3) << what;
    }
}

TEST_F(Knobs, AreOneForEachEffectOfTheScene) {
    auto const effects = [&] {
        std::vector<std::string> found;
        for (Knob const& knob : knobsOf(world(), MotionLog())) {
            found.push_back(knob.effect);
            EXPECT_LT(knob.current, knob.options.size()) << knob.effect;
            EXPECT_FALSE(knob.components.empty()) << knob.effect;
        }
        return found;
    };
    open("4-raft.json");
    runTo(2);
    EXPECT_EQ(effects(), (std::vector<std::string>{"buoyancy", "dynamics", "gravity"}));
    open("2-doorbell.json");
    runTo(2);
    EXPECT_EQ(effects(), (std::vector<std::string>{"dynamics", "electricity", "gravity", "magnetism"}));
}

} // namespace
} // namespace knobs_test
} // namespace trembler::budget
