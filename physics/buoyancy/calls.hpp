// The interaction functions of the Buoyancy resolver, for any detail level.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/math/vec2.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// The thesis's setLinearGravity(vector) (6.13.2). Accelerations add up, as those of a planet and of a lift
/// do; with "set" the last caller would win.
struct SetLinearGravity {
    static constexpr CallText text{
        "setLinearGravity", "(field, vector)",
        "Defines the linear gravity vector (m/s²) for as long as the call is held; "
        "the vectors of several fields add up."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    ObjectId field; ///< the object that the field belongs to: the world
    Vec2 gravity;   ///< m/s²
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "field",
                        .unit = "",
                        .meaning = "the object that the field belongs to: the world",
                        .required = true},
              self.field);
        visit(FieldInfo{.key = "gravity",
                        .unit = "m/s²",
                        .meaning = "acceleration",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.gravity);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {field}; }
};

struct BuoyancyRole {
    static constexpr std::string_view name = "Buoyancy";
    using Calls = CallList<SetLinearGravity>;
};

} // namespace trembler
