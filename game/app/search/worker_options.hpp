// The options of commands that run levels many times: threads, processes, going on with earlier work.
#pragma once

#include "game/app/options/files/outputs.hpp"
#include "game/app/progress.hpp"
#include "game/app/search/stop_signal.hpp"
#include "insight/spread/workers.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace trembler {

struct WorkerArguments {
    int threads = 0; ///< 0: one for each processor
    OutputTarget resume;
    bool mpi = false;
    std::optional<double> minutes;
};

/// Adds --threads, --resume and --mpi.
void addWorkerOptions(CLI::App& command, WorkerArguments& arguments);

/// The state of such a command while it works: its workers, which Ctrl-C and the end of the minutes stop,
/// their team and journal, and the progress on the terminal.
class WorkPlace {
public:
    /// Throws std::invalid_argument if there is no such team, OutputError if the journal cannot be written.
    explicit WorkPlace(WorkerArguments const& arguments);
    ~WorkPlace();

    [[nodiscard]] insight::Workers& workers() { return *workers_; }
    /// Whether this process prints and writes files.
    [[nodiscard]] bool leads() const { return workers_->team().leads(); }
    /// Does something in the leader only, such as opening files. If it throws, all members of the team throw,
    /// so that none waits for another for ever.
    void asLeader(std::function<void()> const& work);
    /// The present step of the work, for the progress line.
    void say(std::string what) { what_ = std::move(what); }
    void clearProgress() { progress_.clear(); }
    /// s since the beginning
    [[nodiscard]] double seconds() const;

private:
    StopSignal signal_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    Progress progress_;
    std::string what_;
    std::unique_ptr<insight::Team> team_;
    std::unique_ptr<insight::Journal> journal_;
    std::unique_ptr<insight::Workers> workers_;
};

} // namespace trembler
