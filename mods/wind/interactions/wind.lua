-- Quadratic drag of a body in a wind: F = 1/2 rho c A |w - v| (w - v).
--
-- A force is constant for a frame while the body moves on. tellRate states how fast the force varies, 1/s, so that the
-- engine takes steps that are short enough: here the rate at which the wind alone would bring the body to its speed.
local airDensity = 1.2 -- kg/m^3
local depth = 0.1      -- m, of the world

return interaction {
  name = "Dynamics <- Wind",
  text = "Within the cone in front of each fan the air moves at the fan's speed. It drags along every body in it, "
    .. "whose face is that of a square of the body's area.",
  calls = "Dynamics",
  reads = { "Position", "Rotation", "Velocity", "Mass", "Density" },
  attached = true,
  pairs = { first = { "Position", "Rotation" }, second = { "Position", "Velocity", "Mass", "Density" },
            within = "reach" },
  params = {
    speed = { default = 8, min = 0, max = 100, unit = "m/s", text = "How hard it blows" },
    half_angle = { default = 20, min = 0, max = 180, unit = "degrees", text = "From the middle of the cone to its edge" },
    reach = { default = 6, min = 0, max = 1000, unit = "m", text = "How far it blows" },
    drag = { default = 1.05, min = 0, max = 10, text = "Drag coefficient: 1.05 is that of a cube" },
  },
  apply = function(fan, body, params, out)
    local away = body.Position.value - fan.Position.value
    local ahead = vec2(1, 0):turned(fan.Rotation.value)
    if away:dot(ahead) < away:length() * math.cos(math.rad(params.half_angle)) then
      return
    end
    local relative = ahead * params.speed - body.Velocity.value
    local side = math.sqrt(body.Mass.value / (body.Density.value * depth))
    local perSpeed = 0.5 * airDensity * params.drag * side * depth * relative:length() -- N s/m
    out.addForce(body, relative * perSpeed)
    out.tellRate(body, 2 * perSpeed / body.Mass.value, false, false) -- d(v^2) = 2 v dv
  end,
}
