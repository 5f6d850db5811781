// Shares out independent pieces of work over threads and processes.
#pragma once

#include "insight/spread/journal.hpp"
#include "insight/spread/team.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler::insight {

/// How much work is done, for progress.
struct WorkDone {
    std::size_t done = 0;
    std::size_t of = 0;
};

struct WorkersOptions {
    int threads = 0;                 ///< 0: one for each processor
    Team* team = nullptr;            ///< nullptr: this process alone
    Journal* journal = nullptr;      ///< nullptr: nothing is kept
    std::function<bool()> stop = {}; ///< asked often, from any thread; true: no further piece is begun
    /// Called about every quarter of a second, from the thread that called share(); in the leader only.
    std::function<void(WorkDone)> progress = {};
};

/// The results depend on neither the number of threads nor that of processes, nor on what a journal held
/// before, provided that each piece is a pure function of its key. One thread at a time may use it.
class Workers {
public:
    explicit Workers(WorkersOptions options);

    /// The results of all pieces, by index: work(i) is called, from any thread of any member of the team, for
    /// every key that the journal does not have. Keys must be unique in a program's run and state everything
    /// on which the result depends. A result is nothing if the work was stopped before it was done. Throws
    /// the first exception of any piece, in every member.
    [[nodiscard]] std::vector<std::optional<std::string>>
    share(std::span<std::string const> keys, std::function<std::string(std::size_t)> const& work);

    /// Whether any member was stopped in share() so far; the same in all members.
    [[nodiscard]] bool stopped() const { return stopped_; }
    /// Pieces done by share() so far in all members, those from the journal left out.
    [[nodiscard]] std::uint64_t done() const { return done_; }
    [[nodiscard]] int threads() const { return threads_; }
    [[nodiscard]] Team& team() const { return *team_; }

private:
    WorkersOptions options_;
    int threads_;
    Team* team_;
    bool stopped_ = false;
    std::uint64_t done_ = 0;
};

} // namespace trembler::insight
