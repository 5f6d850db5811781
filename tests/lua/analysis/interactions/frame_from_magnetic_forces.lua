local followedTurn = 0.6 -- rad, in a part at most
local wholeFrame = 1 / 60 -- s

return interaction {
  name = "Frame <- Magnetic Forces",
  text = "Asks for parts of a frame so short that the forces between the strongest magnets are followed.",
  calls = "Frame",
  reads = { "magnetic_force", "fixed" },
  once = true,
  apply = function(world, params, out)
    local most = 0
    for _, one in ipairs(world.magnetic_force.rates) do
      if one.rate > most and not (alive(one.object) and one.object.fixed) then
        most = one.rate
      end
    end
    if most > 0 and followedTurn / most < wholeFrame then
      out.splitFrame(followedTurn / most)
    end
  end,
}
