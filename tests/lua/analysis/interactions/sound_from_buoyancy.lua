-- C++ keeps how much of each object is in each liquid. A script keeps numbers of one object, so this one is right
-- for what is in one liquid at a time, and silent for what is created in a liquid.
local slowest = 0.1 -- m/s into the liquid; below, it closes without a splash
local contact = 1e-4 -- s: bubbles close at once
local depth = 0.1 -- m: so deep is the world

return interaction {
  name = "Sound <- Buoyancy",
  text = "Strikes a liquid with the momentum that an object gives to what it newly displaces.",
  calls = "Sound",
  reads = { "immersion", "Position", "Rotation", "velocity" },
  each = { "Position", "velocity" },
  store = { object = { wet = 0, seen = false } },
  apply = function(object, params, out, store)
    local area = 0
    for _, entry in ipairs(world.immersion.entries) do
      if same(entry.object, object) then
        area = entry.area
        local gained = area - store.object.wet
        local speed = -object.velocity.value:dot(entry.up)
        local liquid = entry.liquid
        if store.object.seen and gained > 0 and speed > slowest and alive(liquid) and liquid.Position then
          local turn = liquid.Rotation and -liquid.Rotation.value or 0
          local momentum = entry.density * gained * depth * speed
          out.strike(liquid, object, (object.Position.value - liquid.Position.value):turned(turn),
            (-entry.up):turned(turn), momentum, contact, 0)
        end
      end
    end
    store.object.wet = area
    store.object.seen = true
  end,
}
