// Connections that are made or broken other than by a touch: generators, sound sensors and fuses.
#pragma once

#include "insight/miss/current/circuit_gaps.hpp"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace trembler::insight {

/// What a world's generators and sound sensors would connect, and the fuses that have blown, as it is when
/// this is made.
class SwitchedLinks {
public:
    explicit SwitchedLinks(World const& world);

    /// The gap between two conductors that a generator or a sensor would close, with its reason and its cost;
    /// nothing if neither would close a gap there. `a` before `b`.
    [[nodiscard]] std::optional<CircuitGap> between(ObjectId a, ObjectId b) const;
    /// Whether a gap cannot be closed by a touch, as one of the two is a blown fuse; then it gets that
    /// reason, and a higher cost.
    bool addBlown(CircuitGap& gap) const;

private:
    void add(ObjectId a, ObjectId b, GapReason reason, ObjectId by, double is, double needed);

    std::map<std::pair<ObjectId, ObjectId>, CircuitGap> links_;
    std::set<ObjectId> blown_;
};

} // namespace trembler::insight
