// Examples of the functions of the resolvers Frame and Population.
#include "lua/reference/function_examples/by_resolver.hpp"

#include <array>

namespace trembler::lua {

std::span<FunctionExample const> worldExamples() {
    static constexpr std::array<FunctionExample, 3> examples{{
        {"Frame", "splitFrame",
         R"lua(-- While anything is faster than 5 m/s, frames are computed in four parts.
return interaction {
  name = "Frame <- Speed",
  calls = "Frame",
  reads = { "Velocity" },
  each = { "Velocity" },
  apply = function(object, params, out)
    if object.Velocity.value:length() > 5 then
      out.splitFrame(1 / 240)
    end
  end,
}
)lua"},
        {"Population", "createObject", R"lua(-- A tap: whatever is called "tap" drips a ball every second.
return interaction {
  name = "Population <- Tap",
  calls = "Population",
  reads = { "Name", "Position" },
  each = { "Name", "Position" },
  restless = true,
  store = { object = { made = 0, wait = 0 } },
  apply = function(object, params, out, store, frame)
    if object.Name.value ~= "tap" then return end
    store.object.wait = store.object.wait - frame.duration
    if store.object.wait <= 0 then
      store.object.wait = 1
      store.object.made = store.object.made + 1
      out.createObject{ part = "rubber ball", position = object.Position.value - vec2(0, 0.5),
                        maker = object, number = store.object.made }
    end
  end,
}
)lua"},
        {"Population", "destroyObject",
         R"lua(-- A drain: what falls deeper than 50 m is taken out of the world.
return interaction {
  name = "Population <- Drain",
  calls = "Population",
  reads = { "Position", "Velocity" },
  each = { "Position", "Velocity" },
  apply = function(object, params, out)
    if object.Position.value.y < -50 then
      out.destroyObject(object)
    end
  end,
}
)lua"},
    }};
    return examples;
}

} // namespace trembler::lua
