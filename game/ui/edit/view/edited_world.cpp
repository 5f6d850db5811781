#include "game/ui/edit/view/edited_world.hpp"

#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>
#include <numeric>

namespace trembler::ui {
namespace {

/// How often entries are left out before all joints and connections are.
constexpr int attempts = 8;

/// A level with fewer entries, and where its entries stood in the whole level.
struct Reduced {
    LevelFile level;
    std::vector<std::size_t> objects;
    std::vector<std::size_t> joints;
};

Reduced wholeOf(LevelFile const& level) {
    Reduced reduced{level, std::vector<std::size_t>(level.objects.size()),
                    std::vector<std::size_t>(level.joints.size())};
    std::iota(reduced.objects.begin(), reduced.objects.end(), std::size_t{0});
    std::iota(reduced.joints.begin(), reduced.joints.end(), std::size_t{0});
    // What the world does not consist of: faults in it are none of the world.
    reduced.level.solutions.clear();
    reduced.level.goals = nullptr;
    return reduced;
}

/// Whether a problem with the path is about an entry with this path.
bool concerns(std::string const& path, std::string const& entry) {
    return !entry.empty() && path.starts_with(entry) &&
           (path.size() == entry.size() || path[entry.size()] == '/');
}

template <class Entry>
std::size_t dropFaulty(std::vector<Entry>& entries, std::vector<std::size_t>* places,
                       std::vector<Diagnostic> const& faults) {
    std::size_t dropped = 0;
    for (std::size_t i = entries.size(); i > 0; --i) {
        bool const faulty = std::any_of(faults.begin(), faults.end(), [&](Diagnostic const& fault) {
            return concerns(fault.path, entries[i - 1].path);
        });
        if (faulty) {
            entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(i - 1));
            if (places != nullptr) {
                places->erase(places->begin() + static_cast<std::ptrdiff_t>(i - 1));
            }
            ++dropped;
        }
    }
    return dropped;
}

/// Leaves out the entries at fault; returns how many.
std::size_t leaveOut(Reduced& reduced, std::vector<Diagnostic> const& faults) {
    LevelFile& level = reduced.level;
    std::size_t dropped = dropFaulty(level.connections, nullptr, faults);
    dropped += dropFaulty(level.joints, &reduced.joints, faults);
    dropped += dropFaulty(level.objects, &reduced.objects, faults);
    return dropped;
}

} // namespace

void EditedWorld::build(Registry const& registry, PartLibrary const& parts, LevelFile const& level) {
    Reduced reduced = wholeOf(level);
    leftOut_ = 0;
    for (int attempt = 0;; ++attempt) {
        try {
            BuiltLevel built = buildLevel(registry, reduced.level, parts);
            world_ = std::move(built.world);
            objects_.assign(level.objects.size(), ObjectId{});
            joints_.assign(level.joints.size(), ObjectId{});
            for (std::size_t i = 0; i < reduced.objects.size(); ++i) {
                objects_[reduced.objects[i]] = built.objects[i];
            }
            for (std::size_t i = 0; i < reduced.joints.size(); ++i) {
                joints_[reduced.joints[i]] = built.joints[i];
            }
            return;
        } catch (InputError const& error) {
            std::size_t const dropped = leaveOut(reduced, error.diagnostics());
            leftOut_ += dropped;
            if (dropped > 0 && attempt < attempts) {
                continue;
            }
            if (!reduced.level.joints.empty() || !reduced.level.connections.empty()) {
                leftOut_ += reduced.level.joints.size() + reduced.level.connections.size();
                reduced.level.joints.clear();
                reduced.level.connections.clear();
                reduced.joints.clear();
            } else if (!reduced.level.detail.empty() || !reduced.level.world.empty()) {
                reduced.level.detail.clear();
                reduced.level.world = {};
            } else if (!reduced.level.objects.empty()) {
                leftOut_ += reduced.level.objects.size();
                reduced.level.objects.clear();
                reduced.objects.clear();
            } else {
                return; // not even an empty world: the last one stays
            }
        }
    }
}

ObjectId EditedWorld::objectOf(std::size_t entry) const {
    return entry < objects_.size() ? objects_[entry] : ObjectId{};
}

ObjectId EditedWorld::jointOf(std::size_t entry) const {
    return entry < joints_.size() ? joints_[entry] : ObjectId{};
}

std::optional<std::size_t> EditedWorld::entryOf(ObjectId object) const {
    auto const found = std::find(objects_.begin(), objects_.end(), object);
    return object.valid() && found != objects_.end()
               ? std::optional(static_cast<std::size_t>(found - objects_.begin()))
               : std::nullopt;
}

} // namespace trembler::ui
