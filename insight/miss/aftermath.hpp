// The breaks of a condition that held, but not for long enough.
#pragma once

#include "insight/miss/condition_miss.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace trembler::insight {

/// Looks at the parts of a condition that all have to hold, in the time for which it should have held on.
/// Reports, for each part, the longest time for which it did not hold: how far it was from holding at the
/// worst, and what a liquid lacked when that began. A part that was broken only as briefly as by a bounce is
/// reported only if no other part was broken. Not thread-safe.
class Aftermath {
public:
    /// A break shorter than this number of frames counts as a bounce.
    static constexpr std::uint64_t bounce = 15;

    /// The condition held, but for that number of frames less than it should. Forgets all earlier breaks.
    /// `goal` must outlive this object.
    void begin(ConditionMiss const& goal, std::uint64_t frame, std::uint64_t missing);
    /// Forgets all breaks and stops looking.
    void end() { parts_.clear(); }
    /// To be called after each later frame.
    void look(World const& world, CircuitSight& circuits);

    /// In the order in which the parts ceased to hold; each with the moment of its worst, and named.
    [[nodiscard]] std::vector<Miss> misses() const;

private:
    /// A time for which a part did not hold.
    struct Break {
        std::uint64_t from = 0; // frame
        std::uint64_t frames = 0;
        Miss worst;
        std::vector<Miss> lift; // when it began
    };
    struct Part {
        ConditionMiss const* condition = nullptr;
        std::optional<Break> now;
        std::optional<Break> longest; // of the breaks that are over
    };
    void addParts(ConditionMiss const& one);
    [[nodiscard]] static Break const* longestOf(Part const& part);

    std::vector<Part> parts_;
    std::uint64_t until_ = 0; // the last frame
};

} // namespace trembler::insight
