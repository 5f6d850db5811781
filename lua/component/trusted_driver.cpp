// The turns of trusted scripts: a loop in Lua that LuaJIT compiles together with the script's function. It
// reads the columns where they are and gathers calls where CallGatherer keeps them. It gives the script the
// same tables with the same values as applyToEach(), so the script's calls are the same, bit for bit.
#include "lua/component/driver_calls.hpp"
#include "lua/component/turn_binding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace trembler::lua {
namespace {

// A Lua function has room for 200 variables and 60 upvalues.
constexpr std::size_t mostDriven = 20;

std::string_view elementType(FieldKind kind) {
    return kind == FieldKind::boolean ? "bool" : kind == FieldKind::integer ? "int32_t" : "double";
}
std::size_t elementSize(FieldKind kind) {
    return kind == FieldKind::boolean   ? sizeof(bool)
           : kind == FieldKind::integer ? sizeof(std::int32_t)
                                        : sizeof(double);
}

} // namespace

bool Turns::Binding::canDrive() const {
    std::size_t driven = 0;
    for (Slot const& slot : slots_) {
        driven += slot.eager.size() + slot.shown.size();
        for (Eager const& eager : slot.eager) {
            std::size_t const size = elementSize(eager.place.kind);
            if (script_->reads[slot.shown[eager.shown].read].info->size % size != 0 ||
                eager.place.offset % size != 0) {
                return false;
            }
        }
    }
    return script_->manifest.application != Application::once && driven <= mostDriven;
}

std::string Turns::Binding::driverText() const {
    std::string text =
        "local t=... local ffi=t.ffi local cast=ffi.cast local type,rawget,rawset=t.type,t.rawget,t.rawset\n"
        "local select,keyX,keyY=t.select,t.keyX,t.keyY\n"
        "ffi.cdef[[typedef struct {char* bytes; int32_t used; int32_t room;} trembler_calls;"
        " typedef struct {double made; double most;} trembler_budget;]]\n"
        "local doubles,ids,bools=ffi.typeof'double*',ffi.typeof'uint64_t*',ffi.typeof'bool*'\n"
        "local constIds,rows=ffi.typeof'uint64_t const*',ffi.typeof'uint32_t const*'\n"
        "local bytes=ffi.typeof'char const*'\n"
        "local pointers=cast('void const* const*',t.pointers) local current=cast('int32_t*',t.current)\n"
        "local calls=cast('trembler_calls*',t.calls) local budget=cast('trembler_budget*',t.budget)\n"
        "local object1,object2,params,out,store,frame=t.object1,t.object2,t.params,t.out,t.store,t.frame\n"
        "local slow,functions,fill=t.slow,t.functions,t.fill\n"
        "local slowNumbers,numbers=t.slowNumbers,t.numbers\n";
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        if (plans_[i].plain && !plans_[i].creates && plans_[i].arguments.size() <= 6) {
            text += driverCallText(i, script_->role->calls[i], plans_[i]);
        }
    }
    std::string before; // text before the loop
    std::string inside;
    std::size_t pointer = 2;
    std::size_t shownNumber = 0;
    std::size_t eagerNumber = 0;
    for (Slot const& slot : slots_) {
        std::size_t const first = &slot == slots_.data() ? 1 : 2;
        for (std::size_t s = 0; s < slot.shown.size(); ++s) {
            Shown const& shown = slot.shown[s];
            std::size_t const n = ++shownNumber;
            std::size_t const data = pointer++;
            std::size_t const rows = pointer++;
            before += fmt::format("local r{0}=cast(rows,pointers[{1}])\n", n, rows);
            std::string reading;
            for (Eager const& eager : slot.eager) {
                if (eager.shown != s) {
                    continue;
                }
                std::size_t const e = ++eagerNumber;
                std::size_t const size = elementSize(eager.place.kind);
                std::size_t const stride = script_->reads[shown.read].info->size / size;
                text += fmt::format("local e{0}=t[{0}]\n", e);
                before += fmt::format("local c{0}=cast('{1} const*',cast(bytes,pointers[{2}])+{3})\n", e,
                                      elementType(eager.place.kind), data, eager.place.offset);
                if (eager.place.kind == FieldKind::vector) {
                    reading += fmt::format(" e{0}.x=c{0}[r*{1}] e{0}.y=c{0}[r*{1}+1]", e, stride);
                } else {
                    reading +=
                        fmt::format(" e{0}[{1}]=c{0}[r*{2}]", e, quotedName(eager.place.info.key), stride);
                }
            }
            if (shown.required) {
                inside += fmt::format("do local r=r{}[i]{} end\n", n, reading);
                continue;
            }
            std::string const name = quotedName(script_->reads[shown.read].name);
            text += fmt::format("local p{0},there{0}=t.proxies[{0}]\n", n);
            before += fmt::format("there{0}=rawget(t.fields{1},{2})~=nil\n", n, first, name);
            inside +=
                fmt::format("do local r=r{0}[i] if r=={1} then if there{0} then rawset(t.fields{2},{3},nil)"
                            " there{0}=false end else if not there{0} then rawset(t.fields{2},{3},p{0})"
                            " there{0}=true end{4} end end\n",
                            n, ColumnBase::absent, first, name, reading);
        }
    }
    bool const pairs = slots_[1].proxy != 0;
    std::array<std::string_view, 6> const all{"object1",
                                              pairs ? "object2" : "params",
                                              pairs ? "params" : "out",
                                              pairs ? "out" : "store",
                                              pairs ? "store" : "frame",
                                              pairs ? "frame" : ""};
    std::string arguments;
    for (std::size_t i = 0; i < std::min<std::size_t>(pairs ? 6 : 5, sandbox_.source().parameters); ++i) {
        arguments += fmt::format("{}{}", i == 0 ? "" : ",", all[i]);
    }
    if (script_->manifest.attached) {
        before += fmt::format("local fresh=cast('uint8_t const*',pointers[{}])\n", pointer);
        inside += "if fresh[i]~=0 then fill() end\n";
    }
    return text + "return function(count,apply)\n" + before + "for i=0,count-1 do\ncurrent[0]=i\n" + inside +
           "apply(" + arguments + ")\nend\nend\n";
}

void Turns::Binding::setUpDriver(lua_State* L) {
    std::string const text = driverText();
    if (luaL_loadbuffer(L, text.data(), text.size(), "=(driver)") != 0) {
        lua_error(L);
    }
    lua_newtable(L);
    sandbox_.pushFfi(L);
    lua_setfield(L, -2, "ffi");
    for (char const* const name : {"type", "rawget", "rawset", "select"}) {
        lua_getglobal(L, name);
        lua_setfield(L, -2, name);
    }
    std::size_t shownCount = 0;
    for (Slot const& slot : slots_) {
        shownCount += slot.shown.size();
    }
    pointers_.assign(3 + 2 * shownCount, nullptr);
    sandbox_.pushVectorKeyX(L);
    lua_setfield(L, -2, "keyX");
    sandbox_.pushVectorKeyY(L);
    lua_setfield(L, -2, "keyY");
    lua_pushlightuserdata(L, pointers_.data());
    lua_setfield(L, -2, "pointers");
    lua_pushlightuserdata(L, &at_);
    lua_setfield(L, -2, "current");
    lua_pushlightuserdata(L, gatherer_.pending());
    lua_setfield(L, -2, "calls");
    lua_pushlightuserdata(L, &sandbox_.calls());
    lua_setfield(L, -2, "budget");
    for (auto const& [name, reference] : {std::pair{"object1", slots_[0].proxy},
                                          {"object2", slots_[1].proxy},
                                          {"params", parameters_},
                                          {"out", out_},
                                          {"store", store_},
                                          {"frame", frame_},
                                          {"functions", outValues_},
                                          {"numbers", outNumbers_},
                                          {"fields1", slots_[0].fields},
                                          {"fields2", slots_[1].fields}}) {
        if (reference != 0) {
            get(L, reference);
            lua_setfield(L, -2, name);
        }
    }
    for (std::size_t const asNumbers : {0U, 1U}) { // the functions in C
        lua_newtable(L);
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            pushFunction<&Binding::makeCall>(L, i, asNumbers);
            lua_rawseti(L, -2, static_cast<int>(i));
        }
        lua_setfield(L, -2, asNumbers == 0 ? "slow" : "slowNumbers");
    }
    pushFunction<&Binding::fillHere>(L);
    lua_setfield(L, -2, "fill");
    lua_newtable(L);
    int number = 0;
    for (Slot const& slot : slots_) {
        for (Shown const& shown : slot.shown) {
            get(L, shown.proxy);
            lua_rawseti(L, -2, ++number);
        }
    }
    lua_setfield(L, -2, "proxies");
    number = 0;
    for (Slot const& slot : slots_) {
        for (std::size_t s = 0; s < slot.shown.size(); ++s) {
            for (Eager const& eager : slot.eager) {
                if (eager.shown == s) {
                    get(L, eager.table);
                    lua_rawseti(L, -2, ++number);
                }
            }
        }
    }
    lua_call(L, 1, 1);
    driver_ = keep(L);
}

int Turns::Binding::fillHere(lua_State* L) {
    fillParameters(L, target().use);
    return 0;
}

/// Finds the ids of the targets and their rows in each column, unless they are known from the last turn.
void Turns::Binding::findRows() {
    std::vector<Target> const& targets = *targets_;
    if (!context_->sameTargets || ids_[0].size() != targets.size()) {
        rowsOf_.clear();
        for (std::size_t s = 0; s < 2; ++s) {
            ids_[s].clear();
            for (Target const& each : targets) {
                ids_[s].push_back(s == 0 ? each.first : each.second);
            }
        }
    }
    std::size_t pointer = 2;
    std::size_t number = 0;
    bool const known = !rowsOf_.empty();
    for (std::size_t s = 0; s < 2; ++s) {
        Shown const* same = nullptr;
        for (Shown& shown : slots_[s].shown) {
            if (!known) {
                rowsOf_.push_back(0);
            }
            if (rowsOf_[number] != shown.column->structureVersion()) {
                rowsOf_[number] = shown.column->structureVersion();
                shown.rows.clear();
                for (ObjectId const id : ids_[s]) {
                    shown.rows.push_back(shown.column->row(id));
                }
            }
            ++number;
            // The rows of another column with the same owners are in fast memory already.
            if (same == nullptr) {
                same = &shown;
            }
            bool const shared = shown.column->sameOwners(*same->column);
            pointers_[pointer++] = shown.data;
            pointers_[pointer++] = (shared ? *same : shown).rows.data();
        }
    }
    pointers_[0] = ids_[0].data();
    pointers_[1] = ids_[1].data();
    if (script_->manifest.attached) {
        fresh_.clear();
        ScriptUse const* last = nullptr;
        for (Target const& each : targets) {
            fresh_.push_back(each.use != last ? 1 : 0);
            last = each.use;
        }
        pointers_[pointer] = fresh_.data();
    }
}

bool Turns::Binding::worldIsTarget() {
    if (!worldIsTarget_ || !context_->sameTargets) {
        worldIsTarget_ =
            worldId_.valid() && std::any_of(targets_->begin(), targets_->end(), [this](Target const& each) {
                return each.first == worldId_ || each.second == worldId_;
            });
    }
    return *worldIsTarget_;
}

void Turns::Binding::drive(lua_State* L, int apply) {
    findRows();
    get(L, driver_);
    lua_pushnumber(L, static_cast<double>(targets_->size()));
    lua_pushvalue(L, apply);
    lua_call(L, 2, 0);
}

} // namespace trembler::lua
