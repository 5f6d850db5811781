// Dynamics ladders: substeps and iterations, against closed forms, against scenes that must not move, and
// against 64 substeps.
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/ladders/dynamics_scenes.hpp"
#include "measure/accuracy/ladders/effect_clock.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::accuracy {
namespace {

Rung measure(std::string level, DynamicsScene scene, int frames) {
    scene.world->start();
    EffectClock clock("dynamics");
    double worst = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        scene.world->step();
        clock.frame(*scene.world);
        double const now = scene.error(*scene.world, frame);
        worst = std::isfinite(now) ? std::max(worst, now) : std::numeric_limits<double>::infinity();
    }
    return {std::move(level), clock.median(), worst, {}, false, {}};
}

struct Words {
    std::string scene;
    std::string error; ///< "over ... s" is added
    std::string reference;
    std::string remark;
};

/// Length of a run in frames, and that of a brief run.
struct Length {
    int frames;
    int brief;
    [[nodiscard]] int of(Effort effort) const { return effort.brief ? brief : frames; }
};

Ladder begin(Words const& words, int frames, bool rivals = true) {
    return {"",
            words.scene,
            "m",
            fmt::format("{}, over {:g} s", words.error, frames * frameDuration),
            words.reference,
            rivals,
            {},
            words.remark};
}

Plan substepsPlan(Words words, DynamicsSceneMaker make, Length length) {
    return {"dynamics", [=](GameData const& gameData, Effort effort) {
                Ladder ladder = begin(words, length.of(effort));
                for (int const substeps : {1, 2, 4, 8, 16, 64, DynamicsSettings::automatic}) {
                    if (effort.brief && substeps > 8) {
                        continue;
                    }
                    Solver solver;
                    solver.settings.substeps = substeps;
                    ladder.rungs.push_back(
                        measure(substepsName(substeps), make(gameData, solver), length.of(effort)));
                }
                return ladder;
            }};
}

/// A kind of solver iterations, and the numbers to be measured.
struct Iterations {
    char const* of; ///< "velocity" or "position"
    std::int32_t DynamicsSettings::*count;
    std::vector<int> tried;
};

Iterations const velocityIterations{"velocity", &DynamicsSettings::velocityIterations, {4, 8, 16, 32, 64}};
Iterations const positionIterations{"position", &DynamicsSettings::positionIterations, {1, 2, 3, 6, 12}};

Plan iterationsPlan(Words words, DynamicsSceneMaker make, int substeps, Iterations const& iterations,
                    Length length) {
    return {"dynamics", [=](GameData const& gameData, Effort effort) {
                bool const holds = substeps >= 4; // torn chains are useless, so their levels do not compete
                Ladder ladder = begin(words, length.of(effort), holds);
                for (int const count : iterations.tried) {
                    Solver solver;
                    solver.settings.substeps = substeps;
                    solver.settings.*iterations.count = count;
                    ladder.rungs.push_back(
                        measure(fmt::format("{} {} iteration{}", count, iterations.of, count == 1 ? "" : "s"),
                                make(gameData, solver), length.of(effort)));
                }
                return ladder;
            }};
}

// Every registered engine, with two numbers of substeps.
Plan enginesPlan(Words words, DynamicsSceneMaker make, Length length) {
    return {"dynamics", [=](GameData const& gameData, Effort effort) {
                Ladder ladder = begin(words, length.of(effort));
                for (Registration const& one : gameData.registry.components()) {
                    if (one.info->kind != ComponentKind::resolver || one.info->roleName != "Dynamics") {
                        continue;
                    }
                    for (int const substeps : {4, 8}) {
                        Solver solver;
                        solver.engine = one.info->text.level;
                        solver.settings.substeps = substeps;
                        ladder.rungs.push_back(
                            measure(fmt::format("{}, {}", solver.engine, substepsName(substeps)),
                                    make(gameData, solver), length.of(effort)));
                    }
                }
                return ladder;
            }};
}

Ladder climbFallingChain(GameData const& gameData, Effort effort) {
    constexpr int links = 10;
    int const frames = effort.brief ? 30 : 60;
    Ladder ladder = begin({"a chain of 10 links swings down",
                           "greatest distance of a link from where it should be", "64 substeps", ""},
                          frames);
    auto const path = std::make_shared<ChainPath>();
    Solver solver;
    solver.settings.substeps = 64;
    static_cast<void>(measure("", fallingChain(gameData, solver, links, path, true), frames));
    for (int const substeps : {1, 2, 4, 8, 16, DynamicsSettings::automatic}) {
        solver.settings.substeps = substeps;
        ladder.rungs.push_back(
            measure(substepsName(substeps), fallingChain(gameData, solver, links, path, false), frames));
    }
    return ladder;
}

} // namespace

void addDynamicsPlans(std::vector<Plan>& plans) {
    plans.push_back(
        substepsPlan({"a thrown ball", "greatest distance from its path", "the parabola (closed form)",
                      "The engine's steps are of the first order: half the step, half the error, "
                      "down to the rounding of its single precision."},
                     thrownBall, {120, 30}));
    plans.push_back(substepsPlan({"a pendulum of 1.5 rad", "greatest distance from its place",
                                  "its equation of motion, integrated until it converged", ""},
                                 pendulum, {300, 60}));
    plans.push_back({"dynamics", climbFallingChain});
    auto const chain = [](GameData const& gameData, Solver const& solver) {
        return loadedChain(gameData, solver, 30, 100 * 1.0);
    };
    std::string const gap = "widest gap of a joint";
    std::string const whole = "a chain without gaps";
    plans.push_back(substepsPlan(
        {"a chain of 30 links under a hundred times a link's mass", gap, whole,
         "Below four substeps the step is too long for the chain's zig-zag mode, and the chain tears. For "
         "that reason alone two substeps take longer than four: a torn chain has contacts, which take more "
         "time than the substeps that keep it whole. The automatic settings solve all joints of so long a "
         "chain together, and are better than eight substeps."},
        chain, {300, 60}));
    plans.push_back(iterationsPlan(
        {"the same chain at 1 substep, by velocity iterations", gap, whole,
         "The chain tears with any number of iterations: they cannot make up for steps that are "
         "too long. By how much is a matter of chance."},
        chain, 1, velocityIterations, {300, 40}));
    plans.push_back(iterationsPlan(
        {"the same chain at 4 substeps, by velocity iterations", gap, whole,
         "If the step is short enough, more iterations help; eight substeps of eight iterations take as long "
         "as four of 32. With fewer than four iterations the chain tears."},
        chain, 4, velocityIterations, {300, 40}));
    plans.push_back(iterationsPlan(
        {"the same chain at 4 substeps, by position iterations", gap, whole,
         "Under a load they do not help: in the next substep the load opens the gaps that they close in this "
         "one, and a dozen iterations, each for a single joint, make the chain unsteady. They are for gaps "
         "and overlaps of unloaded joints and contacts; three is the default."},
        chain, 4, positionIterations, {300, 40}));
    plans.push_back(substepsPlan(
        {"a stack of 20 boxes", "farthest that a box has moved sideways", "a stack that stands still",
         "From eight on nothing is gained."},
        [](GameData const& gameData, Solver const& solver) { return stack(gameData, solver, 20); },
        {1200, 60}));
    plans.push_back(
        enginesPlan({"engines: a chain of 30 links under a hundred times a link's mass", gap, whole,
                     "A scene uses Box2D unless another engine is requested. With Chipmunk the chain tears "
                     "at 4 substeps and holds at 8; ODE, made for three dimensions, takes by far the most "
                     "time. [engines.md](../engines.md) describes the other differences."},
                    chain, {300, 30}));
    plans.push_back(enginesPlan(
        {"engines: a stack of 10 boxes", "farthest that a box has moved sideways",
         "a stack that stands still",
         "Chipmunk's boxes creep by millimetres, so even with more substeps it is less accurate than Box2D "
         "with fewer."},
        [](GameData const& gameData, Solver const& solver) { return stack(gameData, solver, 10); },
        {600, 30}));
}

} // namespace trembler::accuracy
