// What is known of a run besides how it stands: how much velocities have changed lately, which the error of a
// step in time is in proportion to, and how many steps the level asked for.
#pragma once

#include "runtime/world/world.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace trembler::budget {

/// Looks at every tenth frame and adds up by how much the velocity of each object has changed since the last
/// look.
class MotionLog {
public:
    static constexpr std::uint64_t interval = 10; ///< frames
    /// To be called before or after every frame; costs nothing but in each tenth.
    void look(World const& world);
    void clear();

    /// Root of the mean square over all objects that can move, of the changes of velocity added up over a
    /// second, in m/s; what has been seen so far is taken for a whole second. 0 if nothing has been seen.
    [[nodiscard]] double changePerSecond() const;

    /// Steps of the engine per frame when the run was first looked at: what the level states. 0: automatic.
    [[nodiscard]] int statedSteps() const { return stated_; }
    /// How many steps the scene called for by itself when it was last asked; 4 if it never was.
    [[nodiscard]] int automaticSteps() const { return automatic_; }

private:
    void noteSteps(World const& world);

    static constexpr std::size_t kept = 6; // looks: one second

    std::map<ObjectId, Vec2> last_;
    std::vector<std::map<ObjectId, double>> changes_; // m/s, one per look, the latest last
    std::uint64_t seen_ = 0;                          // frame of the last look
    bool known_ = false;                              // how many steps are stated
    int stated_ = 4;
    int automatic_ = 4;
};

} // namespace trembler::budget
