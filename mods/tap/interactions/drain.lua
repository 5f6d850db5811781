-- The other end of an object's life. A call takes effect in the next frame, so whatever reads the drop in this
-- frame still finds it.
return interaction {
  name = "Population <- Drain",
  text = "Takes everything out of the world that touches a drain and is made of the drain's material.",
  calls = "Population",
  reads = { "Material" },
  attached = true,
  pairs = { first = {}, second = { "Material" }, touching = true },
  params = {
    material = { default = "water", text = "What it takes: the name of a material" },
  },
  apply = function(drain, thing, params, out)
    if thing.Material.value == params.material then
      out.destroyObject(thing)
    end
  end,
}
