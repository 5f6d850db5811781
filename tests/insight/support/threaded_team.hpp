// A team whose members are threads of one process instead of MPI's processes.
#pragma once

#include "insight/spread/team.hpp"

#include <barrier>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace trembler::insight {

class ThreadedTeam : public Team {
public:
    struct Shared {
        explicit Shared(int size) : told(static_cast<std::size_t>(size)), barrier(size) {}
        std::vector<std::string> told;
        std::barrier<> barrier;
    };
    ThreadedTeam(std::shared_ptr<Shared> shared, int rank) : shared_(std::move(shared)), rank_(rank) {}
    [[nodiscard]] int rank() const override { return rank_; }
    [[nodiscard]] int size() const override { return static_cast<int>(shared_->told.size()); }
    [[nodiscard]] std::vector<std::string> exchange(std::string const& mine) override {
        shared_->told[static_cast<std::size_t>(rank_)] = mine;
        shared_->barrier.arrive_and_wait();
        std::vector<std::string> all = shared_->told;
        shared_->barrier.arrive_and_wait(); // all have read before any member writes the next one
        return all;
    }

    /// Calls `work` in every member and returns when all have ended.
    static void run(int size, std::function<void(Team&)> const& work) {
        auto const shared = std::make_shared<Shared>(size);
        std::vector<std::thread> members;
        for (int rank = 0; rank < size; ++rank) {
            members.emplace_back([&, rank] {
                ThreadedTeam team(shared, rank);
                work(team);
            });
        }
        for (std::thread& member : members) {
            member.join();
        }
    }

private:
    std::shared_ptr<Shared> shared_;
    int rank_;
};

} // namespace trembler::insight
