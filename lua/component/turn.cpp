#include "lua/component/turn.hpp"

#include "lua/component/turn_binding.hpp"

#include <algorithm>
#include <cstring>

namespace trembler::lua {

Turns::Binding::Binding(std::shared_ptr<Script const> script)
    : script_(std::move(script)), sandbox_(script_->manifest.limits, script_->manifest.trust),
      gatherer_(*script_->role) {
    VectorArguments const vectors = vectorArguments();
    broken_ = sandbox_.load(script_->manifest.source, shortName(), &vectors);
    if (!broken_) {
        broken_ = sandbox_.protect([this](lua_State* L) { setUp(L); });
    }
}

TurnUsage Turns::Binding::usage() const {
    return {.instructions = sandbox_.instructions(),
            .mostInstructions = sandbox_.mostInstructions(),
            .bytes = sandbox_.memory().used(),
            .mostBytes = sandbox_.mostMemory(),
            .targets = lastTargets_};
}

/// apply(object, params, out), apply(a, b, params, out) or apply(world, params, out).
VectorArguments Turns::Binding::vectorArguments() const {
    VectorArguments made;
    made.parameter = script_->manifest.application == Application::pairs ? 4 : 3;
    for (CallDescription const& call : script_->role->calls) {
        if (planOf(call).plain) {
            std::vector<bool>& arguments = made.calls[std::string(call.text.name)];
            for (FieldPlace const& place : call.arguments) {
                arguments.push_back(place.kind == FieldKind::vector);
            }
        }
    }
    return made;
}

std::string Turns::Binding::shortName() const {
    std::string const& file = script_->manifest.file;
    auto const slash = file.rfind('/');
    return slash == std::string::npos ? file : file.substr(slash + 1);
}

std::optional<ScriptError> Turns::Binding::run(TurnContext const& context,
                                               std::vector<Target> const& targets) {
    context_ = &context;
    targets_ = &targets;
    lastTargets_ = targets.size();
    at_ = 0;
    worldId_ = context.store.find("world");
    sandbox_.onLog = context.log;
    findColumns();
    std::optional<ScriptError> failed;
    try {
        failed = sandbox_.turn(
            targets.size(), [&](lua_State* L) { applyTo(L); },
            context.sameFrame ? Sandbox::TurnOf::sameFrame : Sandbox::TurnOf::newFrame);
    } catch (...) { // of the host: the run ends
        gatherer_.drop();
        context_ = nullptr;
        targets_ = nullptr;
        throw;
    }
    if (failed) {
        gatherer_.drop();
    } else {
        gatherer_.record(context.source);
    }
    context_ = nullptr;
    targets_ = nullptr;
    return failed;
}

void Turns::Binding::findColumns() {
    for (Slot& slot : slots_) {
        for (Shown& shown : slot.shown) {
            shown.column = context_->homes[shown.read].column;
            shown.data = static_cast<char const*>(shown.column->data());
            shown.size = shown.column->info().size;
        }
    }
}

void Turns::Binding::applyTo(lua_State* L) {
    sandbox_.chargeText(L, targets_->size());
    if (driver_ != 0 && !rehearsed_) {
        constexpr int often = 5;
        sandbox_.rehearse(L, often);
        rehearsed_ = true;
    }
    int const apply = pushApply(L);
    lua_newtable(L);
    lua_rawseti(L, LUA_REGISTRYINDEX, worldCache_);
    get(L, frameValues_);
    lua_pushnumber(L, context_->duration);
    lua_setfield(L, -2, "duration");
    lua_pop(L, 1);
    use_ = nullptr;
    fillParameters(L, nullptr);
    // A traced call is recorded at once, with its cause, which compiled code cannot do.
    // Nor does it refuse the world where a call takes an object.
    if (driver_ != 0 && context_->sink == nullptr && !worldIsTarget()) {
        drive(L, apply);
        return;
    }
    pushKeysAndTables(L);
    applyToEach(L, apply);
}

/// Runs the chunk, again in each turn, so that no variable of the script lasts to the next one. Returns the
/// place of its function on the stack.
int Turns::Binding::pushApply(lua_State* L) {
    sandbox_.pushChunk(L);
    sandbox_.callScript(L, 0, 1);
    if (!lua_istable(L, -1)) {
        sandbox_.raise(L, "the script returns no interaction");
    }
    lua_pushliteral(L, "apply");
    lua_rawget(L, -2);
    return lua_gettop(L);
}

/// Pushes tables and keys: on the stack they are found faster than in the registry.
void Turns::Binding::pushKeysAndTables(lua_State* L) {
    lua_pushliteral(L, "x");
    keyX_ = lua_gettop(L);
    lua_pushliteral(L, "y");
    keyY_ = lua_gettop(L);
    for (Slot& slot : slots_) {
        luaL_checkstack(L, 2 * static_cast<int>(slot.eager.size()) + 20, "too many properties");
        for (Eager& eager : slot.eager) {
            get(L, eager.table);
            eager.tableIndex = lua_gettop(L);
            if (eager.key != 0) {
                get(L, eager.key);
                eager.keyIndex = lua_gettop(L);
            }
        }
    }
}

void Turns::Binding::applyToEach(lua_State* L, int apply) {
    std::array<int, 6> arguments{};
    std::size_t count = 0;
    bool const once = script_->manifest.application == Application::once;
    for (int const reference :
         {once ? world_ : slots_[0].proxy, slots_[1].proxy, parameters_, out_, store_, frame_}) {
        if (reference != 0) {
            get(L, reference);
            arguments[count++] = lua_gettop(L);
        }
    }
    count = std::min(count, sandbox_.source().parameters); // parameters that it does not read need not be set
    if (driver_ != 0) {                                    // compiled code has shown other objects since
        gatherer_.close();                                 // its functions would gather calls
        for (Slot& slot : slots_) {
            findPresent(L, slot);
        }
    }
    for (Target const& target : *targets_) {
        at_ = static_cast<std::int32_t>(&target - targets_->data());
        show(L, slots_[0], target.first);
        if (slots_[1].proxy != 0) {
            show(L, slots_[1], target.second);
        }
        if (target.use != use_) {
            fillParameters(L, target.use);
        }
        lua_pushvalue(L, apply);
        for (std::size_t i = 0; i < count; ++i) {
            lua_pushvalue(L, arguments[i]);
        }
        sandbox_.callScript(L, static_cast<int>(count), 0);
    }
}

void Turns::Binding::show(lua_State* L, Slot& slot, ObjectId id) {
    for (Shown& shown : slot.shown) {
        shown.row = shown.column->row(id);
        bool const present = shown.row != ColumnBase::absent;
        if (present != shown.present) {
            setPresent(L, slot, shown, present);
        }
    }
    for (Eager const& eager : slot.eager) {
        Shown const& shown = slot.shown[eager.shown];
        if (shown.row == ColumnBase::absent) {
            continue;
        }
        char const* const value = shown.data + shown.size * shown.row;
        if (eager.place.kind == FieldKind::number) {
            double number = 0;
            std::memcpy(&number, value + eager.place.offset, sizeof number);
            lua_pushvalue(L, eager.keyIndex);
            lua_pushnumber(L, number);
            lua_rawset(L, eager.tableIndex);
        } else if (eager.place.kind == FieldKind::vector) {
            Vec2 vector;
            std::memcpy(&vector, value + eager.place.offset, sizeof vector);
            lua_pushvalue(L, keyX_);
            lua_pushnumber(L, vector.x);
            lua_rawset(L, eager.tableIndex);
            lua_pushvalue(L, keyY_);
            lua_pushnumber(L, vector.y);
            lua_rawset(L, eager.tableIndex);
        } else {
            lua_pushvalue(L, eager.keyIndex);
            pushField(L, sandbox_, eager.place, value, pushObject_);
            lua_rawset(L, eager.tableIndex);
        }
    }
}

void Turns::Binding::findPresent(lua_State* L, Slot& slot) {
    for (Shown& shown : slot.shown) {
        get(L, slot.fields);
        std::string const& name = script_->reads[shown.read].name;
        lua_pushlstring(L, name.data(), name.size());
        lua_rawget(L, -2);
        shown.present = !lua_isnil(L, -1);
        lua_pop(L, 2);
    }
}

void Turns::Binding::setPresent(lua_State* L, Slot& slot, Shown& shown, bool present) {
    get(L, slot.fields);
    std::string const& name = script_->reads[shown.read].name;
    lua_pushlstring(L, name.data(), name.size());
    if (present) {
        get(L, shown.proxy);
    } else {
        lua_pushnil(L);
    }
    lua_rawset(L, -3);
    lua_pop(L, 1);
    shown.present = present;
}

namespace {

Value settingOf(ScriptSetting const& setting, Value const& kind) {
    switch (kind.index()) {
    case 0:
        return setting.on;
    case 1:
        return setting.number;
    case 2:
        return setting.vector;
    default:
        return setting.text;
    }
}

} // namespace

void Turns::Binding::fillParameters(lua_State* L, ScriptUse const* use) {
    use_ = use;
    get(L, parameterValues_);
    for (Parameter const& parameter : script_->manifest.parameters) {
        Value value = parameter.initial;
        if (use != nullptr) {
            auto const set =
                std::find_if(use->settings.begin(), use->settings.end(),
                             [&](ScriptSetting const& s) { return s.parameter == parameter.name; });
            if (set != use->settings.end()) {
                value = settingOf(*set, parameter.initial);
            }
        }
        lua_pushlstring(L, parameter.name.data(), parameter.name.size());
        pushValue(L, sandbox_, value);
        lua_rawset(L, -3);
    }
    lua_pop(L, 1);
}

Turns::Turns(std::shared_ptr<Script const> script) : binding_(std::make_unique<Binding>(std::move(script))) {}
Turns::~Turns() = default;

std::optional<ScriptError> const& Turns::broken() const {
    return binding_->broken();
}

std::optional<ScriptError> Turns::run(TurnContext const& context, std::vector<Target> const& targets) {
    return binding_->run(context, targets);
}

TurnUsage Turns::usage() const {
    return binding_->usage();
}

} // namespace trembler::lua
