// A script's parameters, its store, and the frame.
#include "lua/component/turn_binding.hpp"
#include "lua/sandbox/stack_values.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler::lua {

int Turns::Binding::parameterFallback(lua_State* L) {
    std::vector<std::string> known;
    for (Parameter const& parameter : script_->manifest.parameters) {
        known.push_back(parameter.name);
    }
    std::string const name = keyAt(L, 2);
    sandbox_.raise(L, fmt::format("there is no parameter '{}'{}; params has {}", name,
                                  didYouMean(name, known), known.empty() ? "nothing" : listed(known)));
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
        wrong = fmt::format("'{}' in the store cannot be {}", keyAt(L, 2), kindInWords(L, 3));
    } else if (ofScript) {
        wrong = context_->kept.setOfScript(field, std::move(*value));
    } else {
        wrong = context_->kept.setOfObject(idOf(0), field, std::move(*value));
    }
    if (context_->kept.full()) {
        sandbox_.raiseLimit(L, wrong);
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
    sandbox_.checkArguments(L, "frame.random");
    lua_pushnumber(L, context_ == nullptr ? 0 : context_->kept.random());
    return 1;
}

} // namespace trembler::lua
