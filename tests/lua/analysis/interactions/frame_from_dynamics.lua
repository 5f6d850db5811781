local followedTurn = 0.6 -- rad, in a part at most
local wholeFrame = 1 / 60 -- s

return interaction {
  name = "Frame <- Dynamics",
  text = "Asks for parts of a frame so short that the fastest force is followed.",
  calls = "Frame",
  reads = { "force_rates" },
  once = true,
  apply = function(world, params, out)
    local rate = world.force_rates.swinging
    if rate > 0 and followedTurn / rate < wholeFrame then
      out.splitFrame(followedTurn / rate)
    end
  end,
}
