// Makes the changes of a what-if in a running world.
#pragma once

#include "insight/whatif/change.hpp"
#include "puzzle/session/run.hpp"

#include <vector>

namespace trembler::insight {

/// Makes the changes in a run that has reached the frame of the what-if, between frames; the run then counts
/// as no solution. What concerns objects that do not exist in it is left out. Changes of kind `input` are
/// left to the caller, who feeds the inputs, as are later inputs of grabs.
void apply(Registry const& registry, LevelRun& run, WhatIf const& whatIf);

/// The inputs that the grabs of a what-if consist of after their first frame.
[[nodiscard]] std::vector<RecordedInput> inputsOfGrabs(WhatIf const& whatIf);

/// Those of the run's inputs that come all the same. Without a grab there are neither its moves nor its
/// release.
[[nodiscard]] std::vector<RecordedInput> inputsLeft(std::span<RecordedInput const> inputs,
                                                    WhatIf const& whatIf);

} // namespace trembler::insight
