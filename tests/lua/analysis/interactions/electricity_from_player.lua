return interaction {
  name = "Electricity <- Player",
  text = "Removes one wire for every cut that the player made.",
  calls = "Electricity",
  reads = { "player_commands" },
  once = true,
  apply = function(world, params, out)
    for _, cut in ipairs(world.player_commands.cuts) do
      if alive(cut.a) and alive(cut.b) then
        out.cutWire(cut.a, cut.b)
      end
    end
  end,
}
