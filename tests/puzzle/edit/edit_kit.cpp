#include "tests/puzzle/edit/edit_kit.hpp"

#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace trembler::edit {

GameData const& editData() {
    return gameData();
}

std::string fileText(std::filesystem::path const& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeText(std::filesystem::path const& path, std::string const& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::filesystem::path testFolder() {
    auto const* const test = testing::UnitTest::GetInstance()->current_test_info();
    auto const folder = std::filesystem::path(testing::TempDir()) /
                        (std::string("edit_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

std::string const& smallLevel() {
    static std::string const text = R"({
  "version": 2,
  "title": "small",
  "world": {"gravity": [0, -9.810], "bounds": [-5, -1, 10, 8]},
  "objects": [
    {"name": "table", "at": [0, -0.25],
     "properties": {"material": "stone", "fixed": true, "shape": [{"form": "box", "width": 10, "height": 0.5}]}},
    {"name": "left", "at": [-2, 0.25], "properties": {"material": "wood", "shape": [{"form": "box", "width": 0.5, "height": 0.5}]}},
    {"name": "right", "at": [2, 0.5], "angle_deg": 90.0,
     "properties": {"material": "iron", "shape": [{"form": "box", "width": 1, "height": 0.5}]}},

    {"name": "ball", "part": "rubber ball", "at": [0, 3]}
  ],
  "joints": [
    {"name": "pin", "form": "hinge", "a": "left", "at": [-2, 0.5]},
    {"name": "line", "form": "rope", "a": "left", "b": "right", "at": [-2, 0.25], "at_b": [2, 0.5]}
  ],
  "placing": [[-4, 1, 8, 3]],
  "toolbox": [{"part": "steel ball", "count": 2}],
  "goals": {"all": [{"touching": ["ball", "table"], "for": 1}, {"inside": {"object": "ball", "area": [-1, 0, 2, 1]}}]},
  "hints": ["wait"],
  "solutions": [{"name": "wait", "inputs": [{"frame": 3, "grab": "ball", "at": [0, 3]}, {"frame": 4, "release": true}]}]
}
)";
    return text;
}

LevelDocument smallDocument() {
    return LevelDocument::fromText(editData(), smallLevel(), {}, {});
}

std::string refusalOf(std::function<void()> const& what) {
    try {
        what();
    } catch (CommandError const& error) {
        return error.what();
    }
    return {};
}

} // namespace trembler::edit
