// Examples of the functions of the resolver Sound.
#include "lua/reference/function_examples/by_resolver.hpp"

#include <array>

namespace trembler::lua {

std::span<FunctionExample const> soundExamples() {
    static constexpr std::array<FunctionExample, 4> examples{{
        {"Sound", "strike", R"lua(-- What touches something rings as if a hammer had hit it.
return interaction {
  name = "Sound <- Hammer",
  calls = "Sound",
  reads = { "contacts" },
  once = true,
  apply = function(world, params, out)
    for _, pair in ipairs(world.contacts.begun) do
      out.strike{ object = pair.a, other = pair.b, point = vec2(0, 0), normal = vec2(0, 1),
                  impulse = 0.1, contact = 0.001 }
    end
  end,
}
)lua"},
        {"Sound", "rub", R"lua(-- Whatever rests on something fixed hums.
return interaction {
  name = "Sound <- Hum",
  calls = "Sound",
  reads = { "Velocity", "Fixed" },
  pairs = { first = { "Velocity" }, second = { "Fixed" }, touching = true },
  apply = function(body, ground, params, out)
    out.rub{ object = body, other = ground, point = vec2(0, 0), normal = vec2(0, 1),
             force = 0.5, bandwidth = 200 }
  end,
}
)lua"},
        {"Sound", "playSample", R"lua(-- Everything with a recording plays it once when the level begins.
return interaction {
  name = "Sound <- Beginning",
  calls = "Sound",
  reads = { "Sample" },
  each = { "Sample" },
  store = { object = { played = false } },
  apply = function(object, params, out, store)
    if not store.object.played then
      store.object.played = true
      out.playSample(object, 0.5)
    end
  end,
}
)lua"},
        {"Sound", "holdSample", R"lua(-- Everything with a recording plays it over and over.
return interaction {
  name = "Sound <- Repetition",
  calls = "Sound",
  reads = { "Sample" },
  each = { "Sample" },
  apply = function(object, params, out)
    out.holdSample(object)
  end,
}
)lua"},
    }};
    return examples;
}

} // namespace trembler::lua
