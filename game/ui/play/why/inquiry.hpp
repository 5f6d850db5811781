// Answers a question about the player's run beside the game.
#pragma once

#include "insight/why/answer.hpp"
#include "puzzle/data/game_data.hpp"

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// A run as it can be repeated: its level, the placements and inputs, and its length.
struct RunAsked {
    LevelFile level;
    Solution solution;
    std::uint64_t frames = 0;
};

/// One question at a time, in threads of its own. Window thread only. Its end, and a new question, stop the
/// old one, which takes no longer than a frame of its run, or the building of its world.
class Inquiry {
public:
    /// `data` owns `registry` and `parts`, or is nullptr if they outlive this.
    Inquiry(Registry const& registry, PartLibrary const& parts, std::shared_ptr<GameData const> data);
    ~Inquiry();
    Inquiry(Inquiry const&) = delete;
    Inquiry& operator=(Inquiry const&) = delete;

    struct Found {
        std::optional<insight::Answer> answer;
        bool nothing = false; ///< nothing that can be explained has happened
        std::string fault;    ///< why there is no answer, in English; "" if there is one
    };

    void ask(RunAsked run, insight::Question question);
    /// Ends the question with its results so far, which take() returns soon.
    void stop();
    /// Ends it and forgets it.
    void forget();
    [[nodiscard]] bool busy() const { return job_ != nullptr; }
    /// Whether any world runs in the background, also of questions that were forgotten.
    [[nodiscard]] bool working() {
        clearForgotten(false);
        return busy() || !forgotten_.empty();
    }
    /// The answer, once; nothing while it is computed.
    [[nodiscard]] std::optional<Found> take();
    struct Progress {
        std::size_t done = 0; ///< runs
        std::size_t of = 0;   ///< 0: not known yet
    };
    [[nodiscard]] Progress progress() const;
    /// Waits until take() has a result, for tests.
    void wait() const;

private:
    struct Job {
        std::atomic<bool> stop = false;
        std::atomic<std::size_t> done = 0;
        std::atomic<std::size_t> of = 0;
        std::future<Found> future;
    };
    void clearForgotten(bool all);
    /// With the mods, so that effects can be left out as well.
    [[nodiscard]] std::unique_ptr<insight::LevelRuns> runsOf(LevelFile level) const;

    Registry const& registry_;
    PartLibrary const& parts_;
    std::shared_ptr<GameData const> data_;
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> forgotten_; // that are about to end
};

} // namespace trembler::ui
