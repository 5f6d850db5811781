// The module that knows MPI: loaded by mpi_team.cpp when --mpi asks for it, so that the program itself
// neither needs MPI nor takes the time to load it.
#include "insight/spread/team.hpp"

// The C++ bindings, which MPI 3 has removed, would need a library of their own.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <algorithm>
#include <cstddef>
#include <limits>
#include <mpi.h>
#include <string>
#include <vector>

namespace trembler::insight {
namespace {

class MpiTeam : public Team {
public:
    MpiTeam() {
        int provided = 0;
        // Other threads compute, but only this one communicates.
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
    }
    ~MpiTeam() override { MPI_Finalize(); }

    [[nodiscard]] int rank() const override { return rank_; }
    [[nodiscard]] int size() const override { return size_; }

    [[nodiscard]] std::vector<std::string> exchange(std::string const& mine) override {
        std::vector<unsigned long long> sizes(static_cast<std::size_t>(size_));
        unsigned long long const size = mine.size();
        MPI_Allgather(&size, 1, MPI_UNSIGNED_LONG_LONG, sizes.data(), 1, MPI_UNSIGNED_LONG_LONG,
                      MPI_COMM_WORLD);
        std::vector<std::string> all;
        for (int sender = 0; sender < size_; ++sender) {
            all.push_back(sender == rank_ ? mine
                                          : std::string(sizes[static_cast<std::size_t>(sender)], '\0'));
            broadcast(all.back(), sender);
        }
        return all;
    }

private:
    /// In pieces, as MPI counts bytes in an int.
    static void broadcast(std::string& text, int sender) {
        constexpr std::size_t most = std::numeric_limits<int>::max() / 2;
        for (std::size_t at = 0; at < text.size(); at += most) {
            MPI_Bcast(text.data() + at, static_cast<int>(std::min(most, text.size() - at)), MPI_CHAR, sender,
                      MPI_COMM_WORLD);
        }
    }

    int rank_ = 0;
    int size_ = 1;
};

} // namespace
} // namespace trembler::insight

/// The caller owns the team.
extern "C" trembler::insight::Team* tremblerMpiTeam() {
    return new trembler::insight::MpiTeam;
}
