// Reading the arguments of a call from Lua, checked by the call's description.
#pragma once

#include "lua/sandbox/sandbox.hpp"
#include "runtime/component/role_info.hpp"
#include "runtime/world/store.hpp"

#include <array>
#include <functional>
#include <optional>

struct lua_State;

namespace trembler::lua {

/// A value of a call's C++ type, as bytes.
struct alignas(16) CallBytes {
    std::array<char, CallDescription::mostBytes> bytes; // not initialised: readArguments() fills them
};

/// The object that a Lua value stands for; nothing if it stands for none.
using ObjectAt = std::function<std::optional<ObjectId>(lua_State*, int index)>;

/// How the arguments of a call stand on the stack.
enum class ArgumentForm {
    /// One after the other in the order of the description, where a vector may be stated as two numbers, or
    /// by name in one table.
    stated,
    /// In order, with two values for each vector: the arguments that the script gives to vec2()
    /// (spreadVectors()).
    numbers,
};

/// Reads the whole stack as the arguments of a call. Nils at the end are ignored. Raises a Lua error, in
/// words, if an argument is missing, has another type, is not finite or out of range, or is an object that no
/// longer exists.
void readArguments(lua_State* L, Sandbox& sandbox, Store const& store, CallDescription const& call,
                   ObjectAt const& objectAt, CallBytes& into, ArgumentForm form = ArgumentForm::stated);

/// Whether an argument that is an object may be the world. Everywhere else the world is refused.
[[nodiscard]] bool takesWorld(CallDescription const& call, FieldPlace const& argument);

/// "addForce(object, force: N)", for people.
[[nodiscard]] std::string signatureOf(CallDescription const& call);

} // namespace trembler::lua
