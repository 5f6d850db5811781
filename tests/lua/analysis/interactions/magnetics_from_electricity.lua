return interaction {
  name = "Magnetics <- Electricity",
  text = "Enables every electromagnet whose electrical state is on and disables every other.",
  calls = "Magnetics",
  reads = { "electrical_state", "electromagnet" },
  once = true,
  apply = function(world, params, out)
    for _, entry in ipairs(world.electrical_state.objects) do
      if alive(entry.object) and entry.object.electromagnet then
        if entry.on then
          out.enableMagnet(entry.object)
        else
          out.disableMagnet(entry.object)
        end
      end
    end
  end,
}
