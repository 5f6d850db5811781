// Examples of the functions of the resolver Electricity.
#include "lua/reference/function_examples/by_resolver.hpp"

#include <array>

namespace trembler::lua {

std::span<FunctionExample const> electricityExamples() {
    static constexpr std::array<FunctionExample, 6> examples{{
        {"Electricity", "addConnection",
         R"lua(-- Conductors that touch once stay connected, as if they were welded.
return interaction {
  name = "Electricity <- Welding",
  calls = "Electricity",
  reads = { "contacts", "Conductor" },
  once = true,
  apply = function(world, params, out)
    for _, pair in ipairs(world.contacts.begun) do
      if pair.a.Conductor and pair.b.Conductor then
        out.addConnection(pair.a, pair.b)
      end
    end
  end,
}
)lua"},
        {"Electricity", "removeConnection",
         R"lua(-- Conductors that touch are connected, until they have been apart for a frame.
return interaction {
  name = "Electricity <- Touch",
  calls = "Electricity",
  reads = { "contacts", "Conductor" },
  once = true,
  apply = function(world, params, out)
    for _, pair in ipairs(world.contacts.begun) do
      if pair.a.Conductor and pair.b.Conductor then
        out.addConnection(pair.a, pair.b)
      end
    end
    for _, pair in ipairs(world.contacts.ended) do
      if alive(pair.a) and alive(pair.b) and pair.a.Conductor and pair.b.Conductor then
        out.removeConnection(pair.a, pair.b)
      end
    end
  end,
}
)lua"},
        {"Electricity", "holdConnection",
         R"lua(-- Conductors that are nearer than a metre are connected, for as long as they are.
return interaction {
  name = "Electricity <- Nearness",
  calls = "Electricity",
  reads = { "Position", "Conductor" },
  pairs = { first = { "Position", "Conductor" }, second = { "Position", "Conductor" }, within = 1 },
  apply = function(a, b, params, out)
    out.holdConnection(a, b)
  end,
}
)lua"},
        {"Electricity", "addVoltage", R"lua(-- Sources give more while they are turned: 1 V for each rad.
return interaction {
  name = "Electricity <- Angle",
  calls = "Electricity",
  reads = { "emf", "Rotation" },
  each = { "emf", "Rotation" },
  apply = function(object, params, out)
    out.addVoltage(object, object.Rotation.value)
  end,
}
)lua"},
        {"Electricity", "cutWire",
         R"lua(-- Wires of more than two metres tear. Nothing happens to what interactions have connected.
return interaction {
  name = "Electricity <- Distance",
  calls = "Electricity",
  reads = { "G_E", "Position" },
  each = { "G_E", "Position" },
  apply = function(object, params, out)
    for _, wire in ipairs(object.G_E.connections) do
      if (wire.to.Position.value - object.Position.value):length() > 2 then
        out.cutWire(object, wire.to)
      end
    end
  end,
}
)lua"},
        {"Electricity", "blowFuse", R"lua(-- Fuses below the ground get wet and blow.
return interaction {
  name = "Electricity <- Damp",
  calls = "Electricity",
  reads = { "Fuse", "Position" },
  each = { "Fuse", "Position" },
  apply = function(object, params, out)
    if not object.Fuse.blown and object.Position.value.y < 0 then
      out.blowFuse(object)
    end
  end,
}
)lua"},
    }};
    return examples;
}

} // namespace trembler::lua
