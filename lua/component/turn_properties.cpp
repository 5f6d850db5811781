// Properties that a script reads although its tables do not hold them in advance, and errors for properties
// that it may not read.
#include "lua/component/turn_binding.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace trembler::lua {

std::string Turns::Binding::keyAt(lua_State* L, int index) {
    return lua_type(L, index) == LUA_TSTRING && lua_objlen(L, index) <= longestText ? lua_tostring(L, index)
                                                                                    : "?";
}

int Turns::Binding::refuseChange(lua_State* L) {
    sandbox_.raise(L, fmt::format("'{}' cannot be changed: an interaction changes nothing but by calling its "
                                  "resolver, and what it keeps is in store",
                                  keyAt(L, 2)));
}

int Turns::Binding::objectFallback(lua_State* L) {
    std::string const name = keyAt(L, 2);
    if (DeclaredProperty const* const property = script_->read(name)) {
        if (!property->ofObjects()) {
            sandbox_.raise(
                L, fmt::format("'{}' is no property of an object; read it as world{}", name, indexed(name)));
        }
        lua_pushnil(L);
        return 1;
    }
    refuseProperty(L, name, "object");
}

void Turns::Binding::refuseProperty(lua_State* L, std::string const& name, std::string_view of) {
    auto const known = script_->readNames();
    sandbox_.raise(L, fmt::format("the script does not declare that it reads '{}' of the {}{}; expected {}",
                                  name, of, didYouMean(name, known),
                                  known.empty() ? std::string("its name in reads") : listed(known)));
}

std::string Turns::Binding::indexed(std::string const& name) {
    bool const plain = std::all_of(name.begin(), name.end(),
                                   [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    return plain ? "." + name : "[\"" + name + "\"]";
}

int Turns::Binding::fieldFallback(lua_State* L) {
    Slot const& slot = slots_[upvalue(L, 1)];
    Shown const& shown = slot.shown[upvalue(L, 2)];
    pushFieldOf(L, script_->reads[shown.read], keyAt(L, 2), idOf(upvalue(L, 1)));
    return 1;
}

void Turns::Binding::refuseField(lua_State* L, DeclaredProperty const& property, std::string const& key) {
    auto const known = property.keys();
    sandbox_.raise(L, known.empty() ? fmt::format("{} has no fields", property.name)
                                    : fmt::format("{} has no '{}'{}; it has {}", property.name, key,
                                                  didYouMean(key, known), listed(known)));
}

void Turns::Binding::pushFieldOf(lua_State* L, DeclaredProperty const& property, std::string const& key,
                                 ObjectId id) {
    FieldPlace const* const place = property.field(key);
    if (place == nullptr) {
        refuseField(L, property, key);
    }
    Home const& home = homeOf(property);
    if (isPlain(*place)) {
        void const* const value = home.slot != nullptr ? home.slot->data()
                                                       : static_cast<char const*>(home.column->data()) +
                                                             home.column->info().size * home.column->row(id);
        pushField(L, sandbox_, *place, value, pushObject_);
        return;
    }
    FieldPusher pusher(L, sandbox_, place->info.key, pushObject_);
    if (home.slot != nullptr) {
        home.slot->visitCurrent(pusher);
    } else {
        home.column->visitCopy(id, pusher);
    }
    if (!pusher.found()) { // a field that depends on a choice that this object has not made
        lua_pushnil(L);
    }
}

void Turns::Binding::pushTableOf(lua_State* L, DeclaredProperty const& property, ObjectId id) {
    constexpr double chargePerField = 10;
    sandbox_.charge(L, chargePerField * static_cast<double>(property.fields.size()));
    lua_newtable(L);
    for (FieldPlace const& place : property.fields) {
        lua_pushlstring(L, place.info.key.data(), place.info.key.size());
        pushFieldOf(L, property, std::string(place.info.key), id);
        lua_rawset(L, -3);
    }
    get(L, readingMetas_[numberOf(property)]);
    sandbox_.closeReading(L);
}

/// A field of a table that pushTableOf() has made: nil for one that depends on a choice that was not made.
int Turns::Binding::readingIndex(lua_State* L) {
    sandbox_.pushInside(L, 1);
    lua_pushvalue(L, 2);
    lua_rawget(L, -2);
    DeclaredProperty const& property = script_->reads[upvalue(L, 1)];
    std::string const key = keyAt(L, 2);
    if (lua_isnil(L, -1) && property.field(key) == nullptr) {
        refuseField(L, property, key);
    }
    return 1;
}

int Turns::Binding::worldIndex(lua_State* L) {
    std::string const name = keyAt(L, 2);
    DeclaredProperty const* const property = script_->read(name);
    if (property == nullptr) {
        refuseProperty(L, name, "world");
    }
    get(L, worldCache_);
    lua_pushvalue(L, 2);
    lua_rawget(L, -2);
    if (!lua_isnil(L, -1)) {
        return 1;
    }
    lua_pop(L, 1);
    ObjectId const world = context_->store.find("world");
    Home const& home = homeOf(*property);
    if (home.column != nullptr && !home.column->has(world)) {
        lua_pushnil(L);
        return 1;
    }
    pushTableOf(L, *property, world);
    lua_pushvalue(L, 2);
    lua_pushvalue(L, -2);
    lua_rawset(L, -4);
    return 1;
}

Home const& Turns::Binding::homeOf(DeclaredProperty const& property) const {
    return context_->homes[numberOf(property)];
}

std::size_t Turns::Binding::numberOf(DeclaredProperty const& property) const {
    return static_cast<std::size_t>(&property - script_->reads.data());
}

} // namespace trembler::lua
