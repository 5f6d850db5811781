// History of a run that the estimates need: by how much velocities have changed lately, which the error of a
// time step is proportional to, and how many substeps the level asked for.
#pragma once

#include "runtime/world/world.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace trembler::budget {

/// Samples every tenth frame and sums the change of each object's velocity since the last sample.
class MotionLog {
public:
    static constexpr std::uint64_t interval = 10; ///< frames
    /// Call before or after every frame; does nothing except in each tenth.
    void look(World const& world);
    void clear();

    /// Root mean square over all movable objects of the change of velocity in one second, in m/s; a shorter
    /// history is extrapolated. 0 without any history.
    [[nodiscard]] double changePerSecond() const;

    /// Substeps per frame that the level states, read at the first look() of the run. 0: automatic.
    [[nodiscard]] int statedSteps() const { return stated_; }
    /// Substeps per frame that the scene needed when it was last evaluated; 4 if it never was.
    [[nodiscard]] int automaticSteps() const { return automatic_; }

private:
    void noteSteps(World const& world);

    static constexpr std::size_t kept = 6; // samples: one second

    std::map<ObjectId, Vec2> last_;
    std::vector<std::map<ObjectId, double>> changes_; // m/s, one per sample, the latest last
    std::uint64_t seen_ = 0;                          // frame of the last sample
    bool known_ = false;                              // whether stated_ has been read
    int stated_ = 4;
    int automatic_ = 4;
};

} // namespace trembler::budget
