// The functions of the host that Lua calls: the arguments of the prelude, and the functions by which the
// sandbox runs a script in protected mode.
#pragma once

#include "lua/sandbox/sandbox.hpp"

#include <lua.hpp>
#include <string>

namespace trembler::lua {

// None of these holds an object with a destructor while it calls a function that may raise an error, except
// short strings, which Lua's errors unwind on the platforms that it is built for.
struct Sandbox::Functions {
    // The fields of the table `host`, the argument of the prelude.
    static luaL_Reg const all[];
    static int charge(lua_State* L);
    static int show(lua_State* L);
    static int suggest(lua_State* L);
    static int list(lua_State* L);
    static int kind(lua_State* L);
    static int text(lua_State* L);
    static int caught(lua_State* L);
    static int fail(lua_State* L);
    static int refuse(lua_State* L);
    static int refuseChange(lua_State* L);
    static int log(lua_State* L);
    static int limited(lua_State* L);
    static int limitText(lua_State* L);
    static int join(lua_State* L);
    static int plain(lua_State* L);
    static int keepGarbage(lua_State* L);
    static int sin(lua_State* L);
    static int cos(lua_State* L);
    static int atan2(lua_State* L);
    static int exp(lua_State* L);
    static int logE(lua_State* L);

    /// Raises the error of the limit; called where a counter in a text is below zero.
    static int over(lua_State* L);
    /// Calls the Body to which its argument, a light userdata, points.
    static int body(lua_State* L);
    /// The message handler: keeps the message and the traceback in the sandbox.
    static int handler(lua_State* L);

private:
    /// The text of a string or a number, at most as long as scripts may make one.
    static std::string part(lua_State* L, int index);
};

} // namespace trembler::lua
