// Scenes of rigid bodies whose right motion is known.
#pragma once

#include "physics/dynamics/properties/settings.hpp"
#include "runtime/math/vec2.hpp"
#include "runtime/object/object_id.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace trembler {

class World;
struct GameData;

namespace accuracy {

/// A world at its start, and how to look at it after each frame.
struct DynamicsScene {
    std::unique_ptr<World> world;
    /// m, how far what is to be seen after `frame` frames is off; the greatest over all frames is the error.
    std::function<double(World const&, int frame)> error;
};

struct Solver {
    DynamicsSettings settings;
    std::string engine; ///< "box2d"; empty: the one that the world picks
};

/// Makes the scene again with a solver.
using DynamicsSceneMaker = std::function<DynamicsScene(GameData const&, Solver const&)>;

/// A ball thrown up at an angle: distance from the parabola.
[[nodiscard]] DynamicsScene thrownBall(GameData const& gameData, Solver const& solver);
/// A body on an arm, let go at 1.5 rad: distance from the solution of its equation of motion.
[[nodiscard]] DynamicsScene pendulum(GameData const& gameData, Solver const& solver);
/// A chain between two pins with a heavy ball at its middle: the widest gap of any joint; there should be
/// none.
[[nodiscard]] DynamicsScene loadedChain(GameData const& gameData, Solver const& solver, int links,
                                        double ballMass);
/// A stack of unit boxes, not allowed to sleep: how far any box has moved sideways; none should.
/// (Downwards all of them sink into one another by the engine's tolerance, however short the steps are.)
[[nodiscard]] DynamicsScene stack(GameData const& gameData, Solver const& solver, int boxes);
/// A chain let go level, held at one end: how far any link is from where `path` has it, by frame and link;
/// while `path` is being recorded, 0.
struct ChainPath {
    std::vector<std::vector<Vec2>> places; ///< by frame, then link
};
[[nodiscard]] DynamicsScene fallingChain(GameData const& gameData, Solver const& solver, int links,
                                         std::shared_ptr<ChainPath> path, bool record);

} // namespace accuracy
} // namespace trembler
