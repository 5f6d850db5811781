// The mod that `trembler mod new` makes: small, complete and working.
#include "lua/mods/mod.hpp"
#include "lua/mods/mod_name.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

constexpr char const* modText = R"({{
  "name": "{0}",
  "version": "0.1",
  "author": "you",
  "licence": "CC0-1.0",
  "text": "What it is for."
}}
)";

constexpr char const* scriptText =
    R"(-- One file is one interaction: it reads what it declares and calls functions of one resolver.
return interaction {{
  name = "Dynamics <- {0}",
  text = "Pushes every object that names this script.",
  calls = "Dynamics",                  -- the resolver; `trembler components` lists them with their functions
  reads = {{ "Velocity" }},              -- properties, by their names or by their keys in level files
  attached = true,                     -- applied to objects that name it under "scripts" ...
  each = {{ "Velocity" }},               -- ... and have these properties
  params = {{
    force = {{ default = 5, min = 0, max = 1000, unit = "N", text = "How hard it pushes" }},
    top_speed = {{ default = 10, min = 0, max = 100, unit = "m/s", text = "Faster objects are not pushed" }},
  }},
  apply = function(object, params, out, store, frame)
    if object.Velocity.value.x < params.top_speed then
      out.addForce(object, vec2(params.force, 0))
    end
  end,
}}
)";

constexpr char const* levelText = R"({{
  "version": 2,
  "title": "{1}",
  "text": "The block is pushed along the ice to the wall.",
  "mods": ["{0}"],
  "demonstration": true,
  "world": {{"gravity": [0, {2}], "bounds": [-4, -0.5, 8, 3]}},
  "objects": [
    {{"name": "ice", "at": [0, -0.15],
     "properties": {{"material": "stone", "friction": 0, "fixed": true,
                    "shape": [{{"form": "box", "width": 7.6, "height": 0.3}}]}}}},
    {{"name": "wall", "at": [3, 0.5],
     "properties": {{"material": "stone", "fixed": true,
                    "shape": [{{"form": "box", "width": 0.3, "height": 1}}]}}}},
    {{"name": "block", "at": [-2, 0.25],
     "properties": {{"material": "wood", "friction": 0, "shape": [{{"form": "box", "width": 0.5, "height": 0.5}}],
                    "scripts": [{{"script": "Dynamics <- {0}", "set": [{{"param": "force", "number": 20}}]}}]}}}}
  ],
  "goals": {{"touching": ["block", "wall"], "id": "arrived"}},
  "solutions": [{{"name": "hands off", "placements": []}}]
}}
)";

void writeInto(fs::path const& path, std::string const& text) {
    makeFolder(path.parent_path());
    trembler::writeFile(path, text);
}

} // namespace

void writeNewMod(fs::path const& folder, std::string const& name) {
    if (!isModName(name)) {
        throw std::invalid_argument(
            fmt::format("'{}' is no name of a mod; expected small letters, digits and -", name));
    }
    std::error_code error;
    if (fs::exists(folder, error)) {
        throw std::invalid_argument(fmt::format("{} is there already", folder.string()));
    }
    writeInto(folder / "mod.json", fmt::format(modText, name));
    writeInto(folder / "interactions" / "push.lua", fmt::format(scriptText, name));
    writeInto(folder / "levels" / "1-push.json", fmt::format(levelText, name, "Push", -earthGravity));
    writeInto(folder / "tests" / "push.json",
              fmt::format(levelText, name, "It is pushed to the wall", -earthGravity));
}

} // namespace trembler::lua
