// Examples of the functions of the resolvers Buoyancy and Magnetics.
#include "lua/reference/function_examples/by_resolver.hpp"

#include <array>

namespace trembler::lua {

std::span<FunctionExample const> fieldExamples() {
    static constexpr std::array<FunctionExample, 3> examples{{
        {"Buoyancy", "setLinearGravity",
         R"lua(-- For what swims, things weigh more: this acceleration comes on top of the world's.
return interaction {
  name = "Buoyancy <- Lift",
  calls = "Buoyancy",
  reads = {},
  once = true,
  apply = function(world, params, out)
    out.setLinearGravity(world, vec2(0, -1))
  end,
}
)lua"},
        {"Magnetics", "enableMagnet",
         R"lua(-- Electromagnets that lie higher than half a metre are on, without any circuit.
return interaction {
  name = "Magnetics <- Height",
  calls = "Magnetics",
  reads = { "electromagnet", "Position" },
  each = { "electromagnet", "Position" },
  apply = function(object, params, out)
    if object.Position.value.y > 0.5 then
      out.enableMagnet(object)
    end
  end,
}
)lua"},
        {"Magnetics", "disableMagnet",
         R"lua(-- States why a magnet is off. It stays on if another interaction enables it.
return interaction {
  name = "Magnetics <- Nothing",
  calls = "Magnetics",
  reads = { "electromagnet" },
  each = { "electromagnet" },
  apply = function(object, params, out)
    out.disableMagnet(object)
  end,
}
)lua"},
    }};
    return examples;
}

} // namespace trembler::lua
