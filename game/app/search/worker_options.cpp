#include "game/app/search/worker_options.hpp"

#include "game/app/options/values/number_options.hpp"
#include "insight/spread/mpi_team.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trembler {

void addWorkerOptions(CLI::App& command, WorkerArguments& arguments) {
    addNumber(command, "--threads", arguments.threads, 1, 256,
              "Number of threads (default: one for each processor); the result does not depend on it");
    addFile(command, "--resume", arguments.resume, file_kinds::journal,
            "A file to which every finished run is added as it comes; what it already holds is not done "
            "again");
    command.add_flag(
        "--mpi", arguments.mpi,
        "Share the runs out among the processes that mpirun started; the result does not depend on "
        "their number");
}

WorkPlace::WorkPlace(WorkerArguments const& arguments) {
    if (arguments.mpi) {
        team_ = insight::mpiTeam();
    }
    if (!team_) {
        team_ = std::make_unique<insight::Team>();
    }
    if (arguments.resume) {
        journal_ = std::make_unique<insight::Journal>(*arguments.resume, *team_);
    }
    insight::WorkersOptions options;
    options.threads = arguments.threads;
    options.team = team_.get();
    options.journal = journal_.get();
    options.stop = [this, minutes = arguments.minutes] {
        return StopSignal::asked() || (minutes && seconds() > 60 * *minutes);
    };
    if (team_->leads()) {
        options.progress = [this](insight::WorkDone work) {
            progress_.say(fmt::format("{}: {} of {}", what_.empty() ? "runs" : what_, work.done, work.of));
        };
    }
    workers_ = std::make_unique<insight::Workers>(std::move(options));
}

WorkPlace::~WorkPlace() = default;

void WorkPlace::asLeader(std::function<void()> const& work) {
    std::string problem;
    if (leads()) {
        try {
            work();
        } catch (std::exception const& error) {
            problem = error.what();
        }
    }
    problem = team_->exchange(problem).front();
    if (!problem.empty()) {
        throw std::runtime_error(problem);
    }
}

double WorkPlace::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

} // namespace trembler
