#include "lua/component/script_store.hpp"

namespace trembler::lua {
namespace {

/// For each field of the new version the place that it had before, if it had one.
std::vector<std::optional<std::size_t>> placesBefore(std::vector<StoreField> const& now,
                                                     std::vector<StoreField> const& before) {
    std::vector<std::optional<std::size_t>> places;
    for (StoreField const& field : now) {
        auto& place = places.emplace_back();
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i].name == field.name && before[i].initial.index() == field.initial.index()) {
                place = i;
            }
        }
    }
    return places;
}

} // namespace

void ScriptStore::adopt(ScriptStore const& before) {
    auto const ofScript = placesBefore(scriptFields_, before.scriptFields_);
    for (std::size_t i = 0; i < ofScript.size(); ++i) {
        script_[i] = ofScript[i] ? before.script_[*ofScript[i]] : scriptFields_[i].initial;
    }
    auto const ofObjects = placesBefore(objectFields_, before.objectFields_);
    objects_.clear();
    if (!objectFields_.empty()) {
        for (auto const& [id, old] : before.objects_) {
            std::vector<Value>& values = objects_[id];
            for (std::size_t i = 0; i < ofObjects.size(); ++i) {
                values.push_back(ofObjects[i] ? old[*ofObjects[i]] : objectFields_[i].initial);
            }
        }
    }
    count();
    draws_ = before.draws_;
}

} // namespace trembler::lua
