// The functions by which a compiled turn makes calls, as text in Lua.
#include "lua/component/driver_calls.hpp"

#include <fmt/format.h>

namespace trembler::lua {

std::string quotedName(std::string_view name) {
    std::string made = "\"";
    for (char const c : name) { // in decimal, so that no name is taken for code
        made += fmt::format("\\{:03}", static_cast<unsigned char>(c));
    }
    return made + "\"";
}

std::string driverCallText(std::size_t number, CallDescription const& call, CallPlan const& plan) {
    std::string parameters;
    std::string stated;    // moves the arguments with vectors as two numbers to v1, v2, ...
    std::string asVectors; // moves the arguments with vectors as tables
    std::string test;
    std::string write;
    bool hasVector = false;
    std::string firstVector;
    std::size_t values = 0;
    std::size_t position = 0;
    for (PlainArgument const& argument : plan.arguments) {
        ++position;
        auto const ranges = [&](std::string const& value) {
            test += fmt::format(" and type({0})=='number' and {0}{1}{2:.17g} and {0}<={3:.17g}", value,
                                argument.minimumExcluded ? ">" : ">=", argument.minimum, argument.maximum);
        };
        std::string const value = fmt::format("v{}", ++values);
        if (argument.kind == FieldKind::vector) {
            std::string const second = fmt::format("v{}", ++values);
            if (!hasVector) {
                firstVector = fmt::format("a{}", position);
            }
            hasVector = true;
            asVectors += fmt::format(" if type(a{0})~='table' then return slow(...) end "
                                     "{1},{2}=rawget(a{0},keyX),rawget(a{0},keyY)",
                                     position, value, second);
            ranges(value);
            ranges(second);
            write +=
                fmt::format(" local p=cast(doubles,at+{}) p[0]={} p[1]={}", argument.offset, value, second);
            continue;
        }
        asVectors += fmt::format(" {}=a{}", value, position);
        if (argument.kind == FieldKind::object) {
            test += fmt::format(" and {0}~=nil and ({0}==object1 or {0}==object2)", value);
            write += fmt::format(
                " cast(ids,at+{0})[0]=cast(constIds,pointers[{1}==object1 and 0 or 1])[current[0]]",
                argument.offset, value);
        } else if (argument.kind == FieldKind::number) {
            ranges(value);
            write += fmt::format(" cast(doubles,at+{})[0]={}", argument.offset, value);
        } else {
            test += fmt::format(" and type({})=='boolean'", value);
            write += fmt::format(" cast(bools,at+{})[0]={}", argument.offset, value);
        }
    }
    std::string names;
    std::string expanded;
    for (std::size_t i = 1; i <= values; ++i) {
        names += fmt::format("{}v{}", i == 1 ? "" : ",", i);
        expanded += fmt::format("{}a{}", i == 1 ? "" : ",", i);
    }
    for (std::size_t i = 1; i <= values + 1; ++i) {
        parameters += fmt::format("{}a{}", i == 1 ? "" : ",", i);
    }
    parameters += ",..."; // of which there must be none
    // No argument may follow the last one that the call takes: their places must hold nil.
    std::string following;
    for (std::size_t i = position + 1; i <= values + 1; ++i) {
        following += fmt::format("{}a{}~=nil", following.empty() ? "" : " or ", i);
    }
    std::string const afterVectors = fmt::format(" if {} then return slow({}) end", following, parameters);
    std::string text = fmt::format("do local slow=slow[{0}] local b=calls[{0}]\nfunctions[{1}]=function({2})"
                                   " if select('#',...)~=0 then return slow({2}) end local {3}",
                                   number, quotedName(call.text.name), parameters, names);
    auto const replaced = [&](std::string code) {
        for (auto at = code.find("slow(...)"); at != std::string::npos; at = code.find("slow(...)", at)) {
            code.replace(at, 9, "slow(" + parameters + ")");
        }
        return code;
    };
    if (hasVector) {
        text += fmt::format(
            " if type({0})=='number' then if a{1}~=nil then return slow({2}) end {3}={4} else{5}{6} end",
            firstVector, values + 1, parameters, names, expanded, afterVectors, replaced(asVectors));
    } else {
        text += afterVectors + asVectors;
    }
    std::string const gather =
        fmt::format(" local used=b.used if used<b.room and budget.made<budget.most{0} then"
                    " local at=b.bytes+used*{1}{2} b.used=used+1 budget.made=budget.made+1 return end",
                    test, call.size, write);
    text += fmt::format("{} return slow({}) end\n", gather, parameters);
    if (hasVector) {
        text += fmt::format("local slow=slowNumbers[{0}] numbers[{1}]=function({2},...)"
                            " if select('#',...)~=0 then return slow({2},...) end{3} return slow({2}) end\n",
                            number, quotedName(call.text.name), names, gather);
    }
    return text + "end\n";
}

} // namespace trembler::lua
