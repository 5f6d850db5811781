#include "game/ui/shared/catalog/kind_finder.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace trembler::ui {

void KindFinder::look(std::string levelId, std::shared_ptr<GameData const> data, Registry const& registry,
                      PartLibrary const& parts, LevelFile level, Solution solution, std::uint64_t frames) {
    if (busy()) {
        return;
    }
    id_ = std::move(levelId);
    future_ =
        std::async(std::launch::async, [data = std::move(data), &registry, &parts, level = std::move(level),
                                        solution = std::move(solution),
                                        frames] { return kindOf(registry, parts, level, solution, frames); });
}

std::optional<KindFinder::Found> KindFinder::take() {
    if (!busy() || future_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return std::nullopt;
    }
    try {
        KindOfRun run = future_.get();
        return run.solves ? std::optional(Found{id_, std::move(run.kind)}) : std::nullopt;
    } catch (std::exception const&) { // the run cannot be repeated: it is of no known kind
        return std::nullopt;
    }
}

void KindFinder::wait() const {
    if (busy()) {
        future_.wait();
    }
}

} // namespace trembler::ui
