#include "lua/sandbox/sandbox.hpp"

#include "lua/sandbox/exact_math.hpp"
#include "lua/sandbox/number_text.hpp"
#include "lua/sandbox/prelude.hpp"
#include "lua/sandbox/source_check.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <lua.hpp>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

namespace trembler::lua {
namespace {

// Comparing a word with all known ones, and raising an error, take as long as so many instructions.
constexpr double chargePerSuggestion = 3000;
constexpr double chargePerError = 400;
constexpr double unlimited = 1e300;
constexpr std::size_t trustedMemory = 4; // times as much

CountedSource const& countedPrelude() {
    static CountedSource const prelude = [] {
        std::optional<BlockFault> fault;
        return countSource(preludeText(), fault, true);
    }();
    return prelude;
}

std::string textAt(lua_State* L, int index) {
    std::size_t size = 0;
    char const* const text = lua_type(L, index) == LUA_TSTRING ? lua_tolstring(L, index, &size) : nullptr;
    return text == nullptr ? std::string() : std::string(text, size);
}

double angleAt(lua_State* L) {
    double const angle = luaL_checknumber(L, 1);
    if (!(std::abs(angle) <= largestAngle)) {
        Sandbox::of(L).raise(L, fmt::format("an angle of {} rad; expected at most {}", angle, largestAngle));
    }
    return angle;
}

void push(lua_State* L, std::string_view text) {
    lua_pushlstring(L, text.data(), text.size());
}

} // namespace

std::vector<std::string> stringKeys(lua_State* L, int index) {
    std::vector<std::string> keys;
    int const table = index < 0 ? lua_gettop(L) + 1 + index : index;
    lua_pushnil(L);
    while (lua_next(L, table) != 0) {
        if (lua_type(L, -2) == LUA_TSTRING) {
            keys.push_back(textAt(L, -2));
        }
        lua_pop(L, 1);
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

std::string kindOf(lua_State* L, int index) {
    switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
        return "nil";
    case LUA_TTABLE: {
        int const table = index < 0 ? lua_gettop(L) + 1 + index : index;
        bool vector = false;
        if (lua_getmetatable(L, table) != 0) {
            Sandbox::of(L).pushVectorMeta(L);
            vector = lua_rawequal(L, -1, -2) != 0;
            lua_pop(L, 2);
        }
        return vector ? "vector" : "table";
    }
    case LUA_TUSERDATA:
        return "object";
    default:
        return lua_typename(L, lua_type(L, index));
    }
}

// What the prelude is given. None of these has an object with a destructor on its stack when it calls what
// may raise an error, but for short strings, which Lua's errors unwind on the platforms that it is built for.
struct Sandbox::Functions {
    static int charge(lua_State* L) {
        of(L).charge(L, luaL_checknumber(L, 1));
        return 0;
    }
    static int show(lua_State* L) {
        std::string shown = textAt(L, 1);
        if (lua_type(L, 1) == LUA_TNUMBER) {
            shown = fmt::format("[{}]", lua_tonumber(L, 1));
        } else if (lua_type(L, 1) != LUA_TSTRING) {
            shown = fmt::format("[{}]", kindOf(L, 1));
        }
        shown.resize(std::min<std::size_t>(shown.size(), 60));
        push(L, shown);
        return 1;
    }
    static int suggest(lua_State* L) {
        std::string const word = textAt(L, 1);
        of(L).charge(L, chargePerSuggestion);
        std::vector<std::string> const known = stringKeys(L, 2);
        push(L, word.empty() || word.size() > 60 ? std::string() : didYouMean(word, known));
        return 1;
    }
    static int list(lua_State* L) {
        of(L).charge(L, chargePerSuggestion);
        std::string all;
        for (std::string const& key : stringKeys(L, 1)) {
            all += ", " + key;
        }
        push(L, all);
        return 1;
    }
    static int kind(lua_State* L) {
        push(L, kindOf(L, 1));
        return 1;
    }
    static int log(lua_State* L) {
        Sandbox& sandbox = of(L);
        std::string line = textAt(L, 1);
        line.resize(std::min(line.size(), longestLogLine));
        if (sandbox.logged_ < sandbox.limits_.logLines && sandbox.onLog) {
            ++sandbox.logged_;
            sandbox.onLog(line);
        }
        return 0;
    }
    static int limited(lua_State* L) {
        Sandbox const& sandbox = of(L);
        lua_pushboolean(L, !sandbox.stopped_.empty() || sandbox.memory_.exhausted() ? 1 : 0);
        return 1;
    }
    static int limitText(lua_State* L) {
        Sandbox const& sandbox = of(L);
        push(L, sandbox.stopped_.empty() ? std::string_view("not enough memory") : sandbox.stopped_);
        return 1;
    }
    /// The text of a string or a number, at most as long as scripts may make one.
    static std::string part(lua_State* L, int index) {
        if (lua_type(L, index) != LUA_TSTRING && lua_type(L, index) != LUA_TNUMBER) {
            of(L).raise(
                L, fmt::format("a {} cannot be joined to a text; tostring() makes it one", kindOf(L, index)));
        }
        lua_pushvalue(L, index); // which a number is converted in
        std::size_t size = 0;
        char const* const text = lua_tolstring(L, -1, &size);
        std::string copy(text, size);
        lua_pop(L, 1);
        return copy;
    }
    static int join(lua_State* L) {
        of(L).pushText(L, part(L, 1) + part(L, 2));
        return 1;
    }
    static int plain(lua_State* L) {
        of(L).pushText(L, part(L, 1));
        return 1;
    }
    static int keepGarbage(lua_State* L) {
        of(L).collectorStopped_ = true;
        lua_gc(L, LUA_GCSTOP, 0);
        return 0;
    }
    static int sin(lua_State* L) {
        lua_pushnumber(L, exactSin(angleAt(L)));
        return 1;
    }
    static int cos(lua_State* L) {
        lua_pushnumber(L, exactCos(angleAt(L)));
        return 1;
    }
    static int atan2(lua_State* L) {
        lua_pushnumber(L, exactAtan2(luaL_checknumber(L, 1), luaL_checknumber(L, 2)));
        return 1;
    }
    static int exp(lua_State* L) {
        lua_pushnumber(L, exactExp(luaL_checknumber(L, 1)));
        return 1;
    }
    static int logE(lua_State* L) {
        lua_pushnumber(L, exactLog(luaL_checknumber(L, 1)));
        return 1;
    }
    static constexpr luaL_Reg all[] = {
        {"charge", charge}, {"show", show}, {"suggest", suggest}, {"list", list},
        {"kind", kind},     {"log", log},   {"limited", limited}, {"limitText", limitText},
        {"sin", sin},       {"cos", cos},   {"atan2", atan2},     {"exp", exp},
        {"log_e", logE},    {"join", join}, {"plain", plain},     {"keepGarbage", keepGarbage},
        {nullptr, nullptr}};

    static int over(lua_State* L) {
        of(L).over(L);
        return 0;
    }
    static int body(lua_State* L) {
        auto const& body = *static_cast<Body const*>(lua_touserdata(L, 1));
        lua_settop(L, 0);
        body(L);
        return 0;
    }
    static int handler(lua_State* L) {
        Sandbox& sandbox = of(L);
        sandbox.memory_.setHost(true);
        sandbox.error_.message = lua_type(L, 1) == LUA_TSTRING ? textAt(L, 1)
                                 : lua_type(L, 1) == LUA_TNUMBER
                                     ? fmt::format("{}", lua_tonumber(L, 1))
                                     : fmt::format("the error is no text but a {}", kindOf(L, 1));
        constexpr std::size_t longest = 1000;
        sandbox.error_.message.resize(std::min(sandbox.error_.message.size(), longest));
        luaL_traceback(L, L, nullptr, 1);
        sandbox.error_.traceback = textAt(L, -1);
        sandbox.error_.traceback.resize(std::min(sandbox.error_.traceback.size(), 2 * longest));
        return 1;
    }
};

Sandbox::Sandbox(ScriptLimits const& limits, Trust trust) : limits_(limits), trust_(trust), memory_(this) {
    state_ = lua_newstate(Memory::allocate, &memory_);
    if (state_ == nullptr) {
        throw std::bad_alloc();
    }
    open();
}

Sandbox::~Sandbox() {
    lua_close(state_);
}

Sandbox& Sandbox::of(lua_State* L) {
    void* owner = nullptr; // what the allocator belongs to: found without touching the stack
    (void)lua_getallocf(L, &owner);
    return *static_cast<Sandbox*>(static_cast<Memory*>(owner)->owner());
}

void Sandbox::openLibraries(lua_State* L) {
    for (lua_CFunction const library : {luaopen_base, luaopen_string, luaopen_math, luaopen_table}) {
        lua_pushcfunction(L, library);
        lua_pushliteral(L, "");
        lua_call(L, 1, 0);
    }
    if (!trusted()) {
        luaJIT_setmode(L, 0, LUAJIT_MODE_ENGINE | LUAJIT_MODE_OFF);
        return;
    }
    lua_pushcfunction(L, luaopen_jit); // it is what finds out for which processor code is made
    lua_pushliteral(L, LUA_JITLIBNAME);
    lua_call(L, 1, 0);
    lua_pushnil(L);
    lua_setglobal(L, LUA_JITLIBNAME);
    lua_pushcfunction(L, luaopen_ffi);
    lua_pushliteral(L, LUA_FFILIBNAME);
    lua_call(L, 1, 1);
    ffi_ = luaL_ref(L, LUA_REGISTRYINDEX);
    luaJIT_setmode(L, 0, LUAJIT_MODE_ENGINE | LUAJIT_MODE_ON);
}

void Sandbox::open() {
    auto const failed = protect([this](lua_State* L) {
        openLibraries(L);
        lua_gc(L, LUA_GCSETPAUSE, 110); // or garbage is taken for memory that is needed
        compile(L, countedPrelude(), "=(prelude)");
        lua_pushvalue(L, -1);
        for (counterAt_ = 1;; ++counterAt_) {
            char const* const upvalue = lua_getupvalue(L, -1, counterAt_);
            if (upvalue == nullptr || upvalue == CountedSource::counterName) {
                break;
            }
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
        counted_ = luaL_ref(L, LUA_REGISTRYINDEX);
        setLeft(L, unlimited);
        lua_pushvalue(L, LUA_GLOBALSINDEX);
        lua_newtable(L);
        luaL_register(L, nullptr, Functions::all);
        push(L, joinerName);
        lua_setfield(L, -2, "joiner");
        lua_call(L, 2, 5);
        fill_ = luaL_ref(L, LUA_REGISTRYINDEX);
        vectorMeta_ = luaL_ref(L, LUA_REGISTRYINDEX);
        reset_ = luaL_ref(L, LUA_REGISTRYINDEX);
        surroundings_ = luaL_ref(L, LUA_REGISTRYINDEX);
        globals_ = luaL_ref(L, LUA_REGISTRYINDEX);
        lua_pushliteral(L, "x");
        vectorX_ = luaL_ref(L, LUA_REGISTRYINDEX);
        lua_pushliteral(L, "y");
        vectorY_ = luaL_ref(L, LUA_REGISTRYINDEX);
    });
    if (failed) {
        lua_close(state_);
        throw std::runtime_error("a Lua state could not be made: " + failed->message);
    }
    memory_.setCap(trusted() ? trustedMemory * limits_.memory : limits_.memory);
}

void Sandbox::compile(lua_State* L, CountedSource const& source, std::string const& name) {
    if (luaL_loadbuffer(L, source.text.data(), source.text.size(), name.c_str()) != 0) {
        lua_error(L);
    }
    lua_pushcfunction(L, Functions::over);
    lua_call(L, 1, 1);
}

double Sandbox::left(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, counted_);
    lua_getupvalue(L, -1, counterAt_);
    double const instructions = lua_tonumber(L, -1);
    lua_pop(L, 2);
    return instructions;
}
void Sandbox::setLeft(lua_State* L, double instructions) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, counted_);
    lua_pushnumber(L, instructions);
    lua_setupvalue(L, -2, counterAt_);
    lua_pop(L, 1);
}

std::optional<ScriptError> Sandbox::protect(Body const& body) {
    memory_.setHost(true);
    return run(body);
}

std::optional<ScriptError> Sandbox::turn(std::size_t objects, Body const& body) {
    memory_.beginTurn(trusted() ? static_cast<std::size_t>(-1)
                                : limits_.allocation + limits_.allocationPerObject * objects);
    budget_ = static_cast<double>(limits_.instructions + limits_.instructionsPerObject * objects);
    calls_ = {.made = 0,
              .most =
                  limits_.calls + static_cast<double>(limits_.callsPerObject) * static_cast<double>(objects)};
    spent_ = 0;
    creations_ = 0;
    logged_ = 0;
    counting_ = true;
    auto failed = protect([&](lua_State* L) {
        if (plainGlobals_ && !filled_) {
            lua_rawgeti(L, LUA_REGISTRYINDEX, fill_);
            lua_pushboolean(L, source_.assignsFields ? 0 : 1);
            lua_call(L, 1, 0);
            filled_ = true;
        }
        lua_rawgeti(L, LUA_REGISTRYINDEX, reset_);
        lua_call(L, 0, 0);
        setLeft(L, budget_);
        body(L);
    });
    counting_ = false;
    finishTurn(failed);
    return failed;
}

void Sandbox::finishTurn(std::optional<ScriptError>& failed) {
    if (collectorStopped_) {
        collectorStopped_ = false;
        lua_gc(state_, LUA_GCRESTART, 0);
        // What is left of the turn, so that the next one can have all of the memory. Nothing here has a
        // finaliser.
        lua_gc(state_, LUA_GCCOLLECT, 0);
    }
    if (stopped_.empty()) {
        spent_ = static_cast<std::uint64_t>(std::clamp(budget_ - left(state_), 0.0, budget_));
    }
    setLeft(state_, unlimited);         // neither needs memory beyond the stack that every state has
    if (!failed && !stopped_.empty()) { // its error was dropped
        failed = ScriptError{stopped_, {}, true};
    }
    if (!failed && memory_.exhausted()) {
        failed = ScriptError{"not enough memory", {}, true};
    }
    if (failed && (!stopped_.empty() || memory_.exhausted())) {
        failed->limit = true;
        if (!stopped_.empty() && failed->message.find(stopped_) == std::string::npos) {
            failed->message = stopped_; // the script has put something else in its place
        } else if (stopped_.empty()) {
            failed->message =
                fmt::format("the script needs more memory than its limits, {} bytes at a time and "
                            "{} in a turn, or calls itself too deeply",
                            limits_.memory, limits_.allocation);
        }
    }
    stopped_.clear();
    memory_.beginTurn(static_cast<std::size_t>(-1));
}

std::optional<ScriptError> Sandbox::run(Body const& body) {
    error_ = {};
    lua_State* const L = state_;
    int const top = lua_gettop(L);
    // Pushing these needs no memory beyond the stack that every state has.
    lua_pushcfunction(L, Functions::handler);
    lua_pushcfunction(L, Functions::body);
    lua_pushlightuserdata(L, const_cast<Body*>(&body)); // NOLINT: it is called as const
    int const status = lua_pcall(L, 1, 0, top + 1);
    memory_.setHost(true);
    std::optional<ScriptError> failed;
    if (status != 0) {
        failed = std::move(error_);
        if (failed->message.empty()) {
            failed->message = status == LUA_ERRMEM ? "not enough memory" : textAt(L, -1);
        }
    }
    lua_settop(L, top);
    return failed;
}

std::optional<ScriptError> Sandbox::load(std::string_view text, std::string const& name) {
    if (auto const fault = faultInSource(text)) {
        std::string const place = fault->line == 0 ? name : fmt::format("{}:{}", name, fault->line);
        return ScriptError{fmt::format("{}: {}", place, fault->message), {}, false};
    }
    std::optional<BlockFault> fault;
    source_ = countSource(withCountedJoins(text), fault);
    // LuaJIT says it better: its message has what stands there. If it finds nothing wrong, the blocks are.
    return protect([&](lua_State* L) {
        if (fault) {
            if (luaL_loadbuffer(L, text.data(), text.size(), ("@" + name).c_str()) == 0) {
                lua_pushstring(L, fmt::format("{}:{}: {}", name, fault->line, fault->message).c_str());
            }
            lua_error(L);
        }
        compile(L, source_, "@" + name);
        bindCounter(L);
        chooseGlobals(L);
        lua_rawgeti(L, LUA_REGISTRYINDEX, globals_);
        lua_setfenv(L, -2);
        chunk_ = luaL_ref(L, LUA_REGISTRYINDEX);
    });
}

// The function on top of the stack counts down the same variable as the prelude.
void Sandbox::bindCounter(lua_State* L) const {
    for (int i = 1;; ++i) {
        char const* const upvalue = lua_getupvalue(L, -1, i);
        if (upvalue == nullptr) {
            return; // it has nothing to count
        }
        lua_pop(L, 1);
        if (upvalue == CountedSource::counterName) {
            lua_rawgeti(L, LUA_REGISTRYINDEX, counted_);
            lua_upvaluejoin(L, -2, i, -1, counterAt_);
            lua_pop(L, 1);
            return;
        }
    }
}

void Sandbox::chooseGlobals(lua_State* L) {
    plainGlobals_ = true;
    lua_rawgeti(L, LUA_REGISTRYINDEX, surroundings_);
    for (std::string const& name : source_.assigned) {
        lua_pushlstring(L, name.data(), name.size());
        lua_rawget(L, -2);
        // Those that are added later count as well.
        plainGlobals_ =
            plainGlobals_ && lua_isnil(L, -1) && name != "world" && name != "alive" && name != "same";
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

void Sandbox::pushChunk(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, chunk_);
}
void Sandbox::chargeText(lua_State* L, std::size_t applications) {
    charge(L, static_cast<double>(source_.chunk) +
                  static_cast<double>(source_.apply) * static_cast<double>(applications));
}
void Sandbox::rehearse(lua_State* L, int times) {
    double const before = left(L);
    auto const log = std::exchange(onLog, nullptr);
    for (int i = 0; i < times; ++i) {
        pushChunk(L);
        callScript(L, 0, 0);
        setLeft(L, before);
    }
    onLog = log;
}
void Sandbox::pushFfi(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, ffi_);
}
void Sandbox::pushSurroundings(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, surroundings_);
}
void Sandbox::pushVectorMeta(lua_State* L) const {
    lua_rawgeti(L, LUA_REGISTRYINDEX, vectorMeta_);
}
void Sandbox::pushVector(lua_State* L, double x, double y) const {
    lua_createtable(L, 0, 2);
    lua_rawgeti(L, LUA_REGISTRYINDEX, vectorX_);
    lua_pushnumber(L, x);
    lua_rawset(L, -3);
    lua_rawgeti(L, LUA_REGISTRYINDEX, vectorY_);
    lua_pushnumber(L, y);
    lua_rawset(L, -3);
    pushVectorMeta(L);
    lua_setmetatable(L, -2);
}

void Sandbox::pushText(lua_State* L, std::string_view text) {
    if (text.size() > longestString) {
        raise(L, fmt::format("a text of {} bytes; expected at most {}", text.size(), longestString));
    }
    charge(L, 5 + static_cast<double>(text.size()) / 8);
    if (readsAsLongNumber(text)) {
        push(L, fmt::format("({})", text));
    } else {
        push(L, text);
    }
}

std::optional<Vec2> Sandbox::vectorAt(lua_State* L, int index) const {
    if (lua_type(L, index) != LUA_TTABLE) {
        return std::nullopt;
    }
    lua_rawgeti(L, LUA_REGISTRYINDEX, vectorX_);
    lua_rawget(L, index);
    lua_rawgeti(L, LUA_REGISTRYINDEX, vectorY_);
    lua_rawget(L, index);
    bool const numbers = lua_type(L, -1) == LUA_TNUMBER && lua_type(L, -2) == LUA_TNUMBER;
    Vec2 const vector{lua_tonumber(L, -2), lua_tonumber(L, -1)};
    lua_pop(L, 2);
    return numbers ? std::optional(vector) : std::nullopt;
}

void Sandbox::callScript(lua_State* L, int arguments, int results) {
    memory_.setHost(trusted());
    lua_call(L, arguments, results);
    memory_.setHost(true);
}

void Sandbox::charge(lua_State* L, double instructions) {
    if (!counting_) {
        return;
    }
    double const cost = std::clamp(instructions, 0.0, 1e15);
    double const now = left(L);
    if (now < cost) { // what does not fit is not done
        setLeft(L, 0);
        over(L);
    }
    setLeft(L, now - cost);
}

void Sandbox::chargeCall(lua_State* L, bool creates) {
    if (!counting_) {
        return;
    }
    calls_.made += 1;
    if (calls_.made > calls_.most) {
        stop(L, fmt::format("the script makes more than its {} calls in a turn", calls_.most));
    }
    creations_ += creates ? 1 : 0;
    if (creations_ > limits_.creations) {
        stop(L, fmt::format("the script creates more than its {} objects in a turn", limits_.creations));
    }
}

void Sandbox::over(lua_State* L) {
    if (!stopped_.empty()) {
        stop(L, stopped_);
    }
    if (memory_.exhausted()) {
        stop(L, "not enough memory");
    }
    stop(L, fmt::format("the script takes more than its {} instructions in a turn", budget_));
}

// From here on every counter in the text raises the error again, so no pcall can hold it up.
void Sandbox::stop(lua_State* L, std::string const& message) {
    if (&message != &stopped_) {
        spent_ = static_cast<std::uint64_t>(std::clamp(budget_ - left(L), 0.0, budget_));
        stopped_ = placeOf(L) + message;
        setLeft(L, -1);
    }
    push(L, stopped_);
    lua_error(L);
    std::abort(); // lua_error() does not return
}

void Sandbox::raise(lua_State* L, std::string const& message) {
    charge(L, chargePerError);
    std::string const whole = placeOf(L) + message;
    push(L, whole);
    lua_error(L);
    std::abort(); // lua_error() does not return
}

std::string Sandbox::placeOf(lua_State* L) {
    for (int level = 0; level < 20; ++level) { // the first of the callers that is the script
        lua_Debug at{};
        if (lua_getstack(L, level, &at) == 0) {
            break;
        }
        lua_getinfo(L, "Sl", &at);
        if (at.currentline > 0 && at.source[0] == '@') {
            return fmt::format("{}:{}: ", at.short_src, at.currentline);
        }
    }
    return {};
}

} // namespace trembler::lua
