-- Objects that do not exist when a level starts: this interaction calls the resolver of the population (7.1.3).
--
-- The number of drops that are due follows from the time that the tap has run. Adding up fractions of drops from frame
-- to frame would add up rounding errors, too.
local margin = 1e-9 -- of a drop: a sum of sixtieths of a second may be a little less than the whole second

return interaction {
  name = "Population <- Tap",
  text = "Lets drops fall out of the lower end of every tap, at a steady rate.",
  calls = "Population",
  reads = { "Position", "Rotation" },
  attached = true,
  each = { "Position", "Rotation" },
  restless = true, -- time passes while nothing that it reads changes
  params = {
    rate = { default = 4, min = 0, max = 30, unit = "1/s", text = "How many drops fall in a second" },
    speed = { default = 0.5, min = 0, max = 20, unit = "m/s", text = "How fast they leave it" },
    mouth = { default = 0.3, min = 0, max = 10, unit = "m", text = "How far below the tap's centre they appear" },
    most = { default = 200, min = 0, max = 2000, text = "How many there are altogether" },
    part = { default = "drop", text = "What it lets fall: the name of a part" },
  },
  store = { object = { time = 0, made = 0 } },
  apply = function(tap, params, out, store, frame)
    store.object.time = store.object.time + frame.duration
    local due = math.min(math.floor(store.object.time * params.rate + margin), params.most)
    local down = vec2(0, -1):turned(tap.Rotation.value)
    while store.object.made < due do
      -- The maker and the number identify the new object: a call that is made twice makes one object.
      store.object.made = store.object.made + 1
      out.createObject {
        part = params.part,
        position = tap.Position.value + down * params.mouth,
        velocity = down * params.speed,
        maker = tap,
        number = store.object.made,
      }
    end
  end,
}
