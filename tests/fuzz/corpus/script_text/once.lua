return interaction { name = "Population <- T", calls = "Population", reads = { "contacts" }, once = true, restless = true,
  store = { script = { n = 0 } }, limits = { calls = 5, log_lines = 1, memory = 600000 },
  apply = function(world, params, out, store)
    store.script.n = store.script.n + 1
    for _, pair in ipairs(world.contacts.ended) do log(alive(pair.a)) end
    out.createObject{ part = "rubber ball", position = vec2(0, 2), maker = world, number = store.script.n }
  end }
