// A team of processes that mpirun started.
#pragma once

#include "insight/spread/team.hpp"

#include <memory>

namespace trembler::insight {

/// The team of all processes of MPI's world. To be called at most once in a program, from the thread that
/// will use the team. Started without mpirun, it is a team of one. Throws std::invalid_argument if the module
/// that knows MPI was not built or cannot be loaded: it is built beside the program if CMake finds MPI.
[[nodiscard]] std::unique_ptr<Team> mpiTeam();

} // namespace trembler::insight
