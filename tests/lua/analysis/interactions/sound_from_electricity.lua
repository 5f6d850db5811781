return interaction {
  name = "Sound <- Electricity",
  text = "Keeps the recording going of every object that has one for when it is on, and is.",
  calls = "Sound",
  reads = { "electrical_state", "sample" },
  once = true,
  apply = function(world, params, out)
    for _, entry in ipairs(world.electrical_state.objects) do
      if entry.on and alive(entry.object) and entry.object.sample and entry.object.sample.cue == "powered" then
        out.holdSample(entry.object)
      end
    end
  end,
}
