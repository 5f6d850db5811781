// Work that takes long, beside the window: its results so far, its progress, and how to stop it.
#pragma once

#include "insight/spread/workers.hpp"

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace trembler::ui {

/// The interface of all background work, for results of any type. Window thread only, except where stated.
class AnyWork {
public:
    AnyWork() = default;
    virtual ~AnyWork() = default;
    AnyWork(AnyWork const&) = delete;
    AnyWork& operator=(AnyWork const&) = delete;

    /// No further piece of it is begun; its results so far remain. Returns at once.
    void stop() { stopAsked_ = true; }
    /// From any thread.
    [[nodiscard]] bool stopAsked() const { return stopAsked_; }
    [[nodiscard]] bool running() const { return running_; }
    /// The present step, as the work reports it; "" before its first report.
    [[nodiscard]] std::string step() const {
        std::lock_guard const lock(mutex_);
        return step_;
    }
    [[nodiscard]] insight::WorkDone done() const {
        std::lock_guard const lock(mutex_);
        return done_;
    }
    /// Why it ended early; nullptr: it did not.
    [[nodiscard]] std::exception_ptr failure() const {
        std::lock_guard const lock(mutex_);
        return failure_;
    }

    // For the work itself, from any thread.

    void say(std::string step) {
        std::lock_guard const lock(mutex_);
        step_ = std::move(step);
        done_ = {};
    }
    void progress(insight::WorkDone done) {
        std::lock_guard const lock(mutex_);
        done_ = done;
    }
    /// Workers on all processors, which stop() stops and which report their progress here.
    [[nodiscard]] insight::WorkersOptions workers() {
        insight::WorkersOptions options;
        options.stop = [this] { return stopAsked(); };
        options.progress = [this](insight::WorkDone done) { progress(done); };
        return options;
    }

protected:
    mutable std::mutex mutex_;
    std::string step_;
    insight::WorkDone done_;
    std::exception_ptr failure_;
    std::atomic<bool> stopAsked_{false};
    std::atomic<bool> running_{true};
};

template <class Result>
class BackgroundWork final : public AnyWork {
public:
    /// Begins at once, in a thread of its own. `work` must own, or be outlived by, all that it uses; the
    /// result is its return value and, before that, the values that it passes to show().
    explicit BackgroundWork(std::function<Result(BackgroundWork&)> work)
        : thread_([this, work = std::move(work)] {
              try {
                  show(work(*this));
              } catch (...) { // reported where the result is shown
                  std::lock_guard const lock(mutex_);
                  failure_ = std::current_exception();
              }
              running_ = false;
          }) {}
    /// Stops it and waits until the pieces that have begun are done.
    ~BackgroundWork() override {
        stop();
        wait();
    }

    /// The newest result, which never changes; nullptr while there is none.
    [[nodiscard]] std::shared_ptr<Result const> result() const {
        std::lock_guard const lock(mutex_);
        return result_;
    }
    /// Until it has ended, for tests.
    void wait() {
        if (thread_.joinable()) {
            thread_.join();
        }
    }
    /// From the work's own thread.
    void show(Result result) {
        auto made = std::make_shared<Result const>(std::move(result));
        std::lock_guard const lock(mutex_);
        result_ = std::move(made);
    }

private:
    std::shared_ptr<Result const> result_;
    std::thread thread_; // the last, as it uses the others
};

} // namespace trembler::ui
