#include "puzzle/edit/world/edited_world.hpp"

#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace trembler::edit {
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

void EditedWorld::build(GameData const& data, LevelFile const& level, Json const& tree) {
    LevelFile reduced = level;
    ++builds_;
    displacement_.reset();
    // The sections of a level that do not become part of the world: faults in these do not prevent building
    // it.
    reduced.solutions.clear();
    reduced.goals = nullptr;
    reduced.task = nullptr;
    leftOut_ = 0;
    for (int attempt = 0;; ++attempt) {
        try {
            world_ = buildWorld(data.registry, reduced, data.parts);
            displacement_.emplace(data, tree, reduced, *world_);
            noteObjects(reduced.objects);
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

void EditedWorld::noteObjects(std::span<LevelObject const> entries) {
    objects_.assign(entries.size(), {});
    entries_.clear();
    for (LevelObject const& entry : entries) {
        entries_.push_back(entry.name);
    }
    Store const& store = std::as_const(*world_).store();
    for (std::uint32_t number = 0; number < store.objects().indexBound(); ++number) {
        ObjectId const id = store.objects().at(number);
        Origin const origin = store.originOf(id);
        if (origin.kind == Origin::Kind::object && !store.has<Joint>(id)) {
            objects_[origin.number].push_back(id);
        }
    }
}

std::span<ObjectId const> EditedWorld::objectsOf(std::string const& name) const {
    if (world_ == nullptr) {
        return {};
    }
    ObjectId const id = std::as_const(*world_).store().find(name);
    Origin const origin = std::as_const(*world_).store().originOf(id);
    return id.valid() && origin.kind == Origin::Kind::object
               ? std::span<ObjectId const>(objects_[origin.number])
               : std::span<ObjectId const>();
}

std::string const& EditedWorld::entryOf(ObjectId object) const {
    static std::string const none;
    if (world_ == nullptr) {
        return none;
    }
    Store const& store = std::as_const(*world_).store();
    Origin const origin = store.originOf(object);
    return origin.kind == Origin::Kind::object && !store.has<Joint>(object) ? entries_[origin.number] : none;
}

std::size_t EditedWorld::pieceOf(ObjectId object) const {
    return std::as_const(*world_).store().originOf(object).piece;
}

bool EditedWorld::follow(Json const& tree) {
    return displacement_ && displacement_->follow(tree, *world_);
}

} // namespace trembler::edit
