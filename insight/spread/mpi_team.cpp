#include "insight/spread/mpi_team.hpp"

#include <fmt/format.h>

#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace trembler::insight {

std::unique_ptr<Team> mpiTeam() {
    std::error_code error;
    std::filesystem::path const file =
        std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "trembler-mpi.so";
    if (!std::filesystem::exists(file, error)) {
        throw std::invalid_argument(
            fmt::format("--mpi: there is no {}; install libopenmpi-dev (scripts/install clusters), and "
                        "configure and build the program again",
                        file.string()));
    }
    // Open MPI loads modules of its own, which look for its functions among the global ones. It stays loaded
    // until the program ends.
    void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
    using Make = Team*();
    auto* const make =
        module == nullptr ? nullptr : reinterpret_cast<Make*>(::dlsym(module, "tremblerMpiTeam"));
    if (make == nullptr) {
        char const* const why = ::dlerror();
        throw std::invalid_argument(
            fmt::format("--mpi: {} cannot be loaded: {}", file.string(), why == nullptr ? "" : why));
    }
    return std::unique_ptr<Team>(make());
}

} // namespace trembler::insight
