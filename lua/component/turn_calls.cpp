// Calls of the resolver, as a script makes them.
#include "lua/component/turn_binding.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <cstring>

namespace trembler::lua {

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
    auto const form = upvalue(L, 2) == 0 ? ArgumentForm::stated : ArgumentForm::numbers;
    sandbox_.chargeCall(L, plan.creates);
    char* const place = gatherer_.place(number);
    if (!plan.plain || !readPlain(L, plan, place, form)) {
        CallDescription const& description = script_->role->calls[number];
        CallBytes bytes;
        readArguments(L, sandbox_, context_->store, description, objectAt_, bytes, form);
        std::memcpy(place, bytes.bytes.data(), description.size);
    }
    if (context_->sink == nullptr) {
        gatherer_.add(number);
    } else {
        context_->source.record(number, place, target().cause, context_->sink);
        gatherer_.close();
    }
    return 0;
}

/// Reads arguments in the usual form: all stated, in order and in range, and every object one of the
/// target's. False if they are not; readArguments() then finds their faults, if there are any.
bool Turns::Binding::readPlain(lua_State* L, CallPlan const& plan, char* into, ArgumentForm form) const {
    int index = 1;
    for (PlainArgument const& argument : plan.arguments) {
        char* const place = into + argument.offset;
        if (argument.kind == FieldKind::object) {
            void const* const address = lua_topointer(L, index);
            if (address == nullptr || (address != slots_[0].address && address != slots_[1].address)) {
                return false;
            }
            ObjectId const id = idOf(address == slots_[0].address ? 0 : 1);
            if (id == worldId_) {
                return false; // a call may take it or not
            }
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
        } else if (argument.kind == FieldKind::vector && form == ArgumentForm::stated) {
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

} // namespace trembler::lua
