-- Lenz's rule: what is induced acts against its cause. A current i in n wires of length l feels the force n l i x B, and
-- the magnet feels the opposite one. The work that this takes from the motion is what the current does in the circuit;
-- without this interaction the lamp would be lit for nothing.
--
-- Current and voltage are those that the circuit has now, found by another simulation from what the first interaction
-- of this mod has added to the coil's EMF. So the force is a frame or two late, as everything is that passes from one
-- simulation to another.
local constant = 1e-7  -- N/A^2, mu0 / 4 pi
local softening = 0.05 -- m

local function currentOf(coil)
  for _, entry in ipairs(world["Electrical quantities"].objects) do
    if same(entry.object, coil) then
      return coil.emf.induced < 0 and -entry.current or entry.current
    end
  end
  return 0
end

return interaction {
  name = "Dynamics <- Induction",
  text = "Brakes a magnet that moves past a coil through which current flows, and the coil the other way.",
  calls = "Dynamics",
  reads = { "Position", "Rotation", "Velocity", "Mass", "Fixed", "emf", "Electrical quantities", "magnetic_poles",
    "magnetic_strength", "magnet" },
  attached = true,
  pairs = { first = { "Position", "emf" },
            second = { "Position", "Rotation", "magnetic_poles", "magnetic_strength", "magnet" }, within = "reach" },
  params = {
    wire = { default = 100, min = 0, max = 1e6, unit = "m", text = "Wires times their length" },
    reach = { default = 5, min = 0, max = 1000, unit = "m", text = "Magnets farther away are left out" },
  },
  apply = function(coil, magnet, params, out)
    local current = currentOf(coil)
    if current == 0 then return end
    local strength = magnet.magnetic_strength.strength * magnet.magnet.level
    local poles = magnet.magnetic_poles
    for which, sign in pairs({ north = 1, south = -1 }) do
      if poles.poles == which or poles.poles == "both" then
        local arm = poles[which]:turned(magnet.Rotation.value)
        local away = coil.Position.value - magnet.Position.value - arm
        local square = away:dot(away) + softening * softening
        local b = away * (constant * sign * strength / (square * math.sqrt(square)))
        local force = vec2(-b.y, b.x) * (params.wire * current) -- on the coil
        if not coil.Fixed then out.addForceToPoint(coil, coil.Position.value, force) end
        if not magnet.Fixed then
          out.addForceToPoint(magnet, magnet.Position.value + arm, -force)
          local speed = magnet.Velocity and magnet.Velocity.value:length() or 0
          if magnet.Mass and speed > 0 then
            out.tellRate(magnet, force:length() / (magnet.Mass.value * speed), false, false)
          end
        end
      end
    end
  end,
}
