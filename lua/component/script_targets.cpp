#include "lua/component/script_targets.hpp"

#include "physics/dynamics/properties/contacts.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <iterator>
#include <typeindex>
#include <utility>

namespace trembler::lua {
namespace {

// Of a property that the host reads for the script; declare() has declared it.
Home const& homeOf(std::type_index type, Script const& script, std::vector<Home> const& homes) {
    std::size_t i = 0;
    while (script.reads[i].info->type != type) {
        ++i;
    }
    return homes[i];
}
template <ObjectProperty P>
Column<P> const* columnOf(Script const& script, std::vector<Home> const& homes) {
    return static_cast<Column<P> const*>(homeOf(typeid(P), script, homes).column);
}
Slot<Contacts> const* contactsOf(Script const& script, std::vector<Home> const& homes) {
    return static_cast<Slot<Contacts> const*>(homeOf(typeid(Contacts), script, homes).slot);
}

/// The targets of one turn.
class Finder {
public:
    Finder(Script const& script, std::vector<Home> const& homes) : script_(script), homes_(homes) {}

    [[nodiscard]] std::vector<Target> found();

private:
    void findEach();
    void findPairs();
    void findTouching();
    void findNear();
    [[nodiscard]] std::vector<ObjectId> havingAll(std::vector<std::size_t> const& needed,
                                                  bool attached) const;
    [[nodiscard]] bool hasAll(ObjectId id, std::vector<std::size_t> const& needed, bool attached) const;
    [[nodiscard]] ScriptUse const* useOf(ObjectId id) const;
    [[nodiscard]] double reachOf(ScriptUse const* use) const;

    Script const& script_;
    std::vector<Home> const& homes_;
    std::vector<Target> targets_;
};

std::vector<Target> Finder::found() {
    switch (script_.manifest.application) {
    case Application::once:
        targets_.push_back({});
        break;
    case Application::each:
        findEach();
        break;
    case Application::pairs:
        findPairs();
        break;
    }
    return std::move(targets_);
}

ScriptUse const* Finder::useOf(ObjectId id) const {
    Scripts const* const scripts = columnOf<Scripts>(script_, homes_)->find(id);
    if (scripts == nullptr) {
        return nullptr;
    }
    auto const use =
        std::find_if(scripts->uses.begin(), scripts->uses.end(),
                     [this](ScriptUse const& stated) { return stated.script == script_.manifest.name; });
    return use == scripts->uses.end() ? nullptr : &*use;
}

bool Finder::hasAll(ObjectId id, std::vector<std::size_t> const& needed, bool attached) const {
    return std::all_of(needed.begin(), needed.end(),
                       [&](std::size_t read) { return homes_[read].column->has(id); }) &&
           (!attached || useOf(id) != nullptr);
}

std::vector<ObjectId> Finder::havingAll(std::vector<std::size_t> const& needed, bool attached) const {
    ColumnBase const* rarest = attached ? columnOf<Scripts>(script_, homes_) : nullptr;
    for (std::size_t const read : needed) {
        if (rarest == nullptr || homes_[read].column->size() < rarest->size()) {
            rarest = homes_[read].column;
        }
    }
    std::vector<ObjectId> all;
    if (rarest != nullptr) {
        std::copy_if(rarest->owners().begin(), rarest->owners().end(), std::back_inserter(all),
                     [&](ObjectId id) { return hasAll(id, needed, attached); });
    }
    return all;
}

void Finder::findEach() {
    bool const attached = script_.manifest.attached;
    for (ObjectId const id : havingAll(script_.first, attached)) {
        targets_.push_back({.first = id, .second = {}, .use = attached ? useOf(id) : nullptr, .cause = {}});
    }
}

void Finder::findPairs() {
    if (script_.manifest.touching) {
        findTouching();
    } else {
        findNear();
    }
}

void Finder::findTouching() {
    bool const attached = script_.manifest.attached;
    bool const alike = script_.manifest.first == script_.manifest.second && !attached;
    auto const add = [&](ObjectId a, ObjectId b, EventId cause) {
        if (hasAll(a, script_.first, attached) && hasAll(b, script_.second, false)) {
            targets_.push_back(
                {.first = a, .second = b, .use = attached ? useOf(a) : nullptr, .cause = cause});
        }
    };
    for (TouchingPair const& pair : contactsOf(script_, homes_)->value().current) {
        add(pair.a, pair.b, pair.event);
        if (!alike) {
            add(pair.b, pair.a, pair.event);
        }
    }
    std::sort(targets_.begin(), targets_.end(), [](Target const& x, Target const& y) {
        return std::pair(x.first, x.second) < std::pair(y.first, y.second);
    });
}

double Finder::reachOf(ScriptUse const* use) const {
    Manifest const& manifest = script_.manifest;
    if (manifest.withinParameter.empty()) {
        return manifest.within;
    }
    if (use != nullptr) {
        for (ScriptSetting const& setting : use->settings) {
            if (setting.parameter == manifest.withinParameter) {
                return setting.number;
            }
        }
    }
    return std::get<double>(manifest.parameter(manifest.withinParameter)->initial);
}

// Sorts along x: O(n log n), plus the number of pairs that are near in x.
void Finder::findNear() {
    struct Place {
        double x;
        double y;
        ObjectId id;
    };
    bool const attached = script_.manifest.attached;
    bool const alike = script_.manifest.first == script_.manifest.second && !attached;
    auto const* const positions = columnOf<Position>(script_, homes_);
    std::vector<Place> places;
    for (ObjectId const id : havingAll(script_.second, false)) {
        if (Position const* const position = positions->find(id)) {
            places.push_back({position->value.x, position->value.y, id});
        }
    }
    std::sort(places.begin(), places.end(),
              [](Place const& a, Place const& b) { return a.x != b.x ? a.x < b.x : a.id < b.id; });
    for (ObjectId const id : havingAll(script_.first, attached)) {
        Position const* const at = positions->find(id);
        if (at == nullptr) {
            continue;
        }
        ScriptUse const* const use = attached ? useOf(id) : nullptr;
        double const reach = reachOf(use);
        std::size_t const begin = targets_.size();
        auto const from = std::lower_bound(places.begin(), places.end(), at->value.x - reach,
                                           [](Place const& place, double x) { return place.x < x; });
        for (auto near = from; near != places.end() && near->x <= at->value.x + reach; ++near) {
            Vec2 const apart{near->x - at->value.x, near->y - at->value.y};
            if (targets_.size() > mostPairs) {
                return;
            }
            if (near->id != id && dot(apart, apart) <= reach * reach && !(alike && near->id < id)) {
                targets_.push_back({.first = id, .second = near->id, .use = use, .cause = {}});
            }
        }
        std::sort(targets_.begin() + static_cast<std::ptrdiff_t>(begin), targets_.end(),
                  [](Target const& x, Target const& y) { return x.second < y.second; });
    }
}

/// The state of the columns by which the objects of Application::each are found, and of the parameters that
/// they state; empty for other applications.
std::vector<std::uint64_t> versionsOf(Script const& script, std::vector<Home> const& homes) {
    std::vector<std::uint64_t> versions;
    if (script.manifest.application != Application::each) {
        return versions;
    }
    for (std::size_t const read : script.first) {
        versions.push_back(homes[read].column->structureVersion());
    }
    if (script.manifest.attached) {
        versions.push_back(columnOf<Scripts>(script, homes)->version());
        versions.push_back(columnOf<Scripts>(script, homes)->structureVersion());
    }
    return versions;
}

} // namespace

bool ScriptTargets::update(Script const& script, std::vector<Home> const& homes) {
    Application const application = script.manifest.application;
    std::vector<std::uint64_t> now = versionsOf(script, homes);
    bool const same = application == Application::each   ? now == foundBy_
                      : application == Application::once ? !targets_.empty()
                                                         : false;
    if (!same) {
        foundBy_.clear(); // if the search throws, the next turn searches again
        targets_ = Finder(script, homes).found();
        foundBy_ = std::move(now);
    }
    return same;
}

} // namespace trembler::lua
