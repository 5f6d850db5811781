// One property of all the objects that have it, densely packed.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/property/field_visitor.hpp"
#include "runtime/property/property_info.hpp"
#include "runtime/property/state_hash.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

namespace trembler {

/// The operations on a column that do not need its property type.
///
/// Rows are always in the order of object indices. So two columns with the same set of owners have the same
/// row order, which lets forEach() run through them in lock-step, and every walk is in canonical order.
class ColumnBase {
public:
    explicit ColumnBase(PropertyInfo const& info) : info_(info) {}
    virtual ~ColumnBase() = default;
    ColumnBase(ColumnBase const&) = delete;
    ColumnBase& operator=(ColumnBase const&) = delete;

    [[nodiscard]] PropertyInfo const& info() const { return info_; }
    [[nodiscard]] std::size_t size() const { return owners_.size(); }
    [[nodiscard]] bool empty() const { return owners_.empty(); }
    /// The owner of every row, ascending.
    [[nodiscard]] std::span<ObjectId const> owners() const { return owners_; }
    [[nodiscard]] bool has(ObjectId id) const { return row(id) != absent; }

    static constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();
    /// The row of an object, or `absent`.
    [[nodiscard]] std::uint32_t row(ObjectId id) const {
        if (id.index >= rows_.size()) {
            return absent;
        }
        std::uint32_t const r = rows_[id.index];
        return r != absent && owners_[r].generation == id.generation ? r : absent;
    }

    /// Increases whenever a value may have changed. While it is the same as before, a reader has seen all
    /// values.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Where it is kept, for its life.
    [[nodiscard]] std::uint64_t const* versionPlace() const { return &version_; }
    /// Increases when rows are added or removed.
    [[nodiscard]] std::uint64_t structureVersion() const { return structureVersion_; }
    void touch() { ++version_; }

    /// True if both columns have exactly the same owners, hence the same row order. O(1): compares a sum of
    /// mixed ids that insertion and removal maintain.
    [[nodiscard]] bool sameOwners(ColumnBase const& other) const {
        return owners_.size() == other.owners_.size() && membership_ == other.membership_;
    }

    /// Gives an object the property with its default value, unless it has the property.
    virtual void addDefault(ObjectId id) = 0;
    /// Removes the property from an object. Does nothing if the object does not have it.
    virtual void remove(ObjectId id) = 0;
    /// Removes it from many objects in one pass. Objects without it, and repeated ids, are ignored.
    virtual void removeAll(std::span<ObjectId const> ids) = 0;
    virtual void visit(ObjectId id, FieldVisitor& visitor) = 0;
    /// Visits a copy of the value, so that the visitor can change nothing.
    virtual void visitCopy(ObjectId id, FieldVisitor& visitor) const = 0;
    virtual void hash(StateHash& hash) const = 0;
    /// The first of its values, which lie side by side; see PropertyInfo::size and fields.
    [[nodiscard]] virtual void const* data() const = 0;

protected:
    /// Makes room for a row and returns its position; rows above move up by one.
    std::uint32_t insertOwner(ObjectId id);
    /// The same for many objects in one pass: `ids` are ascending, and none of them has a row.
    void insertOwners(std::span<ObjectId const> ids);
    void eraseOwner(std::uint32_t row);
    /// Erases the owners in `ids` and returns the remaining rows, ascending; empty if nothing was erased.
    std::vector<std::uint32_t> eraseOwners(std::span<ObjectId const> ids);

private:
    PropertyInfo const& info_;
    std::vector<ObjectId> owners_;
    std::vector<std::uint32_t> rows_; // by object index
    std::uint64_t membership_ = 0;
    std::uint64_t version_ = 1;
    std::uint64_t structureVersion_ = 1;
};

template <ObjectProperty P>
class Column final : public ColumnBase {
public:
    Column() : ColumnBase(propertyInfo<P>()) {}

    [[nodiscard]] std::span<P> values() { return values_; }
    [[nodiscard]] std::span<P const> values() const { return values_; }

    /// The object's value, or nullptr if it has none. Valid until rows are added or removed.
    [[nodiscard]] P* find(ObjectId id) {
        std::uint32_t const r = row(id);
        return r == absent ? nullptr : &values_[r];
    }
    [[nodiscard]] P const* find(ObjectId id) const {
        std::uint32_t const r = row(id);
        return r == absent ? nullptr : &values_[r];
    }
    /// The value of an object that is known to have it.
    [[nodiscard]] P& operator[](ObjectId id) {
        assert(has(id));
        return values_[row(id)];
    }
    [[nodiscard]] P const& operator[](ObjectId id) const {
        assert(has(id));
        return values_[row(id)];
    }

    /// Gives an object the property, or replaces its value.
    void set(ObjectId id, P value) {
        touch();
        std::uint32_t const r = row(id);
        if (r != absent) {
            values_[r] = std::move(value);
        } else {
            std::uint32_t const fresh = insertOwner(id);
            values_.insert(values_.begin() + fresh, std::move(value));
        }
    }
    /// Gives many objects the property in one pass: O(all rows), where one by one would be quadratic. `ids`
    /// are ascending, none of them has it, and there are as many values.
    void addMany(std::span<ObjectId const> ids, std::vector<P> values) {
        assert(std::is_sorted(ids.begin(), ids.end()) && ids.size() == values.size());
        if (ids.empty()) {
            return;
        }
        bool const atEnd = this->empty() || owners().back() < ids.front();
        if (atEnd) {
            values_.insert(values_.end(), std::make_move_iterator(values.begin()),
                           std::make_move_iterator(values.end()));
        } else {
            std::vector<P> merged;
            merged.reserve(values_.size() + values.size());
            std::size_t next = 0;
            for (std::size_t r = 0; r < values_.size(); ++r) {
                for (; next < ids.size() && ids[next] < owners()[r]; ++next) {
                    merged.push_back(std::move(values[next]));
                }
                merged.push_back(std::move(values_[r]));
            }
            std::move(values.begin() + static_cast<std::ptrdiff_t>(next), values.end(),
                      std::back_inserter(merged));
            values_ = std::move(merged);
        }
        insertOwners(ids);
    }
    void addDefault(ObjectId id) override {
        if (!has(id)) {
            set(id, P{});
        }
    }
    void remove(ObjectId id) override {
        std::uint32_t const r = row(id);
        if (r != absent) {
            eraseOwner(r);
            values_.erase(values_.begin() + r);
        }
    }
    void removeAll(std::span<ObjectId const> ids) override {
        std::size_t const before = size();
        std::vector<std::uint32_t> const kept = eraseOwners(ids);
        if (size() == before) {
            return;
        }
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (kept[i] != i) {
                values_[i] = std::move(values_[kept[i]]);
            }
        }
        values_.resize(kept.size());
    }
    void visit(ObjectId id, FieldVisitor& visitor) override {
        touch();
        visitFields((*this)[id], visitor);
    }
    void visitCopy(ObjectId id, FieldVisitor& visitor) const override {
        P copy = (*this)[id];
        visitFields(copy, visitor);
    }
    [[nodiscard]] void const* data() const override { return values_.data(); }
    void hash(StateHash& hash) const override {
        hash.integer(size());
        hash.bytes(owners().data(), owners().size_bytes());
        if constexpr (hashableAsBytes<P>) {
            assert(fieldBytes() == sizeof(P) && "padding must not reach the hash");
            hash.bytes(values_.data(), values_.size() * sizeof(P));
        } else {
            for (P const& value : values_) {
                hash.members(value); // all members, including members that files never state
            }
        }
    }

private:
    static std::size_t fieldBytes() {
        std::size_t sum = 0;
        P const sample{};
        P::describe(sample, [&](FieldInfo const&, auto const& field) { sum += sizeof field; });
        return sum;
    }

    std::vector<P> values_;
};

} // namespace trembler

// propertyInfo() makes columns, slots and single values, so a file that includes one of them needs all three.
#include "runtime/property/property_value.hpp"
#include "runtime/property/slot.hpp"
