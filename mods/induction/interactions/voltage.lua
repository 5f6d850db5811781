-- "Objects flagged as inductors will be connected to the electrical source if they move through a magnetic field"
-- (7.3.2). Here they are the source, with the voltage that the law of induction gives.
--
-- The wires of a coil run straight into the picture, through the depth of the world, forward and back: one side of it
-- lies in this coil's place, the other so far away that nothing reaches it. On a charge that moves with a wire at the
-- velocity v acts v x B; over the length l of n wires that is the voltage n l (v x B).
local constant = 1e-7    -- N/A^2, mu0 / 4 pi
local softening = 0.05   -- m: no pole is nearer than this

-- The field (T) of a pole of that strength (A m) at a place that is so far from it.
local function field(strength, away)
  local square = away:dot(away) + softening * softening
  return away * (constant * strength / (square * math.sqrt(square)))
end

local function velocityAt(body, arm)
  local v = body.Velocity and body.Velocity.value or vec2(0, 0)
  local spin = body["Angular Velocity"] and body["Angular Velocity"].value or 0
  return v + vec2(-spin * arm.y, spin * arm.x)
end

return interaction {
  name = "Electricity <- Induction",
  text = "Induces a voltage in every coil through which the poles of a magnet move, or which moves past them.",
  calls = "Electricity",
  reads = { "Position", "Rotation", "Velocity", "Angular Velocity", "magnetic_poles", "magnetic_strength", "magnet" },
  attached = true,
  pairs = { first = { "Position" },
            second = { "Position", "Rotation", "magnetic_poles", "magnetic_strength", "magnet" }, within = "reach" },
  params = {
    wire = { default = 100, min = 0, max = 1e6, unit = "m", text = "Wires times their length" },
    reach = { default = 5, min = 0, max = 1000, unit = "m", text = "Magnets farther away are left out" },
  },
  apply = function(coil, magnet, params, out)
    local strength = magnet.magnetic_strength.strength * magnet.magnet.level
    if strength == 0 then return end
    local poles = magnet.magnetic_poles
    local voltage = 0
    for which, sign in pairs({ north = 1, south = -1 }) do
      if poles.poles == which or poles.poles == "both" then
        local arm = poles[which]:turned(magnet.Rotation.value)
        local b = field(sign * strength, coil.Position.value - magnet.Position.value - arm)
        local v = velocityAt(coil, vec2(0, 0)) - velocityAt(magnet, arm)
        voltage = voltage + params.wire * v:cross(b)
      end
    end
    if voltage ~= 0 then
      out.addVoltage(coil, voltage)
    end
  end,
}
