#include "insight/robustness/place_map.hpp"

#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"
#include "puzzle/session/zone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <optional>

namespace trembler::insight {
namespace {

constexpr double around = 2; // m to each side of the recorded place, in a level without bounds

/// A displacement, in steps of the options: to the right, and up.
struct Cell {
    int right = 0;
    int up = 0;
    auto operator<=>(Cell const&) const = default;
};

/// The displacements that may lie in the area for placing, each end included.
struct Reach {
    Cell least;
    Cell most;
    [[nodiscard]] bool has(Cell cell) const {
        return cell.right >= least.right && cell.right <= most.right && cell.up >= least.up &&
               cell.up <= most.up;
    }
};

/// What surrounds all areas for placing, or else the level's bounds; nothing if there are neither.
std::optional<Bounds> surroundings(LevelFile const& level) {
    std::optional<Bounds> all;
    for (Area const& area : level.placing.value_or(std::vector<Area>{})) {
        Bounds const own = boundsOf(area);
        if (all) {
            all->include(own);
        } else {
            all = own;
        }
    }
    return all || !level.bounds ? all : boundsOf(Area{level.bounds, {}});
}

/// A map that grows.
class Growing {
public:
    Growing(LevelFile const& level, Placement const& placement, PlaceMapOptions const& options)
        : options_(options) {
        Vec2 const at = placement.at;
        auto const [low, high] =
            surroundings(level).value_or(Bounds{at - Vec2{around, around}, at + Vec2{around, around}});
        auto const steps = [&](double metres) { return static_cast<int>(std::floor(metres / options.step)); };
        reach_ = {{-steps(at.x - low.x), -steps(at.y - low.y)}, {steps(high.x - at.x), steps(high.y - at.y)}};
        while (coarseCells(coarse_).size() > std::max<std::size_t>(1, options.places / 4)) {
            coarse_ *= 2;
        }
    }

    /// The cells to be run next; none: it is complete. To be followed by a take() of each of them.
    [[nodiscard]] std::vector<Cell> next() {
        if (!begun_) {
            begun_ = true;
            std::vector<Cell> cells = coarseCells(coarse_);
            if (!reach_.has({})) {
                cells.push_back({}); // recorded where no player may put it
            }
            return cells;
        }
        std::vector<Cell> edge = unknownNeighbours();
        while (!edge.empty() && known() + edge.size() > options_.places) {
            step_ *= 2;
            edge = unknownNeighbours();
        }
        return edge;
    }
    void take(Cell cell, char state) {
        cells_[cell] = state;
        ++runs_;
    }

    [[nodiscard]] PlaceMap map(std::string part, std::size_t placement) const {
        PlaceMap made;
        made.part = std::move(part);
        made.placement = placement;
        made.step = options_.step * step_;
        made.runs = runs_;
        Cell least;
        Cell most;
        bool stopped = !cells_.contains({});
        for (auto const& [cell, state] : cells_) {
            stopped = stopped || state == '?';
            if (state == '#' && isOn(cell)) {
                least = {std::min(least.right, cell.right), std::min(least.up, cell.up)};
                most = {std::max(most.right, cell.right), std::max(most.up, cell.up)};
            }
        }
        for (int up = most.up + step_; up >= least.up - step_; up -= step_) {
            std::string& row = made.rows.emplace_back();
            for (int right = least.right - step_; right <= most.right + step_; right += step_) {
                auto const at = cells_.find({right, up});
                row += at != cells_.end() ? at->second : !reach_.has({right, up}) ? ' ' : stopped ? '?' : '-';
            }
        }
        made.row = static_cast<std::size_t>(most.up / step_ + 1);
        made.column = static_cast<std::size_t>(1 - least.right / step_);
        return made;
    }

private:
    [[nodiscard]] bool isOn(Cell cell) const { return cell.right % step_ == 0 && cell.up % step_ == 0; }
    /// Of the grid with that step.
    [[nodiscard]] std::vector<Cell> coarseCells(int step) const {
        std::vector<Cell> cells;
        for (int up = reach_.least.up / step * step; up <= reach_.most.up; up += step) {
            for (int right = reach_.least.right / step * step; right <= reach_.most.right; right += step) {
                if (reach_.has({right, up})) {
                    cells.push_back({right, up});
                }
            }
        }
        return cells;
    }
    [[nodiscard]] std::size_t known() const {
        return static_cast<std::size_t>(
            std::count_if(cells_.begin(), cells_.end(), [&](auto const& each) { return isOn(each.first); }));
    }
    [[nodiscard]] std::vector<Cell> unknownNeighbours() const {
        std::vector<Cell> edge;
        for (auto const& [cell, state] : cells_) {
            if (state != '#' || !isOn(cell)) {
                continue;
            }
            for (int up = -step_; up <= step_; up += step_) {
                for (int right = -step_; right <= step_; right += step_) {
                    Cell const next{cell.right + right, cell.up + up};
                    if (reach_.has(next) && !cells_.contains(next)) {
                        edge.push_back(next);
                    }
                }
            }
        }
        std::sort(edge.begin(), edge.end());
        edge.erase(std::unique(edge.begin(), edge.end()), edge.end());
        return edge;
    }

    PlaceMapOptions const& options_;
    Reach reach_;
    int coarse_ = 1; // steps of the options, as step_
    int step_ = 1;
    bool begun_ = false;
    std::map<Cell, char> cells_;
    std::size_t runs_ = 0;
};

} // namespace

std::vector<std::vector<PlaceMap>> placeMapsOf(LevelUnderTest const& level,
                                               std::vector<SolvedBy> const& solutions,
                                               PlaceMapOptions const& options, Workers& workers) {
    struct Part {
        std::size_t solution;
        std::size_t placement;
        Growing map;
    };
    std::vector<Part> parts;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        std::vector<Placement> const& placements = solutions[i].solution->placements;
        for (std::size_t p = 0; p < placements.size(); ++p) {
            parts.push_back({i, p, Growing(level.level(), placements[p], options)});
        }
    }
    struct Trial {
        Part* part;
        Cell cell;
    };
    while (!workers.stopped()) {
        std::vector<Trial> trials;
        std::vector<std::string> keys;
        for (Part& part : parts) { // all maps grow at the same time, so that no processor waits
            SolvedBy const& solved = solutions[part.solution];
            for (Cell const cell : part.map.next()) {
                trials.push_back({&part, cell});
                keys.push_back(fmt::format("map/{}/{}/{}/{}/{}/{}/{}/{}", level.identity(),
                                           identityOf(*solved.solution), solved.solution->name,
                                           patienceFor(solved), part.placement, options.step, cell.right,
                                           cell.up));
            }
        }
        if (trials.empty()) {
            break;
        }
        auto const results = workers.share(keys, [&](std::size_t index) {
            Part const& part = *trials[index].part;
            SolvedBy const& solved = solutions[part.solution];
            Cell const cell = trials[index].cell;
            Solution moved = *solved.solution;
            moved.placements[part.placement].at += options.step * Vec2{1.0 * cell.right, 1.0 * cell.up};
            return toText(tryOut(level, moved, {.frames = patienceFor(solved), .mustFit = cell != Cell{}}));
        });
        for (std::size_t index = 0; index < trials.size(); ++index) {
            char state = '?';
            if (results[index]) {
                TrialResult const result = trialFrom(*results[index]);
                state = !result.fits ? ' ' : result.solved ? '#' : '.';
            }
            trials[index].part->map.take(trials[index].cell, state);
        }
    }
    std::vector<std::vector<PlaceMap>> maps(solutions.size());
    for (Part const& part : parts) {
        std::string const& name = solutions[part.solution].solution->placements[part.placement].part;
        maps[part.solution].push_back(part.map.map(name, part.placement));
    }
    return maps;
}

} // namespace trembler::insight
