return interaction { name = "Electricity <- T", calls = "Electricity", reads = { "Position", "Conductor" },
  pairs = { first = { "Conductor" }, second = { "Conductor" }, within = "r" }, params = { r = { default = 1, min = 0 } },
  apply = function(a, b, params, out) if alive(b) and not same(a, b) then out.addConnection(a, b) end end }
