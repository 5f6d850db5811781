return interaction { name = "Sound <- T", calls = "Sound", reads = { "Velocity", "Fixed" },
  pairs = { first = { "Velocity" }, second = { "Fixed" }, touching = true },
  apply = function(a, b, p, out) out.rub{ object = a, other = b, point = vec2(0, 0), normal = vec2(0, 1), force = 1, bandwidth = 9 } end }
