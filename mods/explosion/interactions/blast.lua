-- The world is flat: a blast spreads over circles, so what is left of it falls with the distance, and not with its
-- square. Of the momentum that passes a circle of radius r, a body of width w takes w / (2 pi r).
--
-- No store is needed: the other interaction of this mod takes the charge out of the world in the same frame, so this
-- interaction is applied to it once.
local depth = 0.1 -- m, of the world

local function isOn(object)
  for _, entry in ipairs(world["Electrical state"].objects) do
    if same(entry.object, object) then return entry.on end
  end
  return false
end

return interaction {
  name = "Dynamics <- Explosion",
  text = "When current flows through a charge, gives every body around it an impulse away from it: the body's share, by "
    .. "its width, of the momentum that the blast has.",
  calls = "Dynamics",
  reads = { "Position", "Mass", "Density", "Fixed", "Electrical state" },
  attached = true,
  pairs = { first = { "Position" }, second = { "Position", "Mass", "Density" }, within = "reach" },
  params = {
    momentum = { default = 100, min = 0, max = 1e6, unit = "N s", text = "Of the whole blast, in all directions" },
    reach = { default = 5, min = 0, max = 1000, unit = "m", text = "The greatest distance of its effect" },
  },
  apply = function(charge, body, params, out)
    if body.Fixed or not isOn(charge) then return end
    local away = body.Position.value - charge.Position.value
    local width = math.sqrt(body.Mass.value / (body.Density.value * depth)) -- of a square of its area
    local circle = 2 * math.pi * away:length()
    local share = circle > 2 * width and width / circle or 0.5 -- a body is on one side of the charge
    out.addImpulse(body, body.Position.value, away:unit() * (params.momentum * share))
  end,
}
