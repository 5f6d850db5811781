#include "lua/component/script_store.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::lua {
namespace {

// SplitMix64's finaliser (Steele, Lea and Flood 2014).
std::uint64_t scrambled(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31U);
}

std::optional<std::size_t> placeOf(std::vector<StoreField> const& fields, std::string_view name) {
    auto const at = std::find_if(fields.begin(), fields.end(),
                                 [&](StoreField const& field) { return field.name == name; });
    return at == fields.end() ? std::nullopt
                              : std::optional<std::size_t>(static_cast<std::size_t>(at - fields.begin()));
}

std::vector<Value> initialOf(std::vector<StoreField> const& fields) {
    std::vector<Value> values;
    for (StoreField const& field : fields) {
        values.push_back(field.initial);
    }
    return values;
}

// The same on every machine, as it decides where a script is stopped: an object in the map, and a value, take
// no more than this beside the value's text.
constexpr std::size_t bytesPerObject = 100;
constexpr std::size_t bytesPerValue = 40;

std::size_t textBytes(Value const& value) {
    std::string const* const text = std::get_if<std::string>(&value);
    return text == nullptr ? 0 : text->size();
}
std::size_t bytesOf(std::vector<Value> const& values) {
    std::size_t bytes = bytesPerObject + bytesPerValue * values.size();
    for (Value const& value : values) {
        bytes += textBytes(value);
    }
    return bytes;
}

void hashValues(StateHash& hash, std::vector<Value> const& values) {
    hash.integer(values.size());
    for (Value const& value : values) {
        hash.integer(value.index());
        std::visit([&](auto const& held) { hash.value(held); }, value);
    }
}

} // namespace

ScriptStore::ScriptStore(Manifest const& manifest)
    : objectFields_(manifest.objectStore), scriptFields_(manifest.scriptStore),
      script_(initialOf(manifest.scriptStore)), seed_(0xcbf29ce484222325ULL) {
    for (char const c : manifest.name) { // FNV-1a
        seed_ = (seed_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
}

std::optional<std::size_t> ScriptStore::objectField(std::string_view name) const {
    return placeOf(objectFields_, name);
}
std::optional<std::size_t> ScriptStore::scriptField(std::string_view name) const {
    return placeOf(scriptFields_, name);
}

Value const& ScriptStore::ofObject(ObjectId id, std::size_t field) const {
    auto const at = objects_.find(id);
    return at == objects_.end() ? objectFields_[field].initial : at->second[field];
}

std::string ScriptStore::fault(StoreField const& field, Value const& value) {
    if (value.index() != field.initial.index()) {
        return fmt::format("'{}' in the store is {} and cannot be {}", field.name, kindOf(field.initial),
                           kindOf(value));
    }
    if (!isFinite(value)) {
        return fmt::format("'{}' in the store cannot be a number that is not finite", field.name);
    }
    if (std::string const* const text = std::get_if<std::string>(&value);
        text != nullptr && text->size() > longestText) {
        return fmt::format("'{}' in the store is a text of at most {} bytes", field.name, longestText);
    }
    return {};
}

std::string ScriptStore::setOfObject(ObjectId id, std::size_t field, Value value) {
    std::string wrong = fault(objectFields_[field], value);
    if (!wrong.empty()) {
        return wrong;
    }
    auto at = objects_.find(id);
    std::vector<Value> made;
    if (at == objects_.end()) {
        made = initialOf(objectFields_);
    }
    Value& place = (at == objects_.end() ? made : at->second)[field];
    std::size_t const after =
        bytes_ + (made.empty() ? 0 : bytesOf(made)) + textBytes(value) - textBytes(place);
    if (after > largestStore && after > bytes_) {
        full_ = true;
        return fmt::format(
            "the store of the script is full: the values of its objects take more than {} bytes",
            largestStore);
    }
    bytes_ = after;
    place = std::move(value);
    if (!made.empty()) {
        objects_.emplace(id, std::move(made));
    }
    return wrong;
}

std::string ScriptStore::setOfScript(std::size_t field, Value value) {
    std::string wrong = fault(scriptFields_[field], value);
    if (wrong.empty()) {
        script_[field] = std::move(value);
    }
    return wrong;
}

void ScriptStore::keepOnly(std::function<bool(ObjectId)> const& alive) {
    if (std::erase_if(objects_, [&](auto const& entry) { return !alive(entry.first); }) > 0) {
        count();
    }
}

void ScriptStore::count() {
    bytes_ = 0;
    for (auto const& [id, values] : objects_) {
        bytes_ += bytesOf(values);
    }
}

double ScriptStore::random() {
    std::uint64_t const bits = scrambled(seed_ ^ scrambled(++draws_));
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

void ScriptStore::hash(StateHash& hash) const {
    hashValues(hash, script_);
    hash.integer(objects_.size());
    for (auto const& [id, values] : objects_) {
        hash.value(id);
        hashValues(hash, values);
    }
    hash.integer(draws_);
}

} // namespace trembler::lua
