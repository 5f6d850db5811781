#include "puzzle/goals/judging/object_finder.hpp"

#include "runtime/level/json/add_problem.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

ObjectFinder::ObjectFinder(LevelFile const& level, World const& world, Problems& problems)
    : level_(level), world_(world), problems_(problems) {
    Store const& store = world.store();
    for (std::uint32_t index = 0; index < store.objects().indexBound(); ++index) {
        ObjectId const id = store.objects().at(index);
        if (Origin const origin = store.originOf(id); origin.prototype) {
            byPrototype_[*origin.prototype].push_back(id);
        }
    }
}

std::vector<ObjectId> ObjectFinder::find(Selector const& selector, ObjectId it) const {
    if (full()) {
        return {};
    }
    Store const& store = world_.store();
    std::vector<ObjectId> found;
    for (std::string const& name : selector.names) {
        if (ObjectId const id = store.find(name); id.valid()) {
            found.push_back(id);
        } else {
            addProblem(problems_, [&] {
                return level_.diagnostic(selector.path, fmt::format("there is no object '{}'", name),
                                         "the name of an object of this level, or of a piece of one");
            });
        }
    }
    for (std::string const& part : selector.parts) {
        if (auto const made = byPrototype_.find(store.prototypes().numberOf(part));
            made != byPrototype_.end()) {
            found.insert(found.end(), made->second.begin(), made->second.end());
        }
    }
    if (selector.it && it.valid()) {
        found.push_back(it);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void ObjectFinder::mustHave(Selector const& selector, PropertyInfo const& property,
                            std::string_view why) const {
    ColumnBase const* const column = world_.store().findColumn(property);
    for (std::string const& name : selector.names) {
        ObjectId const id = world_.store().find(name);
        if (id.valid() && (column == nullptr || !column->has(id))) {
            addProblem(problems_, [&] {
                return level_.diagnostic(selector.path, fmt::format("'{}' {}", name, why),
                                         fmt::format("an object with the property '{}'", property.text.key));
            });
        }
    }
}

bool ObjectFinder::take(std::size_t objects, std::string const& path) const {
    bool const had = taken_ <= most;
    taken_ += std::min(objects, most + 1);
    if (taken_ <= most) {
        return true;
    }
    if (had) {
        addProblem(problems_, [&] {
            return level_.diagnostic(
                path, "the goals speak of too many objects",
                fmt::format("at most {} in all, each counted for every condition that it is part of", most));
        });
    }
    return false;
}

} // namespace trembler
