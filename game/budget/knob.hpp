// The options for how exactly an effect is computed in a scene, with the cost and the error of each.
#pragma once

#include "runtime/level/model/recorded_change.hpp"

#include <string>
#include <vector>

namespace trembler::budget {

/// The error of an option. All effects are compared in one unit: the displacement in metres after one second
/// of a body that is otherwise free, as the root mean square over the bodies of the sample.
struct Error {
    double metres = 0;
    double share = 0; ///< relative to the size of the effect, for people: see Knob::of
};

/// One way to compute an effect: a detail level, the settings that count for it, and its period.
struct Option {
    std::string name; ///< "tree, opening angle 0.5, every 2 frames"
    std::vector<RecordedChange>
        makes;       ///< all changes that select it, including the changes that are in effect already
    double work = 1; ///< relative cost among the knob's options
    Error error;
    std::string cannot;     ///< the reason why the scene forbids the option; "": allowed
    bool lessOften = false; ///< a component runs less often than in every frame
};

/// The options for one effect.
struct Knob {
    std::string effect;
    std::vector<Option> options;
    std::size_t current = 0;             ///< index of the option that the world uses now
    std::vector<std::string> components; ///< titles of the components whose time depends on the option
    std::string of;                      ///< the quantity that Error::share is relative to: "of the force"
    std::string source;                  ///< where the errors come from, as a sentence
};

} // namespace trembler::budget
