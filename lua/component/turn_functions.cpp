// What the tables of a script do: reading what is not written in advance, handles, calls, and what lasts.
#include "lua/component/turn_binding.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>

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
    sandbox_.raise(L,
                   fmt::format("the script does not declare that it reads '{}' of the {}{}; reads = {{ {} }}",
                               name, of, didYouMean(name, known), listed(known)));
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

void Turns::Binding::pushFieldOf(lua_State* L, DeclaredProperty const& property, std::string const& key,
                                 ObjectId id) {
    FieldPlace const* const place = property.field(key);
    if (place == nullptr) {
        auto const known = property.keys();
        sandbox_.raise(L, known.empty() ? fmt::format("{} has no fields", property.name)
                                        : fmt::format("{} has no '{}'{}; it has {}", property.name, key,
                                                      didYouMean(key, known), listed(known)));
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
    if (!pusher.found()) { // one that depends on a choice that this object has not made
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

int Turns::Binding::parameterFallback(lua_State* L) {
    std::vector<std::string> known;
    for (Parameter const& parameter : script_->manifest.parameters) {
        known.push_back(parameter.name);
    }
    std::string const name = keyAt(L, 2);
    sandbox_.raise(L, fmt::format("there is no parameter '{}'{}; params has {}", name,
                                  didYouMean(name, known), known.empty() ? "nothing" : listed(known)));
}

int Turns::Binding::callFallback(lua_State* L) {
    std::vector<std::string> known;
    for (CallDescription const& call : script_->role->calls) {
        known.emplace_back(call.text.name);
    }
    std::string const name = keyAt(L, 2);
    sandbox_.raise(L, fmt::format("{} has no function '{}'{}; it has {}", script_->role->name, name,
                                  didYouMean(name, known), listed(known)));
}

int Turns::Binding::makeCall(lua_State* L) {
    std::size_t const number = upvalue(L, 1);
    if (context_ == nullptr || targets_ == nullptr) {
        sandbox_.raise(L, "calls are made in apply");
    }
    CallPlan const& plan = plans_[number];
    sandbox_.chargeCall(L, plan.creates);
    char* const place = gatherer_.place(number);
    if (!plan.plain || !readPlain(L, plan, place)) {
        CallDescription const& description = script_->role->calls[number];
        CallBytes bytes;
        readArguments(L, sandbox_, context_->store, description, objectAt_, bytes);
        std::memcpy(place, bytes.bytes.data(), description.size);
    }
    if (context_->sink == nullptr) {
        gatherer_.add(number);
    } else {
        context_->source.record(number, place, target().cause, context_->sink);
    }
    return 0;
}

/// Reads the arguments as they mostly are, all stated, in order and
/// in range, and the objects those of the target. False if they are
/// not; readArguments() then finds out what is wrong with them, if
/// anything is.
bool Turns::Binding::readPlain(lua_State* L, CallPlan const& plan, char* into) const {
    int index = 1;
    for (PlainArgument const& argument : plan.arguments) {
        char* const place = into + argument.offset;
        if (argument.kind == FieldKind::object) {
            void const* const address = lua_topointer(L, index);
            if (address == nullptr || (address != slots_[0].address && address != slots_[1].address)) {
                return false;
            }
            ObjectId const id = idOf(address == slots_[0].address ? 0 : 1);
            std::memcpy(place, &id, sizeof id);
        } else if (lua_type(L, index) == LUA_TNUMBER) {
            double const value = lua_tonumber(L, index);
            if (!argument.takes(value) || argument.kind == FieldKind::boolean) {
                return false;
            }
            std::memcpy(place, &value, sizeof value);
            if (argument.kind == FieldKind::vector) {
                ++index;
                double const second = lua_tonumber(L, index);
                if (lua_type(L, index) != LUA_TNUMBER || !argument.takes(second)) {
                    return false;
                }
                std::memcpy(place + sizeof value, &second, sizeof second);
            }
        } else if (argument.kind == FieldKind::vector) {
            auto const vector = sandbox_.vectorAt(L, index);
            if (!vector || !argument.takes(vector->x) || !argument.takes(vector->y)) {
                return false;
            }
            std::memcpy(place, &*vector, sizeof *vector);
        } else if (argument.kind == FieldKind::boolean && lua_type(L, index) == LUA_TBOOLEAN) {
            bool const value = lua_toboolean(L, index) != 0;
            std::memcpy(place, &value, sizeof value);
        } else {
            return false;
        }
        ++index;
    }
    return index == lua_gettop(L) + 1;
}

Home const& Turns::Binding::homeOf(DeclaredProperty const& property) const {
    return context_->homes[static_cast<std::size_t>(&property - script_->reads.data())];
}

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
    if (lua_type(L, index) == LUA_TUSERDATA) { // there are no others
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
    return address == worldAddress_ ? std::optional(context_->store.find("world")) : std::nullopt;
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

int Turns::Binding::isAlive(lua_State* L) {
    auto const id = objectAt(L, 1);
    lua_pushboolean(L, id && context_ != nullptr && context_->store.alive(*id) ? 1 : 0);
    return 1;
}

int Turns::Binding::storeIndex(lua_State* L) {
    bool const ofScript = upvalue(L, 1) == 1;
    std::size_t const field = storeField(L, ofScript);
    pushValue(L, sandbox_,
              ofScript ? context_->kept.ofScript(field) : context_->kept.ofObject(idOf(0), field));
    return 1;
}

int Turns::Binding::storeChange(lua_State* L) {
    bool const ofScript = upvalue(L, 1) == 1;
    std::size_t const field = storeField(L, ofScript);
    auto value = valueAt(L, sandbox_, 3);
    std::string wrong;
    if (!value) {
        wrong = fmt::format("'{}' in the store cannot be a {}", keyAt(L, 2), kindOf(L, 3));
    } else if (ofScript) {
        wrong = context_->kept.setOfScript(field, std::move(*value));
    } else {
        wrong = context_->kept.setOfObject(idOf(0), field, std::move(*value));
    }
    if (!wrong.empty()) {
        sandbox_.raise(L, wrong);
    }
    return 0;
}

std::size_t Turns::Binding::storeField(lua_State* L, bool ofScript) {
    std::string const name = keyAt(L, 2);
    auto const field = context_ == nullptr ? std::nullopt
                       : ofScript          ? context_->kept.scriptField(name)
                                           : context_->kept.objectField(name);
    if (!field) {
        std::vector<std::string> known;
        for (StoreField const& declared :
             ofScript ? script_->manifest.scriptStore : script_->manifest.objectStore) {
            known.push_back(declared.name);
        }
        sandbox_.raise(L, fmt::format("the store declares no '{}'{}; store.{} has {}", name,
                                      didYouMean(name, known), ofScript ? "script" : "object",
                                      known.empty() ? "nothing" : listed(known)));
    }
    return *field;
}

int Turns::Binding::missing(lua_State* L) {
    bool const ofStore = upvalue(L, 1) == 1;
    sandbox_.raise(L, fmt::format("{} has no '{}'; it has {}", ofStore ? "store" : "frame", keyAt(L, 2),
                                  ofStore ? "'object' and 'script', with what the script declares"
                                          : "'duration', in s, and 'random()'"));
}

int Turns::Binding::random(lua_State* L) {
    lua_pushnumber(L, context_ == nullptr ? 0 : context_->kept.random());
    return 1;
}

} // namespace trembler::lua
