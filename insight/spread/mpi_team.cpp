#include "insight/spread/mpi_team.hpp"

#include <stdexcept>

#ifdef TREMBLER_HAS_MPI
// The C++ bindings, which MPI 3 has removed, would need a library of their own.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <algorithm>
#include <limits>
#include <mpi.h>
#endif

namespace trembler::insight {

#ifdef TREMBLER_HAS_MPI

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
            all.emplace_back(sender == rank_ ? mine
                                             : std::string(sizes[static_cast<std::size_t>(sender)], '\0'));
            send(all.back(), sender);
        }
        return all;
    }

private:
    /// In pieces, as MPI counts bytes in an int.
    static void send(std::string& text, int sender) {
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

std::unique_ptr<Team> mpiTeam() {
    return std::make_unique<MpiTeam>();
}

#else

std::unique_ptr<Team> mpiTeam() {
    throw std::invalid_argument("--mpi: this program was built without MPI; install libopenmpi-dev (scripts/"
                                "install clusters) and build it again");
}

#endif

} // namespace trembler::insight
