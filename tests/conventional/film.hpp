// A record of a world: the places of all objects in every frame.
#pragma once

#include "tests/conventional/geometry.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace trembler {
class World;
}

namespace trembler::conventional {

/// A perturbed scene: a level, and the player's inputs while it runs.
struct Setting {
    nlohmann::json level{}; ///< without solutions
    nlohmann::json inputs =
        nlohmann::json::array(); ///< as in a recorded solution, wires that are cut left out
    struct Cut {
        std::uint64_t frame = 1;
        std::string a{};
        std::string b{};
    };
    std::vector<Cut> cuts{};
    std::vector<std::string> kinds{}; ///< kinds of its perturbations
};

/// The statements of a level about an object, as data: the input of the independent statement.
struct Fact {
    Shape shape{};
    bool fixed = false;
    double mass = 0; ///< kg; 0: none
    bool conductor = false;
    bool source = false;
    bool earth = false;
    bool electromagnet = false;
    double strength = 0;       ///< A m
    double susceptibility = 0; ///< A m
    std::vector<Vec2> poles{}; ///< m, in the frame of the object
    double motorTorque = 0;    ///< N m
    Pose start{};
    std::string part{}; ///< the part from which it was made; empty: none
};
using Facts = std::map<std::string, Fact>;

struct Film {
    std::vector<std::map<std::string, Pose>> poses; ///< after each frame; [0] is the start
    std::vector<std::uint64_t> hits;                ///< frames in which the pair to be watched began to touch
    std::vector<std::uint64_t> rings;               ///< frames in which a script played the sound of the bell
    std::set<std::string> on;                       ///< devices that are on at the end
    std::set<std::string> joints;                   ///< the joints that exist at the end

    [[nodiscard]] Pose end(std::string const& name) const;
};

/// Which of a world's effects take part in a run.
enum class Kind {
    physical,     ///< all
    bodies,       ///< rigid bodies and their weight
    conventional, ///< rigid bodies, their weight, and scripts
};

} // namespace trembler::conventional
