return interaction {
  name = "Population <- Player",
  text = "Destroys every object that the player removed.",
  calls = "Population",
  reads = { "player_commands" },
  once = true,
  apply = function(world, params, out)
    for _, removal in ipairs(world.player_commands.removals) do
      if alive(removal.object) then
        out.destroyObject(removal.object)
      end
    end
  end,
}
