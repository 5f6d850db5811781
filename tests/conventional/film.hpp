// A record of a world: where everything was in every frame.
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

/// A perturbed scene: a level, and what is done to it while it runs.
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
    std::vector<std::string> kinds{}; ///< how it was perturbed
};

/// What a level states of an object, as data: what the independent statement works with.
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
    std::string part{}; ///< which it was made from; empty: none
};
using Facts = std::map<std::string, Fact>;

struct Film {
    std::vector<std::map<std::string, Pose>> poses; ///< after each frame; [0] is the start
    std::vector<std::uint64_t> hits;                ///< frames in which the pair to be watched began to touch
    std::vector<std::uint64_t> rings;               ///< frames in which a script played the sound of the bell
    std::set<std::string> on;                       ///< devices that are on at the end
    std::set<std::string> joints;                   ///< that exist at the end

    [[nodiscard]] Pose end(std::string const& name) const;
};

/// Which of a world's effects a run is to have.
enum class Kind {
    physical,     ///< all
    bodies,       ///< rigid bodies and their weight
    conventional, ///< rigid bodies, their weight, and scripts
};

} // namespace trembler::conventional
