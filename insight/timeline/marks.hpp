// The moments of a run at which something notable happened.
#pragma once

#include "puzzle/goals/goal_judge.hpp"
#include "runtime/input/player_input.hpp"
#include "runtime/placement.hpp"
#include "runtime/trace/event.hpp"
#include "runtime/world/world.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace trembler::insight {

enum class MarkKind : std::uint8_t {
    contact,   ///< two conductors began to touch
    parted,    ///< two conductors ceased to touch
    on,        ///< a device or an electromagnet was switched on
    off,       ///< and off
    sound,     ///< a body began to sound
    broken,    ///< a joint gave way, or a fuse
    cut,       ///< the player cut a wire, or removed an object
    goal,      ///< a goal was met for the first time
    hit,       ///< two objects, not both conductors, touched for the first time, at Marks::leastSpeed or more
    dips,      ///< an object began to dip into a liquid: the object, the liquid
    leaves,    ///< and left it
    magnetOn,  ///< an object became a magnet
    magnetOff, ///< and ceased to be one, or began to cool down
};

/// The number of kinds.
inline constexpr std::size_t markKinds = 13;

struct Mark {
    std::uint64_t frame = 0;
    MarkKind kind = MarkKind::contact;
    std::vector<std::string> objects; ///< by name, as they may no longer exist
    std::string goal;                 ///< of a goal: its id
    /// The event of the trace, if the run is traced. In another, traced run of the same inputs it is the
    /// event of this frame that concerns these objects: so a question "why?" can be asked at a mark of any
    /// run.
    EventId event;
};

/// Finds marks while a run goes on. Reads the world between frames and changes nothing; what only
/// subscriptions compute, such as sounds, is marked only while a subscription to it lives. Not thread-safe.
class Marks {
public:
    /// The same thing is not marked again within this number of frames: a trembler switches many times a
    /// second.
    static constexpr std::uint64_t quiet = 15;
    /// Later marks are left out, in a run with as many; so are those of further pairs of objects.
    static constexpr std::size_t most = 100'000;
    /// A body that becomes this loud is marked, dB(A) at 1 m.
    static constexpr double leastLevel = 40;
    /// m/s between the centres of two objects in the frame before they touch. Slower touches, and later ones
    /// of the same two, are not marked: objects that roll, slide and settle touch all the time.
    static constexpr double leastSpeed = 1;

    explicit Marks(std::size_t mostMarks = most) : most_(mostMarks) {}

    /// After each frame.
    void look(World const& world, GoalJudge const& judge);
    void clear();
    void forgetAfter(std::uint64_t frame);

    /// Ascending by frame.
    [[nodiscard]] std::vector<Mark> const& all() const { return marks_; }
    /// The nearest mark after `frame`, or before it; nullptr if there is none.
    [[nodiscard]] Mark const* after(std::uint64_t frame) const;
    [[nodiscard]] Mark const* before(std::uint64_t frame) const;

private:
    using Key = std::pair<MarkKind, std::vector<std::string>>;
    void add(World const& world, MarkKind kind, std::vector<ObjectId> const& objects, EventId event,
             std::string goal = "");
    void lookAtContacts(World const& world);
    void lookAtElectricity(World const& world);
    void lookAtSounds(World const& world);
    void lookAtBreaks(World const& world);
    void lookAtHits(World const& world);
    void lookAtLiquids(World const& world);
    void lookAtMagnets(World const& world);
    void remember(World const& world);

    std::size_t most_;
    std::vector<Mark> marks_;
    std::map<Key, std::uint64_t> latest_; // frame of the last such thing, marked or not
    std::map<std::string, bool> blown_;   // fuses
    // The frame before, if it was looked at.
    struct Earlier {
        std::vector<ObjectId> movers;     // ascending, kept from frame to frame for their memory
        std::vector<Velocity> velocities; // of the movers, m/s
        void copyVelocities(Store const& store);
        [[nodiscard]] Vec2 velocityOf(ObjectId object) const;
        std::set<std::pair<ObjectId, ObjectId>> dips;
        std::map<ObjectId, bool> magnets;
    };
    std::optional<Earlier> earlier_;
};

} // namespace trembler::insight
