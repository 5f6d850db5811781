#include "puzzle/goals/checking/candidates.hpp"

#include "physics/dynamics/properties/body.hpp"

#include <algorithm>

namespace trembler {

CandidateFinder::CandidateFinder(LevelFile const& level, World const& world) : world_(world) {
    for (LevelObject const& object : level.objects) {
        byPart_[object.part].push_back(&object.name);
    }
    for (ToolboxEntry const& entry : level.toolbox) {
        tools_[entry.part] += static_cast<std::size_t>(entry.count);
    }
}

void CandidateFinder::add(Candidates& candidates, Selector const& selector) const {
    candidates.names.insert(selector.names.begin(), selector.names.end());
    candidates.it = candidates.it || selector.it;
    for (std::string const& part : selector.parts) {
        if (auto const made = byPart_.find(part); made != byPart_.end()) {
            for (std::string const* const name : made->second) {
                candidates.names.insert(*name);
            }
        }
        auto const tool = tools_.find(part);
        if (tool != tools_.end() && candidates.fromTools.insert(part).second) {
            candidates.placed += tool->second;
        }
    }
}

Candidates CandidateFinder::of(Selector const& selector) const {
    Candidates candidates;
    add(candidates, selector);
    return candidates;
}

bool CandidateFinder::areFixed(Selector const& selector) const {
    // Without Candidates: most levels have many goals about objects of which the first is not fixed.
    auto const isFixed = [&](std::string const& name) {
        ObjectId const id = world_.store().find(name);
        return id.valid() && world_.find<Fixed>(id) != nullptr;
    };
    bool any = !selector.names.empty();
    if (selector.it || !std::all_of(selector.names.begin(), selector.names.end(), isFixed)) {
        return false;
    }
    for (std::string const& part : selector.parts) {
        if (auto const tool = tools_.find(part); tool != tools_.end() && tool->second > 0) {
            return false;
        }
        auto const made = byPart_.find(part);
        if (made == byPart_.end()) {
            continue;
        }
        any = any || !made->second.empty();
        if (!std::all_of(made->second.begin(), made->second.end(),
                         [&](std::string const* name) { return isFixed(*name); })) {
            return false;
        }
    }
    return any;
}

} // namespace trembler
