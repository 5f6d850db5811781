// The solutions of the present level that the player can load: saved ones, and recorded ones that were found.
#pragma once

#include "game/ui/shared/kept/saved_solutions.hpp"
#include "puzzle/campaign/progress.hpp"
#include "puzzle/session/session.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trembler::ui {

/// Window thread only.
class LoadableSolutions {
public:
    struct Item {
        std::string name;
        bool mine = true; ///< saved by the player, else recorded in the level
    };

    /// `load` places a solution; it throws InputError if that does not fit. All must outlive this.
    LoadableSolutions(SavedSolutions const& saved, std::string levelId, Registry const& registry,
                      Session const& session, CampaignProgress const& progress,
                      std::function<void(Solution const&)> load)
        : saved_(saved), id_(std::move(levelId)), registry_(registry), session_(session), progress_(progress),
          load_(std::move(load)) {}

    /// Looks at the files and at the solutions found so far.
    void refresh();
    [[nodiscard]] std::vector<Item> const& items() const { return items_; }

    /// Places the solution in a file, which may be another player's, and keeps a copy of it among the
    /// player's own. Returns a sentence for the player if it is no solution of this level, or cannot be kept;
    /// else an empty text.
    [[nodiscard]] std::string receive(std::filesystem::path const& file);

    // Each returns a sentence for the player if it is not possible, else an empty text. `index` is that of
    // items().
    [[nodiscard]] std::string load(std::size_t index);
    /// Both only for solutions that the player has saved (Item::mine).
    [[nodiscard]] std::string rename(std::size_t index, std::string const& name);
    [[nodiscard]] std::string remove(std::size_t index);

private:
    [[nodiscard]] bool isFound(Solution const& recorded) const;

    SavedSolutions const& saved_;
    std::string id_;
    Registry const& registry_;
    Session const& session_;
    CampaignProgress const& progress_;
    std::function<void(Solution const&)> load_;
    std::vector<SavedSolution> mine_;
    std::vector<Item> items_; // mine_, then recorded ones
};

} // namespace trembler::ui
