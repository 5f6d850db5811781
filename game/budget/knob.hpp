// What there is to choose about how exactly an effect is computed in a scene, what each choice costs and how
// far off it is.
#pragma once

#include "runtime/level/model/recorded_change.hpp"

#include <string>
#include <vector>

namespace trembler::budget {

/// How far off. Effects are compared by one unit: by how many metres a body that nothing else holds would be
/// off after one second, root of the mean square over the bodies that were looked at.
struct Error {
    double metres = 0;
    double share = 0; ///< of the effect's own size, for people: see Knob::of
};

/// One way to compute an effect: a detail level, the settings that count for it, and its period.
struct Option {
    std::string name;                  ///< "tree, opening angle 0.5, every 2 frames"
    std::vector<RecordedChange> makes; ///< all of what brings it about, whatever holds already
    double work = 1;                   ///< what it costs in comparison with the knob's other options
    Error error;
    std::string cannot; ///< what in the scene it cannot tell, so that it will not do; "" if it will
};

/// What there is to choose about one effect.
struct Knob {
    std::string effect;
    std::vector<Option> options;
    std::size_t current = 0;             ///< the one that the world has now
    std::vector<std::string> components; ///< titles of those whose time depends on the choice
    std::string of;                      ///< what Error::share is a share of: "of the force"
    std::string source;                  ///< where the errors come from, as a sentence
};

} // namespace trembler::budget
