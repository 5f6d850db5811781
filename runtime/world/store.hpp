// All data of a world: objects, property columns, and the slots of resolver and derived properties.
#pragma once

#include "runtime/object/name.hpp"
#include "runtime/object/object_table.hpp"
#include "runtime/object/origin.hpp"
#include "runtime/property/column.hpp"
#include "runtime/property/slot.hpp"
#include "runtime/world/prototype.hpp"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <typeindex>
#include <unordered_map>
#include <vector>

namespace trembler {

/// Columns and slots are created on first use and keep their addresses for the store's life.
///
/// Not thread-safe for changes of structure; those happen before the first frame and in the Population
/// resolver.
class Store {
public:
    Store();
    ~Store();
    Store(Store const&) = delete;
    Store& operator=(Store const&) = delete;

    /// A new object with a unique name; throws std::invalid_argument if the name is taken or empty. `origin`
    /// does not change during the object's life.
    ObjectId create(std::string const& name, Origin const& origin = {});
    /// Lets find() find an object by a second name as well. False, and nothing changes, if that name is taken
    /// or the object does not exist. It ends with the object. No simulation depends on it.
    bool alias(std::string const& name, ObjectId id);
    /// Removes objects with all their properties. Unknown and repeated ids are ignored.
    void destroy(std::vector<ObjectId> ids);
    [[nodiscard]] bool alive(ObjectId id) const { return objects_.alive(id); }
    [[nodiscard]] ObjectTable const& objects() const { return objects_; }
    /// The object of that name, or an invalid id.
    [[nodiscard]] ObjectId find(std::string const& name) const;
    /// An object's name; "(gone)" for one that no longer exists.
    [[nodiscard]] std::string nameOf(ObjectId id) const;
    /// Where an object comes from; Origin{} for one that does not exist. Not in hash().
    [[nodiscard]] Origin originOf(ObjectId id) const { return alive(id) ? origins_[id.index] : Origin{}; }
    /// The part that an object is made from; nullptr if it is not made from a part or does not exist. Valid
    /// until a prototype is added.
    [[nodiscard]] Prototype const* prototypeOf(ObjectId id) const;

    template <ObjectProperty P>
    [[nodiscard]] Column<P>& column() {
        return static_cast<Column<P>&>(column(propertyInfo<P>()));
    }
    template <ObjectProperty P>
    [[nodiscard]] Column<P> const* findColumn() const {
        return static_cast<Column<P> const*>(findColumn(propertyInfo<P>()));
    }
    template <ObjectProperty P>
    [[nodiscard]] bool has(ObjectId id) const {
        auto const* const column = findColumn<P>();
        return column != nullptr && column->has(id);
    }
    template <Property P>
    [[nodiscard]] Slot<P>& slot() {
        return static_cast<Slot<P>&>(slot(propertyInfo<P>()));
    }
    template <Property P>
    [[nodiscard]] Slot<P> const* findSlot() const {
        return static_cast<Slot<P> const*>(findSlot(propertyInfo<P>()));
    }
    template <Property P>
    [[nodiscard]] auto& home() {
        if constexpr (ObjectProperty<P>) {
            return column<P>();
        } else {
            return slot<P>();
        }
    }
    [[nodiscard]] ColumnBase& column(PropertyInfo const& info);
    [[nodiscard]] ColumnBase const* findColumn(PropertyInfo const& info) const;
    [[nodiscard]] SlotBase& slot(PropertyInfo const& info);
    [[nodiscard]] SlotBase const* findSlot(PropertyInfo const& info) const;
    /// All columns in order of their keys.
    [[nodiscard]] std::vector<ColumnBase*> columns();
    [[nodiscard]] std::vector<ColumnBase const*> columns() const;
    /// All slots in order of their properties' keys.
    [[nodiscard]] std::vector<SlotBase*> slots();
    [[nodiscard]] std::vector<SlotBase const*> slots() const;

    /// Gives an object every property of a prototype.
    void furnish(ObjectId id, Prototype const& prototype);
    [[nodiscard]] PrototypeLibrary& prototypes() { return prototypes_; }
    [[nodiscard]] PrototypeLibrary const& prototypes() const { return prototypes_; }

    /// Runs one completion for some objects, ascending; see runtime/component/completion.hpp.
    using Completion = void (*)(Store&, std::span<ObjectId const>);
    void setCompletions(std::vector<Completion> completions) { completions_ = std::move(completions); }
    /// Runs the completions for objects that have just got their stated properties. Pass all objects that are
    /// created at the same time in one call.
    void complete(std::span<ObjectId const> ids);
    void complete(ObjectId id) { complete({&id, 1}); }

    /// XXH3-64 over all columns in canonical order. It covers the objects only; later frames depend on more,
    /// see World::stateHash().
    [[nodiscard]] std::uint64_t hash() const;
    /// Hashes the columns and the ids that the next objects will get.
    void hash(StateHash& hash) const;
    /// Increases when any object gains or loses any property.
    [[nodiscard]] std::uint64_t structureVersion() const;

private:
    void hashColumns(StateHash& hash) const;

    ObjectTable objects_;
    std::map<std::string_view, std::unique_ptr<ColumnBase>> columns_; // by key: the canonical order
    std::map<std::string_view, std::unique_ptr<SlotBase>> slots_;
    std::unordered_map<std::string, ObjectId> byName_; // looked up, never iterated over
    PrototypeLibrary prototypes_;
    std::multimap<ObjectId, std::string> aliases_;
    std::vector<Completion> completions_;
    std::vector<Origin> origins_; // by index of the object
};

} // namespace trembler
