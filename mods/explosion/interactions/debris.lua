-- Nothing is left of a charge that has gone off. The call is carried out in the next frame, so the blast, which is
-- applied in this one, still finds the charge; in the next one it does not. Two interactions that read the same state
-- agree without a connection between them.
return interaction {
  name = "Population <- Explosion",
  text = "Takes a charge out of the world when current flows through it.",
  calls = "Population",
  reads = { "Electrical state" },
  attached = true,
  each = {},
  apply = function(charge, params, out)
    for _, entry in ipairs(world["Electrical state"].objects) do
      if entry.on and same(entry.object, charge) then
        out.destroyObject(charge)
      end
    end
  end,
}
