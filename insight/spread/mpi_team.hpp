// A team of processes that mpirun started.
#pragma once

#include "insight/spread/team.hpp"

#include <memory>

namespace trembler::insight {

/// The team of all processes of MPI's world. To be called once in a program, from the thread that will use
/// the team. Throws std::invalid_argument if this program was built without MPI. Started without mpirun, it
/// is a team of one.
[[nodiscard]] std::unique_ptr<Team> mpiTeam();

} // namespace trembler::insight
