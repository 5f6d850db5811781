// Finds out, beside the game, in which kind of way a level was solved.
#pragma once

#include "puzzle/campaign/solution_kind.hpp"
#include "puzzle/data/game_data.hpp"

#include <future>
#include <memory>
#include <optional>
#include <string>

namespace trembler::ui {

/// The run is computed once more, with its causes, in a thread of its own, as that may take longer than a
/// picture. One at a time. Window thread only.
class KindFinder {
public:
    struct Found {
        std::string levelId;
        SolutionKind kind;
    };

    /// `data` owns `registry` and `parts`, or is nullptr if they outlive this. While another run is being
    /// looked at, does nothing: the same level will be solved again.
    void look(std::string levelId, std::shared_ptr<GameData const> data, Registry const& registry,
              PartLibrary const& parts, LevelFile level, Solution solution, std::uint64_t frames);
    /// The result of look(), once; nothing while it is computed, or if the run could not be repeated.
    [[nodiscard]] std::optional<Found> take();
    [[nodiscard]] bool busy() const { return future_.valid(); }
    /// Waits until take() has a result, for tests.
    void wait() const;

private:
    std::string id_;
    std::future<KindOfRun> future_;
};

} // namespace trembler::ui
