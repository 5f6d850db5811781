#include "insight/spread/workers.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace trembler::insight {
namespace {

using Results = std::vector<std::optional<std::string>>;

/// The pieces of one member, and the threads that do them.
class OwnShare {
public:
    OwnShare(std::vector<std::size_t> mine, std::span<std::string const> keys,
             std::function<std::string(std::size_t)> const& work, WorkersOptions const& options)
        : mine_(std::move(mine)), keys_(keys), work_(work), options_(options) {}

    void run(int threads, std::size_t of, Results& results) {
        auto const count = std::min<std::size_t>(static_cast<std::size_t>(threads), mine_.size());
        if (count == 0) {
            return;
        }
        working_ = count;
        std::vector<std::thread> pool;
        pool.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            pool.emplace_back([this, &results] { doPieces(results); });
        }
        {
            std::unique_lock lock(mutex_);
            while (!ended_.wait_for(lock, std::chrono::milliseconds(250), [this] { return working_ == 0; })) {
                if (options_.progress) {
                    std::size_t const done = of - mine_.size() + finished_;
                    lock.unlock();
                    options_.progress({done, of});
                    lock.lock();
                }
            }
        }
        for (std::thread& thread : pool) {
            thread.join();
        }
    }

    [[nodiscard]] bool stopped() const { return stopped_; }
    [[nodiscard]] std::size_t finished() const { return finished_; }
    /// The failure of the piece with the least index, in its words.
    [[nodiscard]] std::optional<std::pair<std::size_t, std::string>> const& failure() const {
        return failure_;
    }

private:
    void doPieces(Results& results) {
        while (!failed_) {
            std::size_t const next = next_++;
            if (next >= mine_.size()) {
                break;
            }
            if (options_.stop && options_.stop()) {
                stopped_ = true;
                break;
            }
            std::size_t const index = mine_[next];
            try {
                std::string result = work_(index);
                if (options_.journal != nullptr) {
                    options_.journal->add(keys_[index], result);
                }
                results[index] = std::move(result); // each piece has a place of its own
                ++finished_;
            } catch (std::exception const& error) {
                std::lock_guard const lock(mutex_);
                if (!failure_ || index < failure_->first) {
                    failure_.emplace(index, error.what());
                }
                failed_ = true;
            }
        }
        std::lock_guard const lock(mutex_);
        if (--working_ == 0) {
            ended_.notify_all();
        }
    }

    std::vector<std::size_t> mine_;
    std::span<std::string const> keys_;
    std::function<std::string(std::size_t)> const& work_;
    WorkersOptions const& options_;
    std::atomic<std::size_t> next_{0};
    std::atomic<std::size_t> finished_{0};
    std::atomic<bool> stopped_{false};
    std::atomic<bool> failed_{false};
    std::mutex mutex_;
    std::condition_variable ended_;
    std::size_t working_ = 0;
    std::optional<std::pair<std::size_t, std::string>> failure_;
};

Team& alone() {
    static Team team;
    return team;
}

int threadsAsked(int asked) {
    int const most = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return asked > 0 ? asked : most;
}

} // namespace

Workers::Workers(WorkersOptions options)
    : options_(std::move(options)), threads_(threadsAsked(options_.threads)),
      team_(options_.team == nullptr ? &alone() : options_.team) {}

std::vector<std::optional<std::string>> Workers::share(std::span<std::string const> keys,
                                                       std::function<std::string(std::size_t)> const& work) {
    Results results(keys.size());
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (options_.journal != nullptr) {
            results[i] = options_.journal->find(keys[i]);
        }
        if (!results[i]) {
            missing.push_back(i);
        }
    }
    auto const members = static_cast<std::size_t>(team_->size());
    std::vector<std::size_t> mine;
    for (std::size_t i = static_cast<std::size_t>(team_->rank()); i < missing.size(); i += members) {
        mine.push_back(missing[i]);
    }
    OwnShare own(mine, keys, work, options_);
    own.run(threads_, mine.size(), results);
    if (members == 1) {
        done_ += own.finished();
        stopped_ = stopped_ || own.stopped();
        if (own.failure()) {
            throw std::runtime_error(own.failure()->second);
        }
        return results;
    }
    nlohmann::json answer = {{"stopped", own.stopped()}, {"results", nlohmann::json::array()}};
    for (std::size_t const index : mine) {
        if (results[index]) {
            answer["results"].push_back({index, *results[index]});
        }
    }
    if (own.failure()) {
        answer["failure"] = {own.failure()->first, own.failure()->second};
    }
    std::optional<std::pair<std::size_t, std::string>> first;
    for (std::string const& text : team_->exchange(answer.dump())) {
        nlohmann::json const heard = nlohmann::json::parse(text);
        stopped_ = stopped_ || heard["stopped"].get<bool>();
        for (nlohmann::json const& entry : heard["results"]) {
            results[entry[0].get<std::size_t>()] = entry[1].get<std::string>();
        }
        done_ += heard["results"].size();
        if (heard.contains("failure") && (!first || heard["failure"][0].get<std::size_t>() < first->first)) {
            first.emplace(heard["failure"][0].get<std::size_t>(), heard["failure"][1].get<std::string>());
        }
    }
    if (first) {
        throw std::runtime_error(first->second);
    }
    return results;
}

} // namespace trembler::insight
