#include "runtime/world/store.hpp"

#include <algorithm>
#include <stdexcept>

namespace trembler {

Store::Store() = default;
Store::~Store() = default;

ObjectId Store::create(std::string const& name, Origin const& origin) {
    if (name.empty()) {
        throw std::invalid_argument("an object needs a name");
    }
    if (byName_.contains(name)) {
        throw std::invalid_argument("there is already an object named '" + name + "'");
    }
    ObjectId const id = objects_.create();
    byName_.emplace(name, id);
    origins_.resize(objects_.indexBound());
    origins_[id.index] = origin;
    column<Name>().set(id, {name});
    return id;
}

bool Store::alias(std::string const& name, ObjectId id) {
    if (name.empty() || !alive(id) || !byName_.try_emplace(name, id).second) {
        return false;
    }
    aliases_.emplace(id, name);
    return true;
}

void Store::destroy(std::vector<ObjectId> ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::erase_if(ids, [this](ObjectId id) { return !alive(id); });
    if (ids.empty()) {
        return;
    }
    for (ObjectId const id : ids) {
        byName_.erase(nameOf(id));
        auto const [first, last] = aliases_.equal_range(id);
        for (auto at = first; at != last; ++at) {
            byName_.erase(at->second);
        }
        aliases_.erase(first, last);
    }
    for (auto& [key, column] : columns_) {
        column->removeAll(ids);
    }
    for (ObjectId const id : ids) {
        objects_.destroy(id);
    }
}

ObjectId Store::find(std::string const& name) const {
    auto const at = byName_.find(name);
    return at == byName_.end() ? ObjectId{} : at->second;
}

std::string Store::nameOf(ObjectId id) const {
    auto const* const names = findColumn<Name>();
    auto const* const name = names == nullptr ? nullptr : names->find(id);
    return name == nullptr ? "(gone)" : name->value;
}

Prototype const* Store::prototypeOf(ObjectId id) const {
    Origin const origin = originOf(id);
    return origin.prototype ? prototypes_.find(*origin.prototype) : nullptr;
}

ColumnBase& Store::column(PropertyInfo const& info) {
    auto& column = columns_[info.text.key];
    if (!column) {
        column = info.makeColumn();
    }
    if (column->info().type != info.type) {
        throw std::logic_error("two properties share the key '" + std::string(info.text.key) + "'");
    }
    return *column;
}

ColumnBase const* Store::findColumn(PropertyInfo const& info) const {
    auto const at = columns_.find(info.text.key);
    return at == columns_.end() ? nullptr : at->second.get();
}

SlotBase& Store::slot(PropertyInfo const& info) {
    auto& slot = slots_[info.text.key];
    if (!slot) {
        slot = info.makeSlot();
    }
    if (slot->info().type != info.type) {
        throw std::logic_error("two properties share the key '" + std::string(info.text.key) + "'");
    }
    return *slot;
}

SlotBase const* Store::findSlot(PropertyInfo const& info) const {
    auto const at = slots_.find(info.text.key);
    return at == slots_.end() ? nullptr : at->second.get();
}

std::vector<ColumnBase*> Store::columns() {
    std::vector<ColumnBase*> all;
    for (auto& [key, column] : columns_) {
        all.push_back(column.get());
    }
    return all;
}

std::vector<ColumnBase const*> Store::columns() const {
    std::vector<ColumnBase const*> all;
    for (auto const& [key, column] : columns_) {
        all.push_back(column.get());
    }
    return all;
}

std::vector<SlotBase*> Store::slots() {
    std::vector<SlotBase*> all;
    for (auto& [key, slot] : slots_) {
        all.push_back(slot.get());
    }
    return all;
}

std::vector<SlotBase const*> Store::slots() const {
    std::vector<SlotBase const*> all;
    for (auto const& [key, slot] : slots_) {
        all.push_back(slot.get());
    }
    return all;
}

void Store::furnish(ObjectId id, Prototype const& prototype) {
    for (auto const& value : prototype.values) {
        value->assignTo(column(value->info()), id);
    }
}

void Store::complete(std::span<ObjectId const> ids) {
    std::vector<ObjectId> ordered(ids.begin(), ids.end());
    std::sort(ordered.begin(), ordered.end());
    ordered.erase(std::unique(ordered.begin(), ordered.end()), ordered.end());
    for (Completion const completion : completions_) {
        completion(*this, ordered);
    }
}

std::uint64_t Store::hash() const {
    StateHash state;
    hashColumns(state);
    return state.digest();
}

void Store::hash(StateHash& hash) const {
    hashColumns(hash);
    hash.integer(objects_.indexBound());
    objects_.forFree([&](std::uint32_t index, std::uint32_t generation) {
        hash.integer((std::uint64_t{generation} << 32U) | index);
    });
}

void Store::hashColumns(StateHash& hash) const {
    for (auto const& [key, column] : columns_) {
        bool const covered = column->info().coverage.kind != Coverage::Kind::leftOut;
        if (covered && !column->empty()) { // an empty column equals a column that was never created
            hash.integer(key.size());
            hash.bytes(key.data(), key.size());
            column->hash(hash);
        }
    }
}

std::uint64_t Store::structureVersion() const {
    std::uint64_t sum = 0;
    for (auto const& [key, column] : columns_) {
        sum += column->structureVersion();
    }
    return sum;
}

} // namespace trembler
