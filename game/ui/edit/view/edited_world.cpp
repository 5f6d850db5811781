#include "game/ui/edit/view/edited_world.hpp"

#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace trembler::ui {
namespace {

/// How often entries are left out before all joints and connections are.
constexpr int attempts = 8;

/// Whether a problem with the path is about an entry with this path.
bool concerns(std::string const& path, std::string const& entry) {
    return !entry.empty() && path.starts_with(entry) &&
           (path.size() == entry.size() || path[entry.size()] == '/');
}

template <class Entry>
std::size_t dropFaulty(std::vector<Entry>& entries, std::vector<Diagnostic> const& faults) {
    return std::erase_if(entries, [&](Entry const& entry) {
        return std::any_of(faults.begin(), faults.end(),
                           [&](Diagnostic const& fault) { return concerns(fault.path, entry.path); });
    });
}

/// Leaves out the entries at fault; returns how many.
std::size_t leaveOut(LevelFile& level, std::vector<Diagnostic> const& faults) {
    return dropFaulty(level.connections, faults) + dropFaulty(level.joints, faults) +
           dropFaulty(level.objects, faults);
}

} // namespace

void EditedWorld::build(Registry const& registry, PartLibrary const& parts, LevelFile const& level) {
    LevelFile reduced = level;
    // What the world does not consist of: faults in it are none of the world.
    reduced.solutions.clear();
    reduced.goals = nullptr;
    leftOut_ = 0;
    for (int attempt = 0;; ++attempt) {
        try {
            world_ = buildWorld(registry, reduced, parts);
            return;
        } catch (InputError const& error) {
            std::size_t const dropped = leaveOut(reduced, error.diagnostics());
            leftOut_ += dropped;
            if (dropped > 0 && attempt < attempts) {
                continue;
            }
            if (!reduced.joints.empty() || !reduced.connections.empty()) {
                leftOut_ += reduced.joints.size() + reduced.connections.size();
                reduced.joints.clear();
                reduced.connections.clear();
            } else if (!reduced.detail.empty() || !reduced.world.empty()) {
                reduced.detail.clear();
                reduced.world = {};
            } else if (!reduced.objects.empty()) {
                leftOut_ += reduced.objects.size();
                reduced.objects.clear();
            } else {
                return; // not even an empty world: the last one stays
            }
        }
    }
}

} // namespace trembler::ui
