// The tables that a script sees, made once for its state.
#include "lua/component/turn_binding.hpp"

#include <algorithm>

namespace trembler::lua {

std::size_t Turns::Binding::upvalue(lua_State* L, int n) {
    return static_cast<std::size_t>(lua_tonumber(L, lua_upvalueindex(n + 1)));
}
int Turns::Binding::keep(lua_State* L) {
    return luaL_ref(L, LUA_REGISTRYINDEX);
}
void Turns::Binding::get(lua_State* L, int reference) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, reference);
}

/// Pushes the script's view of the table on top of the stack; the table stays below it.
void Turns::Binding::pushShown(lua_State* L, std::string_view name) {
    if (!direct_) {
        pushProxy(L, name);
        return;
    }
    if (lua_getmetatable(L, -1) == 0) {
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_setmetatable(L, -3);
    }
    closeMetatable(L, name);
    lua_pop(L, 1);
    lua_pushvalue(L, -1);
}
/// Pushes an empty table that shows the one on top of the stack, which stays below it.
void Turns::Binding::pushProxy(lua_State* L, std::string_view name) {
    lua_newtable(L);
    lua_newtable(L);
    lua_pushvalue(L, -3);
    lua_setfield(L, -2, "__index");
    closeMetatable(L, name);
    lua_setmetatable(L, -2);
}
/// The metatable on top of the stack is that of a table of the host: it is called `name` in messages and
/// cannot be changed.
void Turns::Binding::closeMetatable(lua_State* L, std::string_view name) {
    pushFunction<&Binding::refuseChange>(L);
    lua_setfield(L, -2, "__newindex");
    sandbox_.pushHostMark(L);
    lua_setfield(L, -2, "__metatable");
    lua_pushlstring(L, name.data(), name.size());
    lua_setfield(L, -2, "__name");
}

void Turns::Binding::setUp(lua_State* L) {
    direct_ = !sandbox_.source().assignsFields;
    setUpReadings(L);
    setUpHandles(L);
    if (script_->manifest.application != Application::once) {
        setUpSlot(L, 0, script_->first);
    }
    if (script_->manifest.application == Application::pairs) {
        setUpSlot(L, 1, script_->second);
    }
    setUpParameters(L);
    setUpCalls(L);
    setUpStore(L);
    setUpFrame(L);
    setUpWorld(L);
    if (sandbox_.trusted() && canDrive()) {
        setUpDriver(L);
    }
}

void Turns::Binding::setUpReadings(lua_State* L) {
    for (std::size_t read = 0; read < script_->reads.size(); ++read) {
        lua_newtable(L);
        sandbox_.pushReadingMeta(L);
        for (char const* const key : {"__newindex", "__metatable"}) {
            lua_getfield(L, -1, key);
            lua_setfield(L, -3, key);
        }
        lua_pop(L, 1);
        pushFunction<&Binding::readingIndex>(L, read);
        lua_setfield(L, -2, "__index");
        readingMetas_.push_back(keep(L));
    }
}

void Turns::Binding::setUpHandles(lua_State* L) {
    lua_newtable(L);
    pushFunction<&Binding::handleIndex>(L);
    lua_setfield(L, -2, "__index");
    pushFunction<&Binding::refuseChange>(L);
    lua_setfield(L, -2, "__newindex");
    pushFunction<&Binding::handleEqual>(L);
    lua_setfield(L, -2, "__eq");
    sandbox_.pushHostMark(L);
    lua_setfield(L, -2, "__metatable");
    handleMeta_ = keep(L);
}

void Turns::Binding::setUpSlot(lua_State* L, std::size_t number, std::vector<std::size_t> const& required) {
    Slot& slot = slots_[number];
    lua_newtable(L); // its properties
    setFallback<&Binding::objectFallback>(L, number);
    for (std::size_t read = 0; read < script_->reads.size(); ++read) {
        DeclaredProperty const& property = script_->reads[read];
        if (property.name.empty() || !property.ofObjects()) {
            continue;
        }
        Shown shown;
        shown.read = read;
        shown.required = std::find(required.begin(), required.end(), read) != required.end();
        lua_newtable(L); // its fields
        setFallback<&Binding::fieldFallback>(L, number, slot.shown.size());
        for (FieldPlace const& place : property.fields) {
            if (isEager(place)) {
                slot.eager.push_back(makeEager(L, slot.shown.size(), place));
            }
        }
        pushShown(L, "property");
        if (shown.required) {
            lua_pushlstring(L, property.name.data(), property.name.size());
            lua_pushvalue(L, -2);
            lua_rawset(L, -5); // into the object's properties
            shown.present = true;
        }
        shown.proxy = keep(L);
        shown.values = keep(L);
        for (Eager& eager : slot.eager) {
            eager.table = eager.table == 0 ? shown.values : eager.table;
        }
        slot.shown.push_back(std::move(shown));
    }
    pushShown(L, "object");
    slot.address = lua_topointer(L, -1);
    slot.proxy = keep(L);
    slot.fields = keep(L);
}

/// Whether the field is written in advance: the script's text mentions it. Others are read by the fallback. A
/// script that assigns to fields could change a vector, so it gets a new one each time.
bool Turns::Binding::isEager(FieldPlace const& place) const {
    bool const cheap = place.kind == FieldKind::boolean || place.kind == FieldKind::integer ||
                       place.kind == FieldKind::number || (place.kind == FieldKind::vector && direct_);
    return cheap && isPlain(place) && script_->words.contains(place.info.key);
}

// With the table of fields on top of the stack.
Turns::Binding::Eager Turns::Binding::makeEager(lua_State* L, std::size_t shown, FieldPlace const& place) {
    Eager made{.shown = shown, .place = place};
    lua_pushlstring(L, place.info.key.data(), place.info.key.size());
    if (place.kind == FieldKind::vector) {
        sandbox_.pushVector(L, 0, 0);
        lua_pushvalue(L, -1);
        made.table = keep(L);
        lua_rawset(L, -3);
    } else {
        lua_pushvalue(L, -1);
        made.key = keep(L);
        lua_pushnumber(L, 0);
        lua_rawset(L, -3); // a key from the beginning, so that compiled code finds it in its place
    }
    return made;
}

void Turns::Binding::setUpParameters(lua_State* L) {
    lua_newtable(L);
    setFallback<&Binding::parameterFallback>(L);
    pushShown(L, "params");
    parameters_ = keep(L);
    parameterValues_ = keep(L);
}

void Turns::Binding::setUpCalls(lua_State* L) {
    lua_newtable(L);
    setFallback<&Binding::callFallback>(L);
    for (std::size_t i = 0; i < script_->role->calls.size(); ++i) {
        plans_.push_back(planOf(script_->role->calls[i]));
        std::string_view const name = script_->role->calls[i].text.name;
        lua_pushlstring(L, name.data(), name.size());
        pushFunction<&Binding::makeCall>(L, i);
        lua_rawset(L, -3);
    }
    pushShown(L, "out");
    out_ = keep(L);
    outValues_ = keep(L);
    lua_newtable(L);
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        if (plans_[i].plain && plans_[i].hasVector()) {
            std::string_view const name = script_->role->calls[i].text.name;
            lua_pushlstring(L, name.data(), name.size());
            pushFunction<&Binding::makeCall>(L, i, 1);
            lua_rawset(L, -3);
        }
    }
    lua_pushvalue(L, -1);
    outNumbers_ = keep(L);
    sandbox_.showChunk(L, CountedSource::numbersName);
}

void Turns::Binding::setUpStore(lua_State* L) {
    lua_newtable(L);
    setFallback<&Binding::missing>(L, 1);
    for (std::size_t of = 0; of < 2; ++of) {
        lua_newtable(L);
        lua_newtable(L);
        pushFunction<&Binding::storeIndex>(L, of);
        lua_setfield(L, -2, "__index");
        pushFunction<&Binding::storeChange>(L, of);
        lua_setfield(L, -2, "__newindex");
        sandbox_.pushHostMark(L);
        lua_setfield(L, -2, "__metatable");
        lua_pushliteral(L, "store");
        lua_setfield(L, -2, "__name");
        lua_setmetatable(L, -2);
        lua_setfield(L, -2, of == 0 ? "object" : "script");
    }
    pushShown(L, "store");
    store_ = keep(L);
    lua_pop(L, 1);
}

void Turns::Binding::setUpFrame(lua_State* L) {
    lua_newtable(L);
    setFallback<&Binding::missing>(L, 0);
    pushFunction<&Binding::random>(L);
    lua_setfield(L, -2, "random");
    lua_pushnumber(L, 0);
    lua_setfield(L, -2, "duration"); // so that it is there before it is set
    pushShown(L, "frame");
    frame_ = keep(L);
    frameValues_ = keep(L);
}

void Turns::Binding::setUpWorld(lua_State* L) {
    lua_newtable(L);
    worldCache_ = keep(L);
    sandbox_.pushSurroundings(L);
    lua_newtable(L);
    setFallback<&Binding::worldIndex>(L);
    pushProxy(L, "world");
    worldAddress_ = lua_topointer(L, -1);
    lua_pushvalue(L, -1);
    world_ = keep(L);
    lua_setfield(L, -3, "world");
    lua_pop(L, 1);
    pushFunction<&Binding::isAlive>(L);
    lua_setfield(L, -2, "alive");
    pushFunction<&Binding::isSame>(L);
    lua_setfield(L, -2, "same");
    lua_pop(L, 1);
}

} // namespace trembler::lua
