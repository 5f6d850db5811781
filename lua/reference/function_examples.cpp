#include "lua/reference/function_examples.hpp"

#include <array>

namespace trembler::lua {
namespace {

constexpr std::array<FunctionExample, 22> examples{{
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
    {"Dynamics", "tellRate", R"lua(-- A spring to the middle of the world, and how fast it lets a body swing.
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
    {"Dynamics", "addImpulse", R"lua(-- What touches something is kicked upwards, once for each touch: 2 m/s.
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
    {"Sound", "strike", R"lua(-- What touches something rings as if a hammer had hit it.
return interaction {
  name = "Sound <- Hammer",
  calls = "Sound",
  reads = { "contacts" },
  once = true,
  apply = function(world, params, out)
    for _, pair in ipairs(world.contacts.begun) do
      out.strike{ object = pair.a, other = pair.b, point = vec2(0, 0), normal = vec2(0, 1),
                  impulse = 0.1, contact = 0.001 }
    end
  end,
}
)lua"},
    {"Sound", "rub", R"lua(-- Whatever rests on something fixed hums.
return interaction {
  name = "Sound <- Hum",
  calls = "Sound",
  reads = { "Velocity", "Fixed" },
  pairs = { first = { "Velocity" }, second = { "Fixed" }, touching = true },
  apply = function(body, ground, params, out)
    out.rub{ object = body, other = ground, point = vec2(0, 0), normal = vec2(0, 1),
             force = 0.5, bandwidth = 200 }
  end,
}
)lua"},
    {"Sound", "playSample", R"lua(-- Everything with a recording plays it once when the level begins.
return interaction {
  name = "Sound <- Beginning",
  calls = "Sound",
  reads = { "Sample" },
  each = { "Sample" },
  store = { object = { played = false } },
  apply = function(object, params, out, store)
    if not store.object.played then
      store.object.played = true
      out.playSample(object, 0.5)
    end
  end,
}
)lua"},
    {"Sound", "holdSample", R"lua(-- Everything with a recording plays it over and over.
return interaction {
  name = "Sound <- Repetition",
  calls = "Sound",
  reads = { "Sample" },
  each = { "Sample" },
  apply = function(object, params, out)
    out.holdSample(object)
  end,
}
)lua"},
    {"Frame", "splitFrame", R"lua(-- While anything is faster than 5 m/s, frames are computed in four parts.
return interaction {
  name = "Frame <- Speed",
  calls = "Frame",
  reads = { "Velocity" },
  each = { "Velocity" },
  apply = function(object, params, out)
    if object.Velocity.value:length() > 5 then
      out.splitFrame(1 / 240)
    end
  end,
}
)lua"},
    {"Population", "createObject", R"lua(-- A tap: whatever is called "tap" drips a ball every second.
return interaction {
  name = "Population <- Tap",
  calls = "Population",
  reads = { "Name", "Position" },
  each = { "Name", "Position" },
  restless = true,
  store = { object = { made = 0, wait = 0 } },
  apply = function(object, params, out, store, frame)
    if object.Name.value ~= "tap" then return end
    store.object.wait = store.object.wait - frame.duration
    if store.object.wait <= 0 then
      store.object.wait = 1
      store.object.made = store.object.made + 1
      out.createObject{ part = "rubber ball", position = object.Position.value - vec2(0, 0.5),
                        maker = object, number = store.object.made }
    end
  end,
}
)lua"},
    {"Population", "destroyObject", R"lua(-- A drain: what falls deeper than 50 m is taken out of the world.
return interaction {
  name = "Population <- Drain",
  calls = "Population",
  reads = { "Position", "Velocity" },
  each = { "Position", "Velocity" },
  apply = function(object, params, out)
    if object.Position.value.y < -50 then
      out.destroyObject(object)
    end
  end,
}
)lua"},
}};

} // namespace

std::span<FunctionExample const> functionExamples() {
    return examples;
}

} // namespace trembler::lua
