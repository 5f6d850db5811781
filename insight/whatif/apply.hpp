// Makes the changes of a what-if in a running world.
#pragma once

#include "insight/whatif/change.hpp"
#include "puzzle/session/run.hpp"

#include <vector>

namespace trembler::insight {

/// The hand that a what-if's grab has for itself, 0 or 1, by the inputs that are known of the run. A world
/// has two hands, which files, recordings and scripts know as such; so it is one that holds nothing at the
/// moment, of two such the one that holds nothing as long as the grab lasts, of two such the second. If both
/// hold something, it is the second.
[[nodiscard]] int handOfGrab(std::span<RecordedInput const> inputs, WhatIf const& whatIf);

/// Makes the changes in a run that has reached the frame of the what-if, between frames; the run then counts
/// as no solution. Changes to objects that do not exist in it are left out. Changes of kind `input` are left
/// to the caller, who feeds the inputs, as are later inputs of grabs, whose hand is `hand`.
void apply(Registry const& registry, LevelRun& run, WhatIf const& whatIf, int hand = 1);

/// The inputs that the grabs of a what-if consist of after their first frame.
[[nodiscard]] std::vector<RecordedInput> inputsOfGrabs(WhatIf const& whatIf, int hand = 1);

/// The run's inputs that remain. If a grab is left out, so are its moves and its release. While a grab of the
/// what-if lasts, its hand does nothing else: it releases the object that it holds in the run, and grabs no
/// other.
[[nodiscard]] std::vector<RecordedInput> inputsLeft(std::span<RecordedInput const> inputs,
                                                    WhatIf const& whatIf, int hand = 1);

} // namespace trembler::insight
