// {"on": O}: an object is part of a working circuit.
#include "puzzle/goals/conditions/circuit.hpp"
#include "puzzle/goals/judging/condition_state.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

class OnCondition final : public CircuitCondition {
public:
    constexpr OnCondition() : CircuitCondition("on", true) {}

    [[nodiscard]] Standing judge(ConditionState& state, World const& world) const override {
        return {std::any_of(state.subjects().begin(), state.subjects().end(),
                            [&](ObjectId id) { return isOn(world, id); }),
                0};
    }
};

} // namespace

ConditionKind const& on() {
    static OnCondition const kind;
    return kind;
}

} // namespace trembler::conditions
