// A script's memory from turn to turn: fields that its manifest declares, per object and for itself.
#pragma once

#include "lua/interaction/manifest.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/property/state_hash.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trembler::lua {

/// Bytes that the values of all objects may take in the store of one script.
inline constexpr std::size_t largestStore = std::size_t{64} << 20U;

class ScriptStore {
public:
    explicit ScriptStore(Manifest const& manifest);

    /// The place of a field, or nothing.
    [[nodiscard]] std::optional<std::size_t> objectField(std::string_view name) const;
    [[nodiscard]] std::optional<std::size_t> scriptField(std::string_view name) const;
    [[nodiscard]] Value const& ofObject(ObjectId id, std::size_t field) const;
    [[nodiscard]] Value const& ofScript(std::size_t field) const { return script_[field]; }
    /// Sets a field; returns the fault of the value, in words, or nothing.
    [[nodiscard]] std::string setOfObject(ObjectId id, std::size_t field, Value value);
    [[nodiscard]] std::string setOfScript(std::size_t field, Value value);
    /// Takes over, from the store of another version of the script, the fields that both declare with the
    /// same name and kind of value, and the place in the sequence of random(). All other fields have their
    /// initial values.
    void adopt(ScriptStore const& before);
    /// Forgets the objects that no longer exist.
    void keepOnly(std::function<bool(ObjectId)> const& alive);

    /// The next number of a sequence, in [0, 1). It depends on the script's name and on how many came before.
    [[nodiscard]] double random();

    /// Whether a value was refused because all values of the script take as much memory as they may.
    [[nodiscard]] bool full() const { return full_; }

    void hash(StateHash& hash) const;

private:
    void count();
    [[nodiscard]] static std::string fault(StoreField const& field, Value const& value);

    std::vector<StoreField> objectFields_;
    std::vector<StoreField> scriptFields_;
    std::map<ObjectId, std::vector<Value>> objects_; // the objects whose store has been written to
    std::vector<Value> script_;
    std::uint64_t seed_;
    std::uint64_t draws_ = 0;
    std::size_t bytes_ = 0; // of objects_, about
    bool full_ = false;
};

} // namespace trembler::lua
