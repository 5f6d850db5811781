// {"off": O}: an object is not part of a working circuit. A destroyed object is neither on nor off.
#include "puzzle/goals/conditions/circuit.hpp"
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/judging/condition_state.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

class OffCondition final : public CircuitCondition {
public:
    constexpr OffCondition() : CircuitCondition("off", false) {}

    [[nodiscard]] Standing judge(ConditionState& state, World const& world) const override {
        return {std::any_of(state.subjects().begin(), state.subjects().end(),
                            [&](ObjectId id) { return world.store().alive(id) && !isOn(world, id); }),
                0};
    }
};

} // namespace

ConditionKind const& off() {
    static OffCondition const kind;
    return kind;
}

} // namespace trembler::conditions
