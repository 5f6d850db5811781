// Examples of the functions of the resolver Dynamics.
#include "lua/reference/function_examples/by_resolver.hpp"

#include <array>

namespace trembler::lua {

std::span<FunctionExample const> dynamicsExamples() {
    static constexpr std::array<FunctionExample, 6> examples{{
        {"Dynamics", "addForce", R"lua(-- Half of its weight is taken off every body.
return interaction {
  name = "Dynamics <- Half weight",
  calls = "Dynamics",
  reads = { "Mass", "Velocity", "Gravity" },
  each = { "Mass", "Velocity" },
  apply = function(object, params, out)
    if world.Gravity then
      out.addForce(object, world.Gravity.value * (-0.5 * object.Mass.value))
    end
  end,
}
)lua"},
        {"Dynamics", "addForceToPoint",
         R"lua(-- A jet on the right of every body blows upwards, so the body turns.
return interaction {
  name = "Dynamics <- Jet",
  calls = "Dynamics",
  reads = { "Position", "Rotation", "Velocity" },
  each = { "Position", "Rotation", "Velocity" },
  apply = function(object, params, out)
    local arm = vec2(0.1, 0):turned(object.Rotation.value)
    out.addForceToPoint(object, object.Position.value + arm, vec2(0, 2))
  end,
}
)lua"},
        {"Dynamics", "addTorque", R"lua(-- A spring turns every body upright.
return interaction {
  name = "Dynamics <- Uprightness",
  calls = "Dynamics",
  reads = { "Rotation", "Velocity" },
  each = { "Rotation", "Velocity" },
  params = { stiffness = { default = 5, min = 0, max = 1000, unit = "N m/rad", text = "Of the spring" } },
  apply = function(object, params, out)
    out.addTorque(object, -params.stiffness * object.Rotation.value)
  end,
}
)lua"},
        {"Dynamics", "addDrag",
         R"lua(-- Thick air: it resists motion and turning, and the resistance follows the velocity within a frame.
return interaction {
  name = "Dynamics <- Thick air",
  calls = "Dynamics",
  reads = { "Position", "Velocity" },
  each = { "Position", "Velocity" },
  apply = function(object, params, out)
    out.addDrag{ object = object, point = object.Position.value, xx = 2, yy = 2, angular = 0.1 }
  end,
}
)lua"},
        {"Dynamics", "tellRate",
         R"lua(-- A spring to the middle of the world, and how fast it lets a body swing.
return interaction {
  name = "Dynamics <- Spring",
  calls = "Dynamics",
  reads = { "Position", "Velocity", "Mass" },
  each = { "Position", "Velocity", "Mass" },
  params = { stiffness = { default = 10, min = 0, max = 1000, unit = "N/m", text = "Of the spring" } },
  apply = function(object, params, out)
    out.addForce(object, object.Position.value * -params.stiffness)
    out.tellRate(object, math.sqrt(params.stiffness / object.Mass.value))
  end,
}
)lua"},
        {"Dynamics", "addImpulse",
         R"lua(-- What touches something is kicked upwards, once for each touch: 2 m/s.
return interaction {
  name = "Dynamics <- Kick",
  calls = "Dynamics",
  reads = { "contacts", "Position", "Velocity", "Mass" },
  once = true,
  apply = function(world, params, out)
    for _, pair in ipairs(world.contacts.begun) do
      for _, object in ipairs({ pair.a, pair.b }) do
        if object.Velocity then
          out.addImpulse(object, object.Position.value, vec2(0, 2 * object.Mass.value))
        end
      end
    end
  end,
}
)lua"},
    }};
    return examples;
}

} // namespace trembler::lua
