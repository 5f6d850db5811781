#include "game/ui/play/keeping/loadable_solutions.hpp"

#include "game/ui/shared/kept/kept_words.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/solutions/solution_file.hpp"

#include <algorithm>
#include <exception>
#include <set>

namespace trembler::ui {
namespace {

std::string_view actionOf(RecordedInput const& input) {
    switch (input.kind) {
    case PlayerInput::Kind::grab:
        return "grab";
    case PlayerInput::Kind::cut:
        return "cut";
    case PlayerInput::Kind::remove:
        return "remove";
    case PlayerInput::Kind::move:
    case PlayerInput::Kind::release:
        break;
    }
    return {};
}

} // namespace

bool LoadableSolutions::isFound(Solution const& recorded) const {
    std::set<std::string> parts;
    for (Placement const& placement : recorded.placements) {
        parts.insert(placement.part);
    }
    std::set<std::string> actions;
    for (RecordedInput const& input : recorded.inputs) {
        if (auto const action = actionOf(input); !action.empty()) {
            actions.emplace(action);
        }
    }
    auto const& kinds = progress_.of(id_).kinds;
    return recorded.solves && std::any_of(kinds.begin(), kinds.end(), [&](SolutionKind const& kind) {
               return kind.parts == parts && kind.actions == actions;
           });
}

void LoadableSolutions::refresh() {
    mine_ = saved_.of(id_);
    items_.clear();
    for (SavedSolution const& saved : mine_) {
        items_.push_back({saved.name, true});
    }
    for (Solution const& recorded : session_.level().solutions) {
        if (isFound(recorded)) {
            items_.push_back({recorded.name, false});
        }
    }
}

std::string LoadableSolutions::load(std::size_t index) {
    try {
        std::string const source = index < mine_.size() ? mine_[index].file.string() : items_.at(index).name;
        load_(findOrLoadSolution(registry_, session_.level(), source));
    } catch (std::exception const& error) {
        return shownError(error);
    }
    return {};
}

std::string LoadableSolutions::receive(std::filesystem::path const& file) {
    try {
        Solution const solution = loadSolution(registry_, session_.level(), file);
        load_(solution);
        (void)saved_.keep(id_, solution);
    } catch (OutputError const& error) {
        return notWritten(Owned::solution, error);
    } catch (InputError const& error) {
        return textWith("solutions.refused", file.filename().string(),
                        shownMessage(error.diagnostics().front()));
    } catch (std::exception const& error) {
        return shownError(error);
    }
    refresh();
    return {};
}

std::string LoadableSolutions::rename(std::size_t index, std::string const& name) {
    try {
        SavedSolutions::rename(mine_.at(index), name);
    } catch (OutputError const& error) {
        return notWritten(Owned::solution, error);
    } catch (std::exception const& error) {
        return shownError(error);
    }
    refresh();
    return {};
}

std::string LoadableSolutions::remove(std::size_t index) {
    try {
        SavedSolutions::remove(mine_.at(index));
    } catch (OutputError const& error) {
        return notWritten(Owned::solution, error);
    }
    refresh();
    return {};
}

} // namespace trembler::ui
