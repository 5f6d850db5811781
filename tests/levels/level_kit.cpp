#include "tests/levels/level_kit.hpp"

#include "puzzle/campaign/chapter.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/level/read/read_part.hpp"

#include <algorithm>

namespace trembler {

LevelKit::LevelKit() {
    registerEffects(registry);
    parts = loadParts(registry, sourceFolder() / "assets/parts");
}

LevelKit const& levelKit() {
    static LevelKit const all;
    return all;
}

std::filesystem::path sourceFolder() {
    return TREMBLER_SOURCE_DIR;
}

std::vector<std::filesystem::path> levelFiles() {
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(sourceFolder() / "levels")) {
        if (entry.path().extension() == ".json" && !isNotALevel(entry.path())) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string sampleLevel() {
    return R"({
  "version": 2,
  "title": "Something of everything",
  "text": "Not fun.",
  "world": {"gravity": [0, -9.81], "bounds": [-10, -2, 20, 12], "detail": {"gravity": "linear", "electricity": "two-wire"}},
  "objects": [
    {"name": "floor", "at": [0, -0.5], "properties": {"shape": [{"form": "box", "width": 20, "height": 1}], "fixed": true, "material": "stone", "friction": 0.5, "restitution": 0, "look": {"colour": "#909090"}}},
    {"name": "crate", "part": "crate", "at": [1, 0.3], "angle_deg": 5, "properties": {"velocity": [1, 0], "angular_velocity_deg": 30}},
    {"name": "ball", "part": "rubber ball", "at": [-1, 3], "properties": {"bullet": true, "density": false, "mass": 2}},
    {"name": "pill", "at": [-3, 2], "properties": {"shape": [{"form": "capsule", "width": 1, "radius": 0.2, "angle_deg": 30}, {"form": "polygon", "corners": [[0, 0], [0.3, 0], [0, 0.3]]}], "density": 500, "damping": {"linear": 0.1}, "collision": {"category": 2, "mask": 65535}}},
    {"name": "plus", "part": "battery +", "at": [-5, 1]},
    {"name": "minus", "part": "battery −", "at": [-4, 1]},
    {"name": "lamp", "part": "lamp", "at": [-4.5, 2]},
    {"name": "coil", "part": "electromagnet", "at": [4, 4]},
    {"name": "magnet", "part": "bar magnet", "at": [6, 1]}
  ],
  "joints": [
    {"name": "pin", "form": "hinge", "a": "crate", "b": "ball", "at": [0, 2], "limited": true, "lower_deg": -90, "upper_deg": 90, "motor": true, "motor_speed_deg": 10, "motor_strength": 5},
    {"form": "rope", "a": "pill", "at": [-3, 2], "at_b": [-3, 5], "length": 4},
    {"form": "spring", "a": "magnet", "b": "crate", "at": [6, 1], "at_b": [1, 0.3], "stiffness": 50, "damping_rate": 1, "break_force": 1000}
  ],
  "connections": [["plus", "lamp"], ["lamp", "minus"], ["plus", "coil"]],
  "placing": [[-9, 1, 3, 3], [[7, 0], [9, 0], [8, 3]]],
  "toolbox": [{"part": "steel bar", "count": 2}, {"part": "spanner"}],
  "goals": {"all": [
    {"on": "lamp", "for": 0.1, "id": "light"},
    {"any": [{"touching": ["crate", "floor"]}, {"moved": {"object": "crate", "by": 1, "towards": "right"}}]},
    {"count": {"of": ["crate", "ball"], "at_least": 1, "that": {"inside": {"object": "it", "area": [-10, -1, 20, 10], "called": "the yard"}}}},
    {"not": {"off": "lamp"}},
    {"sequence": [{"on": "lamp"}, {"touching": [{"part": "steel bar"}, "floor"]}]}
  ]},
  "hints": ["Wait."],
  "solutions": [
    {"name": "one", "placements": [{"part": "steel bar", "at": [-7, 2], "angle_deg": 30}],
     "inputs": [{"frame": 1, "grab": "ball", "at": [-1, 3]}, {"frame": 2, "move": [0, 4]}, {"frame": 3, "release": true},
                {"frame": 4, "cut": ["plus", "coil"]}, {"frame": 5, "remove": "steel bar 1"}],
     "changes": [{"frame": 3, "detail": {"gravity": "linear"}}, {"frame": 9, "period": {"Linear Gravity DPS": 2}}, {"frame": 9, "setting": {"solver": {"substeps": 2}}}],
     "expect": "unsolved", "frames": 60}
  ]
}
)";
}

} // namespace trembler
