return interaction { name = "Frame <- T", calls = "Frame", reads = {}, each = {}, attached = true,
  params = { w = { default = "a", choices = { "a", "b" } }, on = { default = true }, v = { default = vec2(1, 2) } },
  apply = function(object, params, out) out.splitFrame(params.on and 0.01 or 0.1) end }
