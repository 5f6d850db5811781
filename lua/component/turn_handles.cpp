// Handles: objects that a script sees besides the objects to which it is applied.
#include "lua/component/turn_binding.hpp"

#include <fmt/format.h>

#include <cstring>

namespace trembler::lua {

void Turns::Binding::pushHandle(lua_State* L, ObjectId id) {
    if (!id.valid()) {
        lua_pushnil(L);
        return;
    }
    void* const place = lua_newuserdata(L, sizeof id);
    std::memcpy(place, &id, sizeof id);
    get(L, handleMeta_);
    lua_setmetatable(L, -2);
}

std::optional<ObjectId> Turns::Binding::objectAt(lua_State* L, int index) const {
    if (lua_type(L, index) == LUA_TUSERDATA) { // handles are the only userdata
        ObjectId id;
        std::memcpy(&id, lua_touserdata(L, index), sizeof id);
        return id;
    }
    if (lua_type(L, index) != LUA_TTABLE) {
        return std::nullopt;
    }
    void const* const address = lua_topointer(L, index);
    for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
        if (slots_[slot].address == address && targets_ != nullptr) {
            return idOf(slot);
        }
    }
    return address == worldAddress_ ? std::optional(worldId_) : std::nullopt;
}

int Turns::Binding::handleIndex(lua_State* L) {
    auto const id = objectAt(L, 1);
    std::string const name = keyAt(L, 2);
    DeclaredProperty const* const property = script_->read(name);
    if (property == nullptr) {
        refuseProperty(L, name, "object");
    }
    if (!id || context_ == nullptr || !context_->store.alive(*id)) {
        sandbox_.raise(L, fmt::format("the object whose '{}' is read is gone", name));
    }
    if (!property->ofObjects()) {
        sandbox_.raise(
            L, fmt::format("'{}' is no property of an object; read it as world{}", name, indexed(name)));
    }
    Home const& home = homeOf(*property);
    if (!home.column->has(*id)) {
        lua_pushnil(L);
        return 1;
    }
    pushTableOf(L, *property, *id);
    return 1;
}

int Turns::Binding::handleEqual(lua_State* L) {
    lua_pushboolean(L, objectAt(L, 1) == objectAt(L, 2) ? 1 : 0);
    return 1;
}

int Turns::Binding::isSame(lua_State* L) {
    sandbox_.checkArguments(L, "same");
    return handleEqual(L);
}

int Turns::Binding::isAlive(lua_State* L) {
    sandbox_.checkArguments(L, "alive");
    auto const id = objectAt(L, 1);
    lua_pushboolean(L, id && context_ != nullptr && context_->store.alive(*id) ? 1 : 0);
    return 1;
}

} // namespace trembler::lua
