#include "tests/lua/sandbox/whole/text_attacks.hpp"

#include <array>

namespace trembler::lua {
namespace {

constexpr std::array attacks{
    // Coordinates of vectors that are no numbers.
    TextAttack{"a table as a coordinate",
               "local v = vec2(1, 2) return try(function() v.x = {} end), tostring(v)"},
    TextAttack{"a function as a coordinate",
               "local v = vec2(1, 2) return try(function() v.y = function() end end), tostring(v)"},
    TextAttack{"a function of C as a coordinate",
               "local v = vec2(1, 2) return try(function() v.x = math.abs end), tostring(v)"},
    TextAttack{"a coroutine as a coordinate",
               "local v = vec2(1, 2) return try(function() v.x = coroutine.create(print) end), tostring(v)"},
    TextAttack{"a vector as its own coordinate",
               "local v = vec2(1, 2) return try(function() v.x = v end), tostring(v)"},
    TextAttack{"a text as a coordinate",
               "local v = vec2(1, 2) return try(function() v.x = ('a'):rep(1000) end), tostring(v)"},
    TextAttack{"a truth as a coordinate",
               "local v = vec2(1, 2) return try(function() v.x = true end), tostring(v)"},
    TextAttack{"no coordinate",
               "local v = vec2(1, 2) return try(function() v.x = nil end), tostring(v), v.x, v.y"},
    TextAttack{
        "a coordinate by a computed key",
        "local v = vec2(1, 2) local k = ('xy'):sub(1, 1) return try(function() v[k] = {} end), tostring(v)"},
    TextAttack{"both coordinates in one assignment",
               "local v = vec2(1, 2) return try(function() v.x, v.y = {}, {} end), tostring(v)"},
    TextAttack{"a function statement in a vector",
               "local v = vec2(1, 2) return try(function() function v.x() end end), tostring(v)"},
    TextAttack{"a method statement in a vector",
               "local v = vec2(1, 2) return try(function() function v:y() end end), tostring(v)"},
    TextAttack{"a vector behind __newindex",
               "local v = vec2(1, 2) local t = setmetatable({}, { __newindex = v })\n"
               "return try(function() t.x = {} end), tostring(v), rawequal"},
    TextAttack{"a vector behind two of __newindex",
               "local v = vec2(1, 2)\n"
               "local t = setmetatable({}, { __newindex = setmetatable({}, { __newindex = v }) })\n"
               "return try(function() t.y = print end), tostring(v)"},
    TextAttack{"a vector behind __index",
               "local v = vec2(1, 2) local t = setmetatable({}, { __index = v })\n"
               "return try(function() v.x = {} end), tostring(t), tostring(t.x), tostring(t.length)"},
    TextAttack{"table.insert into a vector",
               "local v = vec2(1, 2) return try(table.insert, v, {}), tostring(v)"},
    TextAttack{"table.insert at x", "local v = vec2(1, 2) return try(table.insert, v, 'x', {}), tostring(v)"},
    TextAttack{"table.sort of a vector", "local v = vec2(1, 2) return try(table.sort, v), tostring(v)"},
    TextAttack{"another metatable for a vector",
               "local v = vec2(1, 2) return try(setmetatable, v, { __index = print }), tostring(v)"},
    TextAttack{"a loop over a vector",
               "local s = {} local v = vec2(1, 2) for k, x in pairs(v) do s[k] = tostring(x) end\n"
               "return s, next(v), next(v, 'x')"},
    // Vectors that none are.
    TextAttack{"a metatable like that of a vector",
               "return tostring(setmetatable({ x = {}, y = print }, { __metatable = false }))"},
    TextAttack{"what getmetatable says of a vector",
               "local m = getmetatable(vec2(1, 2)) return tostring(m), tostring(setmetatable({ x = {}, y = "
               "{} }, { __metatable = m }))"},
    TextAttack{"what getmetatable says of a library",
               "local m = getmetatable(math) return tostring(m), tostring(setmetatable({ x = {} }, { "
               "__metatable = m }))"},
    TextAttack{"sums with a false vector",
               "local w = setmetatable({ x = {}, y = {} }, { __metatable = false }) local v = vec2(1, 2)\n"
               "return try(function() return v + w end), try(function() return w - v end), try(v.dot, v, w)"},
    TextAttack{"methods on a table",
               "local v = vec2(1, 2) local t = { x = {}, y = print }\n"
               "return try(v.length, t), try(v.unit, t), try(v.turned, t, 1), try(v.cross, t, t)"},
    TextAttack{"the metatable of a vector by its method",
               "local v = vec2(1, 2) return tostring(v.length), tostring(v.unit), try(function() return "
               "v.__index end)"},
    TextAttack{"a vector of tables", "return try(vec2, {}, {}), try(vec2, print, 1), try(vec2, '1', '2')"},
    TextAttack{"a vector of what is not finite",
               "return tostring(vec2(0 / 0, 1 / 0)), tostring(vec2(-1 / 0, -0.0))"},
    TextAttack{
        "a key of a vector that has an address",
        "local v = vec2(1, 2) return try(function() return v[{}] end), try(function() v[print] = 1 end),\n"
        "try(function() return v[coroutine.create(print)] end)"},
    // Texts that grow.
    TextAttack{"a vector that holds its own text", "local v = vec2(1, 2) for i = 1, 12 do pcall(function() "
                                                   "v.x = tostring(v) end) end return tostring(v)"},
    TextAttack{"a vector that holds its own form",
               "local v = vec2(1, 2) for i = 1, 9 do pcall(function() v.y = string.format('%s%s', v, v) end) "
               "end return tostring(v)"},
    TextAttack{"a text that doubles",
               "local s = ('a'):rep(600) local ok, e = pcall(function() s = s .. s end) return s, e"},
    TextAttack{"a text of many parts",
               "local s = ('a'):rep(400) return try(function() return s .. s .. s end)"},
    TextAttack{"an error that grows", "local m = ('a'):rep(900) for i = 1, 20 do local ok, e = "
                                      "pcall(function() error(m) end) m = e end return m"},
    TextAttack{"an error with the place of a caller",
               "local m = ('a'):rep(990) for i = 1, 20 do local ok, e = pcall(function() error(m, 2) end) m "
               "= e end return m"},
    TextAttack{"an assertion that grows", "local m = ('a'):rep(990) for i = 1, 20 do local ok, e = "
                                          "pcall(function() assert(false, m) end) m = e end return m"},
    TextAttack{"an error that a handler doubles",
               "return xtry(function() error(('a'):rep(990)) end, function(e) return e .. e end)"},
    TextAttack{"an error that a handler keeps", "local kept xpcall(function() error(('a'):rep(1000)) end, "
                                                "function(e) kept = e return e end) return kept"},
    TextAttack{
        "an error of a coroutine that grows",
        "local m = ('a'):rep(990) for i = 1, 9 do local c = coroutine.create(function() error(m) end)\n"
        "local ok, e = coroutine.resume(c) m = e end return m"},
    TextAttack{"an error through coroutine.wrap",
               "local m = ('a'):rep(990) for i = 1, 9 do local f = coroutine.wrap(function() error(m) end)\n"
               "local ok, e = pcall(f) m = e end return m"},
    TextAttack{"the name of a local variable in an error",
               "local NAME return try(function() return NAME.x end)"},
    TextAttack{"the name of a field in an error", "local t = {} return try(function() return t.NAME.x end)"},
    TextAttack{"the name of a method in an error", "local t = {} return try(function() return t:NAME() end)"},
    TextAttack{"the name of a global in an error", "return try(function() return NAME end)"},
    TextAttack{"the name of a new global in an error", "return try(function() NAME = 1 end)"},
    TextAttack{"the name of a field of a library in an error",
               "return try(function() return math.NAME end), try(function() math.NAME = 1 end)"},
    TextAttack{
        "the name of a coordinate in an error",
        "local v = vec2(1, 2) return try(function() return v.NAME end), try(function() v.NAME = 1 end)"},
    TextAttack{"rep", "return try(string.rep, 'a', 1001), try(string.rep, 'ab', 501), try(string.rep, '', "
                      "1e9), ('a'):rep(1000)"},
    TextAttack{"rep of a part of a time",
               "return try(string.rep, ('a'):rep(1000), 1.9), try(string.rep, 'a', 0 / 0)"},
    TextAttack{"a form of many texts",
               "return try(string.format, ('%s'):rep(200), unpack((function() local t = {} for i = 1, 199 do "
               "t[i] = ('a'):rep(900) end t[200] = 'b' return t end)()))"},
    TextAttack{"a form of wide texts", "return try(string.format, ('%99s'):rep(30), unpack((function() local "
                                       "t = {} for i = 1, 30 do t[i] = i end return t end)()))"},
    TextAttack{"a form of great width", "return try(string.format, '%99999d', 1), try(string.format, "
                                        "'%.99999f', 1), try(string.format, '%100s', 1)"},
    TextAttack{"a form of great precision",
               "return try(string.format, '%.99f', 1.7e308), string.format('%.99e', 1 / 3)"},
    TextAttack{"joining a list",
               "local t = {} for i = 1, 9 do t[i] = ('a'):rep(300) end return try(table.concat, t)"},
    TextAttack{
        "joining with long parts between",
        "return try(table.concat, { 1, 2, 3 }, ('a'):rep(600)), table.concat({ 1, 2 }, ('a'):rep(900))"},
    TextAttack{"joining a list that changes while it is read",
               "local n = 0 local t = setmetatable({ 'a', nil, 'c' }, { __index = function(_, k) n = n + 1 "
               "return n % 2 == 1 and 'b' or print end })\n"
               "return try(table.concat, t), try(table.concat, t, ',')"},
    TextAttack{"joining bytes", "local t = {} for i = 1, 30 do t[i] = string.char(97, 98, 99, 100, 101, 102, "
                                "103, 104, 105, 106):rep(10) end return try(table.concat, t)"},
    TextAttack{"turning round, and capital letters",
               "return (('a'):rep(1000)):upper(), (('ab'):rep(500)):reverse(), (('A'):rep(1000)):lower()"},
    TextAttack{"cutting out",
               "local s = ('a'):rep(1000) return s:sub(1, 2000), s:sub(-5000), try(s.sub, s, {}, print)"},
    TextAttack{"a log line without end", "log(('a'):rep(1000), ('b'):rep(1000)) log(unpack((function() local "
                                         "t = {} for i = 1, 150 do t[i] = 'abcdefgh' end return t end)()))"},
    // Texts that arithmetic takes for long numbers.
    TextAttack{"an error that is a number",
               "return try(error, 1.7e308), try(error, 1.7e308, 1), try(error, -1.2345678e-300, 2)"},
    TextAttack{"an assertion of a number", "return try(assert, false, 1.7e308)"},
    TextAttack{"an error that is a number, in a coroutine",
               "return resume(coroutine.create(function() error(1.7e308) end)), "
               "resume(coroutine.create(error), 1.7e308)"},
    TextAttack{"an error that is a number, to a handler",
               "local kept xpcall(error, function(e) kept = e end, 1.7e308) return kept"},
    TextAttack{
        "a number as a text",
        "return tostring(1.7e308), 1.7e308 .. '', string.format('%s', 1e300), string.format('%.99f', 1e10)"},
    TextAttack{"a number of joined parts", "return table.concat({ 1.7e308 }), table.concat({ '1', 'e300' }), "
                                           "'1' .. 'e' .. 300, ('003e1'):reverse()"},
    TextAttack{"a number of bytes",
               "return string.char(49, 101, 51, 48, 48), ('1E300'):lower(), ('x1e300'):sub(2)"},
    // Values with an address where a text is made.
    TextAttack{"tostring of everything",
               "return tostring({}), tostring(print), tostring(math.abs), tostring(coroutine.create(print)), "
               "tostring(math), tostring(string),\n"
               "tostring(coroutine), tostring(table), tostring(pairs({})), tostring(ipairs({})), "
               "tostring(coroutine.wrap(print))"},
    TextAttack{"log of everything", "log({}, print, math.sin, coroutine.create(print), math, vec2(1, 2), "
                                    "nil, true) print(string, table, pairs({}))"},
    TextAttack{"__tostring", "return tostring(setmetatable({}, { __tostring = function() return print end "
                             "})), tostring(setmetatable({}, { __tostring = print }))"},
    TextAttack{"__name", "local t = setmetatable({}, { __name = ('a'):rep(1000) }) return tostring(t), "
                         "try(math.sin, t), try(function() return t + 1 end)"},
    TextAttack{"%s of everything", "return string.format('%s %s %s %s', {}, print, math.abs, "
                                   "coroutine.create(print)), ('%s'):format(math)"},
    TextAttack{"%s with a width",
               "return string.format('%5.3s|%-30s|%.2s', {}, print, coroutine.create(print))"},
    TextAttack{"%s with __tostring", "return string.format('%s', setmetatable({}, { __tostring = function() "
                                     "return ('a'):rep(1000) end }))"},
    TextAttack{"%d of a table", "return try(string.format, '%d', {}), try(string.format, '%x', print), "
                                "try(string.format, '%f', coroutine.create(print))"},
    TextAttack{"letters for addresses",
               "return try(string.format, '%p', {}), try(string.format, '%q', print), try(string.format, "
               "'%c', 1), try(string.format, '%a', 1), try(string.format, '%u', 1)"},
    TextAttack{
        "a form for which values are missing",
        "return try(string.format, '%s %s', 1), try(string.format, '%d'), try(string.format, '%s', 1, {})"},
    TextAttack{"whole numbers beyond the machine's",
               "return try(string.format, '%d', 1e300), try(string.format, '%x', -1e300), try(string.format, "
               "'%d', 0 / 0), string.format('%x', -1), string.format('%d', 3.9)"},
    TextAttack{"joining a value to a text",
               "return try(function() return 'a' .. {} end), try(function() return print .. 'a' end), "
               "try(function() return nil .. 'a' end),\n"
               "try(function() return 'a' .. coroutine.create(print) end), try(function() return vec2(1, 2) "
               ".. math end)"},
    TextAttack{"__concat that is set later",
               "local m = {} local t = setmetatable({}, m) local seen m.__concat = function(a, b) seen = "
               "tostring(a) return b end\n"
               "local ok, got = pcall(function() return t .. 'a' end) return ok, tostring(got), seen, "
               "try(function() return got .. got end)"},
    TextAttack{"joining a list of values",
               "return try(table.concat, { {} }), try(table.concat, { 1, print }), try(table.concat, { "
               "coroutine.create(print) }), try(table.concat, { vec2(1, 2) })"},
    TextAttack{"a value between the parts", "return try(table.concat, { 1, 2 }, {}), try(table.concat, { 1, "
                                            "2 }, print), try(table.concat, print)"},
    // Errors and their objects.
    TextAttack{"errors that are no texts",
               "return try(error, {}), try(error, print), try(error, coroutine.create(print)), try(error, "
               "vec2(1, 2)), try(error), try(error, true)"},
    TextAttack{"an error that is a table, uncaught", "error({ 'a' })"},
    TextAttack{"an error that is a function, uncaught", "error(print)"},
    TextAttack{"an error that is a coroutine, uncaught", "error(coroutine.create(print))"},
    TextAttack{"an error that is a vector, uncaught", "error(vec2(1, 2))"},
    TextAttack{"an error with __tostring, uncaught",
               "error(setmetatable({}, { __tostring = function() return tostring(print) end }))"},
    TextAttack{"an assertion of a table, uncaught", "assert(nil, {})"},
    TextAttack{"an assertion of a function",
               "return try(assert, false, print), try(assert), try(assert, nil), try(assert, false, {})"},
    TextAttack{"a traceback",
               "local function f(n) if n == 0 then error('deep') end return 1 + f(n - 1) end f(6)"},
    TextAttack{"a traceback through the host's functions",
               "local function worse(a, b) error('sorting') end\n"
               "local function all() table.sort({ 3, 2, 1 }, worse) end\n"
               "local function more() local s = pcall(print) all() return s end\nmore() return 1"},
    TextAttack{
        "a traceback through pcall and a coroutine",
        "local f = coroutine.wrap(function() error('inside') end)\nlocal function g() f() return 1 end\n"
        "local ok, e = pcall(g) error(e, 0)"},
    TextAttack{"a traceback through metamethods",
               "local t = setmetatable({}, { __index = function(t, k) error('no ' .. k) end, __add = "
               "function(a) return a.x end })\nreturn t + 1"},
    TextAttack{"a traceback of a long error", "error(('a'):rep(1000))"},
    TextAttack{
        "an error in a handler",
        "return xtry(function() error('a') end, function() error('b') end), xtry(print, function() end)"},
    TextAttack{"handlers of the host",
               "return xtry(error, tostring, {}), xtry(error, print, print), xtry(error, error, math)"},
    TextAttack{
        "errors in errors",
        "return try(pcall, error, {}), try(pcall), try(error, try(error, {})), select(2, try(error, print))"},
    TextAttack{"levels of errors",
               "return try(error, 'a', 0), try(error, 'a', 1), try(error, 'a', 2), try(error, 'a', 50), "
               "try(error, 'a', -3), try(error, 'a', 1e9), try(error, 'a', {})"},
    // Messages of Lua itself.
    TextAttack{"arithmetic", "local t, f, c = {}, print, coroutine.create(print)\n"
                             "return try(function() return t + 1 end), try(function() return -f end), "
                             "try(function() return c * 2 end), try(function() return t % f end)"},
    TextAttack{"comparisons", "return try(function() return {} < {} end), try(function() return print < "
                              "print end), try(function() return 'a' < 1 end), try(function() return math <= "
                              "{} end), try(function() return vec2(1, 2) < vec2(3, 4) end)"},
    TextAttack{"calls", "local t, c = {}, coroutine.create(print) return try(function() t() end), "
                        "try(function() c() end), try(function() (nil)() end), try(t), try(c), try(5)"},
    TextAttack{"indices", "return try(function() return print.x end), try(function() local n n.x = 1 end), "
                          "try(function() local t = {} t[nil] = 1 end), try(function() local t = {} t[0 / 0] "
                          "= 1 end), try(function() return ('a').x end)"},
    TextAttack{"lengths", "return try(function() return #print end), try(function() return "
                          "#coroutine.create(print) end), try(function() return #5 end)"},
    TextAttack{"loops",
               "return try(function() for i = {}, 2 do end end), try(function() for i = 1, print do end "
               "end), try(function() for k in {} do end end), try(function() for k in nil do end end)"},
    TextAttack{"keys that are objects", "local t = { [{}] = 1, [print] = 2 } return try(pairs, t), try(next, "
                                        "t), try(next, {}, {}), try(next, { 1 }, print)"},
    TextAttack{"how many keys are found before one that has no order",
               "local t, n = { [{}] = 1 }, 0 for i = 1, 60 do t['k' .. i] = i end\n"
               "for i = 1, 30 do if not pcall(pairs, t) then n = n + 1 end end return tostring(n)"},
    TextAttack{"keys of libraries that are objects",
               "return try(function() return math[{}] end), try(function() return string[print] end), "
               "try(function() math[{}] = 1 end), try(function() return ('a')[{}] end)"},
    TextAttack{"sorting what has no order",
               "return try(table.sort, { print, math.abs, {} }), try(table.sort, { 1, 'a' }), "
               "try(table.sort, { {}, {} }, function(a, b) return tostring(a) < tostring(b) end)"},
    TextAttack{"sorting by texts of objects",
               "local t = {} for i = 1, 8 do t[i] = i % 2 == 0 and {} or function() end end\n"
               "table.sort(t, function(a, b) return tostring(a) < tostring(b) end)\nlocal s = '' for i = 1, "
               "8 do s = s .. type(t[i]) .. ' ' end return s"},
    TextAttack{"arguments of the wrong kind",
               "return try(math.sin, {}), try(math.floor, print), try(string.len, {}), try(ipairs, print), "
               "try(unpack, coroutine.create(print)), try(select, {}, 1), try(tonumber, 'a', {}), "
               "try(setmetatable, print, {})"},
    TextAttack{"what select and unpack hand on",
               "return select(-1, {}, print), select('#', {}), try(select, 0, 1), try(unpack, { {} }, 1, "
               "300), tostring((unpack({ {} })))"},
    TextAttack{"what is absent", "return try(function() return _G end), try(function() return debug end), "
                                 "try(function() return rawget end), try(function() return jit end), "
                                 "try(function() return ffi end), try(function() return newproxy end)"},
    TextAttack{"coroutines", "local c = coroutine.create(function() coroutine.yield({}) end)\n"
                             "return coroutine.status(c), tostring(select(2, resume(c))), resume(c), "
                             "resume(c), coroutine.status(c), try(coroutine.resume, {}), "
                             "try(coroutine.status, print), try(coroutine.create, {})"},
    TextAttack{"recursion without end", "local function f(n) return 1 + f(n + 1) end return f(1)"},
    TextAttack{"recursion without end, caught", "local n = 0 local function f() n = n + 1 return 1 + f() end "
                                                "local ok, e = pcall(f) return ok, e, tostring(n)"},
    TextAttack{"recursion without end in metamethods",
               "local t t = setmetatable({}, { __index = function(_, k) return 1 + t[k] end }) return t.x"},
    TextAttack{"recursion without end in a coroutine",
               "local function f() return 1 + f() end return resume(coroutine.create(f))"},
    TextAttack{"numbers at the edge",
               "return tostring(-0.0), tostring(0 / 0), tostring(-(0 / 0)), tostring(1 / 0), tostring(0.1), "
               "tostring(1e15), tostring(123456789012345678), tostring(1 / 3), string.format('%g %e %.3f', 0 "
               "/ 0, -1 / 0, -0.0)"},
    TextAttack{
        "a description of no table",
        "return try(interaction, 5), try(interaction, print), try(interaction, math), try(interaction)"},
};

} // namespace

std::span<TextAttack const> textAttacks() {
    return attacks;
}

} // namespace trembler::lua
