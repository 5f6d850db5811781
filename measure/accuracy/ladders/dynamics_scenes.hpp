// Scenes of rigid bodies whose exact motion is known.
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

/// A world at its start, and its error after each frame.
struct DynamicsScene {
    std::unique_ptr<World> world;
    /// Deviation in m after `frame` frames; the greatest over all frames is the scene's error.
    std::function<double(World const&, int frame)> error;
};

struct Solver {
    DynamicsSettings settings;
    std::string engine; ///< "box2d"; empty: the world's default engine
};

/// Builds the scene with a solver's settings.
using DynamicsSceneMaker = std::function<DynamicsScene(GameData const&, Solver const&)>;

/// A ball thrown up at an angle. Error: distance from the parabola.
[[nodiscard]] DynamicsScene thrownBall(GameData const& gameData, Solver const& solver);
/// A body on an arm, released at 1.5 rad. Error: distance from the solution of its equation of motion.
[[nodiscard]] DynamicsScene pendulum(GameData const& gameData, Solver const& solver);
/// A chain between two pins with a heavy ball at its middle. Error: the widest gap of any joint; exact is 0.
[[nodiscard]] DynamicsScene loadedChain(GameData const& gameData, Solver const& solver, int links,
                                        double ballMass);
/// A stack of unit boxes that may not sleep. Error: the largest sideways displacement of any box; exact is 0.
/// (Vertically all of them sink into one another by the engine's tolerance, however short the substeps are.)
[[nodiscard]] DynamicsScene stack(GameData const& gameData, Solver const& solver, int boxes);
/// A chain released horizontally, held at one end. Error: the largest distance of any link from its place in
/// `path`, by frame and link; 0 while `path` is being recorded.
struct ChainPath {
    std::vector<std::vector<Vec2>> places; ///< by frame, then link
};
[[nodiscard]] DynamicsScene fallingChain(GameData const& gameData, Solver const& solver, int links,
                                         std::shared_ptr<ChainPath> path, bool record);

} // namespace accuracy
} // namespace trembler
