#include "lua/binding/call_arguments.hpp"

#include "lua/binding/values.hpp"
#include "lua/sandbox/stack_values.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <lua.hpp>
#include <string_view>
#include <utility>

namespace trembler::lua {
namespace {

// The world has the fields, and is none of the objects that simulations move, connect or destroy.
constexpr std::array<std::pair<std::string_view, std::string_view>, 1> argumentsOfTheWorld{
    {{"setLinearGravity", "field"}}};

constexpr double largestWhole = 9007199254740992.0; // 2^53: all whole numbers up to it are exact as doubles

class ArgumentReader {
public:
    ArgumentReader(lua_State* L, Sandbox& sandbox, Store const& store, CallDescription const& call,
                   ObjectAt const& objectAt, CallBytes& into)
        : L_(L), sandbox_(sandbox), store_(store), call_(call), objectAt_(objectAt), into_(into) {}

    /// Reads an argument at an index; returns how many values on the stack it has taken. `inOrder`: another
    /// argument may follow it.
    int read(FieldPlace const& place, int index, bool inOrder) {
        if (place.kind == FieldKind::vector && inOrder && lua_type(L_, index) == LUA_TNUMBER &&
            lua_type(L_, index + 1) == LUA_TNUMBER) {
            putVector(place, {lua_tonumber(L_, index), lua_tonumber(L_, index + 1)});
            return 2;
        }
        readOne(place, index);
        return 1;
    }

    /// Reads the two values that the script has given to vec2().
    int readNumbers(FieldPlace const& place, int index) {
        if (lua_type(L_, index) != LUA_TNUMBER || lua_type(L_, index + 1) != LUA_TNUMBER) {
            refuse(place,
                   fmt::format("is vec2 of {} and {}", kindInWords(L_, index), kindInWords(L_, index + 1)),
                   inItsUnit(place, "vec2(x, y) of two numbers"));
        }
        putVector(place, {lua_tonumber(L_, index), lua_tonumber(L_, index + 1)});
        return 2;
    }

    void readOne(FieldPlace const& place, int index) {
        switch (place.kind) {
        case FieldKind::boolean:
            if (lua_type(L_, index) != LUA_TBOOLEAN) {
                refuseType(place, index, "true or false");
            }
            put(place, lua_toboolean(L_, index) != 0);
            return;
        case FieldKind::number:
            put(place, number(place, index, place.info.minimum, place.info.maximum));
            return;
        case FieldKind::integer:
            put(place, static_cast<std::int32_t>(whole(place, index, -2147483648.0, 2147483647.0)));
            return;
        case FieldKind::whole:
            put(place, static_cast<std::uint64_t>(whole(place, index, 0, largestWhole)));
            return;
        case FieldKind::vector: {
            auto const vector = sandbox_.vectorAt(L_, index);
            if (!vector) {
                refuseType(place, index, "a vector, vec2(x, y)");
            }
            putVector(place, *vector);
            return;
        }
        case FieldKind::object: {
            auto const object = objectAt_(L_, index);
            if (!object) {
                refuseType(place, index, "an object");
            }
            if (!takesWorld(call_, place) &&
                (kindOf(L_, index) == "world" || *object == store_.find("world"))) {
                refuse(place, "is the world", "an object");
            }
            if (!store_.alive(*object)) {
                refuse(place, "is an object that is gone", "one that is there");
            }
            put(place, *object);
            return;
        }
        case FieldKind::choice:
            put(place, choice(place, index));
            return;
        case FieldKind::part:
            put(place, part(place, index));
            return;
        default: // a call is plain data
            refuse(place, "cannot be stated", "another call");
        }
    }

    [[noreturn]] void refuse(FieldPlace const& place, std::string const& what, std::string const& expected) {
        sandbox_.raise(L_, fmt::format("argument '{}' of {} {}; expected {}", place.info.key, call_.text.name,
                                       what, expected));
    }

private:
    template <class T>
    void put(FieldPlace const& place, T const& value) {
        std::memcpy(into_.bytes.data() + place.offset, &value, std::min(sizeof value, place.size));
    }
    void putVector(FieldPlace const& place, Vec2 vector) {
        for (double const coordinate : {vector.x, vector.y}) {
            checkRange(place, coordinate, place.info.minimum, place.info.maximum);
        }
        put(place, vector);
    }
    [[noreturn]] void refuseType(FieldPlace const& place, int index, std::string const& expected) {
        refuse(place, "is " + kindInWords(L_, index), inItsUnit(place, expected));
    }
    static std::string inItsUnit(FieldPlace const& place, std::string const& expected) {
        return place.info.unit.empty() ? expected : fmt::format("{}, in {}", expected, place.info.unit);
    }
    void checkRange(FieldPlace const& place, double value, double minimum, double maximum) {
        if (!std::isfinite(value)) {
            refuse(place, "is not finite", "a number");
        }
        if (value < minimum || value > maximum || (place.info.minimumExcluded && value == minimum)) {
            refuse(place,
                   fmt::format("is {:g}{}{}", value, place.info.unit.empty() ? "" : " ", place.info.unit),
                   fmt::format("{:g} to {:g}", minimum, maximum));
        }
    }
    double number(FieldPlace const& place, int index, double minimum, double maximum) {
        if (lua_type(L_, index) != LUA_TNUMBER) {
            refuseType(place, index, "a number");
        }
        double const value = lua_tonumber(L_, index);
        checkRange(place, value, minimum, maximum);
        return value;
    }
    double whole(FieldPlace const& place, int index, double least, double most) {
        double const value =
            number(place, index, std::max(place.info.minimum, least), std::min(place.info.maximum, most));
        if (value != std::floor(value)) {
            refuse(place, fmt::format("is {}", value), "a whole number");
        }
        return value;
    }
    int choice(FieldPlace const& place, int index) {
        std::vector<std::string> const known(place.choices.begin(), place.choices.end());
        std::string const name = textOf(place, index);
        for (std::size_t i = 0; i < known.size(); ++i) {
            if (known[i] == name) {
                return static_cast<int>(i);
            }
        }
        refuse(place, fmt::format("is '{}'{}", name, didYouMean(name, known)), listed(known));
    }
    std::uint32_t part(FieldPlace const& place, int index) {
        std::string const name = textOf(place, index);
        std::uint32_t const number = store_.prototypes().numberOf(name);
        if (number == PrototypeLibrary::unknown) {
            refuse(place, fmt::format("is '{}', and there is no such part", name), "the name of a part");
        }
        if (store_.prototypes().find(number)->composite) {
            refuse(place, fmt::format("is '{}', which consists of several objects", name),
                   "a part that is one object: others can be placed only before the run");
        }
        return number;
    }
    std::string textOf(FieldPlace const& place, int index) {
        if (lua_type(L_, index) != LUA_TSTRING || lua_objlen(L_, index) > longestText) {
            refuseType(place, index, "a name");
        }
        return lua_tostring(L_, index);
    }

    lua_State* L_;
    Sandbox& sandbox_;
    Store const& store_;
    CallDescription const& call_;
    ObjectAt const& objectAt_;
    CallBytes& into_;
};

/// Whether the table at an index has keys that are no texts.
bool hasOtherKeys(lua_State* L, int index) {
    bool other = false;
    lua_pushnil(L);
    while (lua_next(L, index) != 0) {
        other = other || lua_type(L, -2) != LUA_TSTRING;
        lua_pop(L, 1);
    }
    return other;
}

} // namespace

bool takesWorld(CallDescription const& call, FieldPlace const& argument) {
    return std::any_of(argumentsOfTheWorld.begin(), argumentsOfTheWorld.end(), [&](auto const& one) {
        return one.first == call.text.name && one.second == argument.info.key;
    });
}

void readArguments(lua_State* L, Sandbox& sandbox, Store const& store, CallDescription const& call,
                   ObjectAt const& objectAt, CallBytes& into, ArgumentForm form) {
    std::memcpy(into.bytes.data(), call.initial.data(), call.size);
    ArgumentReader reader(L, sandbox, store, call, objectAt, into);
    int count = lua_gettop(L);
    while (count > 0 && lua_isnil(L, count)) { // as if it were not stated
        --count;
    }
    auto const missing = [&](FieldPlace const& place) {
        if (place.info.required) {
            sandbox.raise(L, fmt::format("argument '{}' of {} is missing; expected {}", place.info.key,
                                         call.text.name, signatureOf(call)));
        }
    };
    bool const asNumbers = form == ArgumentForm::numbers;
    bool const named = !asNumbers && count == 1 && lua_type(L, 1) == LUA_TTABLE &&
                       call.arguments.size() > 1 && !objectAt(L, 1) && kindOf(L, 1) == "table";
    if (named) {
        if (hasOtherKeys(L, 1)) {
            sandbox.raise(
                L, fmt::format("{} is given a table with values that have no name; expected {}{{ {} = ... }}",
                               call.text.name, call.text.name, call.arguments.front().info.key));
        }
        std::vector<std::string> const keys = stringKeys(L, 1);
        constexpr double chargePerKey = 50; // a table may have very many keys
        sandbox.charge(L, chargePerKey * static_cast<double>(keys.size()));
        for (std::string const& key : keys) {
            std::vector<std::string> known;
            for (FieldPlace const& place : call.arguments) {
                known.emplace_back(place.info.key);
            }
            if (std::find(known.begin(), known.end(), key) == known.end()) {
                sandbox.raise(L, fmt::format("{} has no argument '{}'{}; expected {}", call.text.name, key,
                                             didYouMean(key, known), listed(known)));
            }
        }
        for (FieldPlace const& place : call.arguments) {
            lua_pushlstring(L, place.info.key.data(), place.info.key.size());
            lua_rawget(L, 1);
            if (lua_isnil(L, -1)) {
                missing(place);
            } else {
                reader.readOne(place, lua_gettop(L));
            }
            lua_pop(L, 1);
        }
        return;
    }
    int index = 1;
    for (FieldPlace const& place : call.arguments) {
        if (asNumbers && place.kind == FieldKind::vector) {
            index += reader.readNumbers(place, index);
        } else if (index > count || lua_isnil(L, index)) {
            missing(place);
            ++index;
        } else {
            index += reader.read(place, index, true);
        }
    }
    if (index <= count) {
        sandbox.raise(L, fmt::format("{} is given {} arguments; expected {}", call.text.name, count,
                                     signatureOf(call)));
    }
}

std::string signatureOf(CallDescription const& call) {
    std::string all;
    for (FieldPlace const& place : call.arguments) {
        all += fmt::format("{}{}{}{}", all.empty() ? "" : ", ", place.info.key,
                           place.info.unit.empty() ? "" : ": ", place.info.unit);
    }
    return fmt::format("{}({})", call.text.name, all);
}

} // namespace trembler::lua
