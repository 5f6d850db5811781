#include "runtime/level/property/property_set.hpp"

#include <algorithm>

namespace trembler {
namespace {

bool before(PropertySet::Entry const& entry, std::string_view key) {
    return entry.info->text.key < key;
}

} // namespace

PropertySet::PropertySet(PropertySet const& other) {
    entries_.reserve(other.entries_.size());
    for (Entry const& entry : other.entries_) {
        entries_.push_back({entry.info, entry.value ? entry.value->clone() : nullptr});
    }
}

PropertySet& PropertySet::operator=(PropertySet const& other) {
    if (this != &other) {
        PropertySet copy(other);
        entries_ = std::move(copy.entries_);
    }
    return *this;
}

PropertySet::Entry& PropertySet::place(PropertyInfo const& info) {
    auto at = std::lower_bound(entries_.begin(), entries_.end(), info.text.key, before);
    if (at == entries_.end() || at->info->text.key != info.text.key) {
        at = entries_.insert(at, Entry{&info, nullptr});
    }
    return *at;
}

void PropertySet::set(std::unique_ptr<PropertyValue> value) {
    PropertyInfo const& info = value->info();
    place(info).value = std::move(value);
}

void PropertySet::takeAway(PropertyInfo const& info) {
    place(info).value = nullptr;
}

void PropertySet::erase(PropertyInfo const& info) {
    std::erase_if(entries_, [&](Entry const& entry) { return entry.info->type == info.type; });
}

PropertySet::Entry const* PropertySet::entry(PropertyInfo const& info) const {
    auto const at = std::lower_bound(entries_.begin(), entries_.end(), info.text.key, before);
    return at == entries_.end() || at->info->type != info.type ? nullptr : &*at;
}

PropertyValue const* PropertySet::find(PropertyInfo const& info) const {
    Entry const* const found = entry(info);
    return found == nullptr ? nullptr : found->value.get();
}

PropertyValue* PropertySet::find(PropertyInfo const& info) {
    Entry const* const found = entry(info);
    return found == nullptr ? nullptr : found->value.get();
}

} // namespace trembler
