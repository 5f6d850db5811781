// A composite part for tests: a post with an arm that a motor swings within limits, and a slide beside them.
#pragma once

#include "runtime/level/read/read_part.hpp"
#include "tests/support/experiment.hpp"

#include <memory>
#include <string>
#include <utility>

namespace trembler {

class WithSwing : public Experiment {
protected:
    WithSwing() { parts.add(part(swingText())); }

    [[nodiscard]] static std::string swingText() {
        return R"({"name": "swing", "title": "Swing", "text": "Swings.", "main": "arm",
            "objects": [
              {"name": "post", "properties": {"material": "wood", "fixed": true,
               "shape": [{"form": "box", "width": 0.1, "height": 1}]}},
              {"name": "arm", "at": [0.3, 0.6], "angle_deg": 20, "properties": {"material": "wood",
               "shape": [{"form": "polygon", "corners": [[-0.3, -0.05], [0.4, -0.05], [0.4, 0.1]]}]}},
              {"name": "slide", "at": [-0.5, 0.4], "flipped": true, "properties": {"material": "steel",
               "shape": [{"form": "polygon", "corners": [[-0.1, -0.05], [0.15, -0.05], [0.1, 0.05]]}]}}],
            "joints": [
              {"form": "hinge", "a": "arm", "b": "post", "at": [0, 0.5], "limited": true, "lower_deg": -40,
               "upper_deg": 70, "motor": true, "motor_speed_deg": 90, "motor_strength": 20},
              {"form": "slider", "a": "slide", "b": "post", "at": [-0.5, 0.4], "axis": [1, 0.5],
               "limited": true, "lower": -0.05, "upper": 0.2, "motor": true, "motor_speed": 0.3,
               "motor_strength": 50}]})";
    }
    [[nodiscard]] static PartDefinition part(std::string const& text) {
        return readPart(gameData().registry, JsonDocument::parse(text, "part.json"));
    }
    /// A level with earth below 0 and gravity; `more` are further members.
    [[nodiscard]] static LevelFile level(std::string const& objects, std::string const& more = "") {
        return readLevel(gameData().registry,
                         JsonDocument::parse(R"({"version": 2, "title": "t",
            "world": {"gravity": [0, -9.81]}, "objects": [{"name": "earth", "at": [0, -0.5],
             "properties": {"material": "stone", "fixed": true,
                            "shape": [{"form": "box", "width": 20, "height": 1}]}})" +
                                                 (objects.empty() ? "" : ", " + objects) + "]" + more + "}",
                                             "level.json"));
    }
    [[nodiscard]] std::unique_ptr<Session> open(LevelFile from) const {
        return std::make_unique<Session>(gameData().registry, parts, std::move(from));
    }
    static std::uint64_t hashAfter(Session& session, int frames) {
        session.start();
        for (int i = 0; i < frames; ++i) {
            session.step();
        }
        std::uint64_t const hash = session.world().stateHash();
        session.stop();
        return hash;
    }

    PartLibrary parts = gameData().parts;
};

} // namespace trembler
