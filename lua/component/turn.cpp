#include "lua/component/turn.hpp"

#include "lua/binding/call_arguments.hpp"
#include "lua/binding/values.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <lua.hpp>

namespace trembler::lua {
namespace {

constexpr std::array<char const*, 2> targetNames{"object", "object"};

} // namespace

/// What a script sees of an object are empty, read-only tables whose metatables lead to hidden ones, in which
/// the host writes the values of each object in turn. So reading costs no call of C, an undeclared name is an
/// error, and nothing that a script does to the tables can last.
class Turns::Binding {
public:
    explicit Binding(std::shared_ptr<Script const> script)
        : script_(std::move(script)), sandbox_(script_->manifest.limits) {
        broken_ = sandbox_.load(script_->manifest.source, shortName());
        if (!broken_) {
            broken_ = sandbox_.protect([this](lua_State* L) { setUp(L); });
        }
    }

    [[nodiscard]] std::optional<ScriptError> const& broken() const { return broken_; }

    [[nodiscard]] TurnUsage usage() const {
        ScriptLimits const& limits = script_->manifest.limits;
        return {.instructions = sandbox_.instructions(),
                .mostInstructions = limits.instructions + limits.instructionsPerObject * lastTargets_,
                .bytes = sandbox_.memory().used(),
                .mostBytes = limits.memory,
                .targets = lastTargets_};
    }

    std::optional<ScriptError> run(TurnContext const& context, std::vector<Target> const& targets) {
        lastTargets_ = targets.size();
        context_ = &context;
        sandbox_.onLog = context.log;
        auto failed = sandbox_.turn(targets.size(), [&](lua_State* L) { applyTo(L, targets); });
        context_ = nullptr;
        return failed;
    }

private:
    /// A property as one of the two objects of a target shows it.
    struct Shown {
        std::size_t read = 0;  // its place in the script's reads
        int values = 0;        // reference to the hidden table of its fields
        int proxy = 0;         // reference to what the script sees
        bool required = false; // every target has it
        bool present = false;  // in the hidden table of the object's properties
        std::uint32_t row = ColumnBase::absent;
    };
    /// A field that is written into a hidden table for each object, not only when the script asks for it.
    struct Eager {
        std::size_t shown = 0;
        FieldPlace place;
        int table = 0; // reference: of the property's fields, or of the vector
        int key = 0;   // reference: the field's key; not of a vector
        int tableIndex = 0;
        int keyIndex = 0; // on the stack during a turn
    };
    struct Slot {
        int proxy = 0;
        int fields = 0; // the hidden table of its properties
        void const* address = nullptr;
        std::vector<Shown> shown;
        std::vector<Eager> eager;
        ObjectId id;
    };

    [[nodiscard]] std::string shortName() const {
        std::string const& file = script_->manifest.file;
        auto const slash = file.rfind('/');
        return slash == std::string::npos ? file : file.substr(slash + 1);
    }

    // ---- Making the tables, once.

    template <int (Binding::*member)(lua_State*)>
    static int call(lua_State* L) {
        auto* const self = static_cast<Binding*>(lua_touserdata(L, lua_upvalueindex(1)));
        return (self->*member)(L);
    }
    /// Pushes a function that calls a member, with two numbers to tell it from others.
    template <int (Binding::*member)(lua_State*)>
    void pushFunction(lua_State* L, std::size_t a = 0, std::size_t b = 0) {
        lua_pushlightuserdata(L, this);
        lua_pushnumber(L, static_cast<double>(a));
        lua_pushnumber(L, static_cast<double>(b));
        lua_pushcclosure(L, &call<member>, 3);
    }
    static std::size_t upvalue(lua_State* L, int n) {
        return static_cast<std::size_t>(lua_tonumber(L, lua_upvalueindex(n + 1)));
    }
    /// Pushes an empty table that shows the hidden one on top of the stack, which stays below it.
    void pushProxy(lua_State* L) {
        lua_newtable(L);
        lua_newtable(L);
        lua_pushvalue(L, -3);
        lua_setfield(L, -2, "__index");
        pushFunction<&Binding::refuseChange>(L);
        lua_setfield(L, -2, "__newindex");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
        lua_setmetatable(L, -2);
    }
    /// Gives the hidden table on top of the stack a function for the keys that it has not.
    template <int (Binding::*member)(lua_State*)>
    void setFallback(lua_State* L, std::size_t a = 0, std::size_t b = 0) {
        lua_newtable(L);
        pushFunction<member>(L, a, b);
        lua_setfield(L, -2, "__index");
        lua_setmetatable(L, -2);
    }
    static int keep(lua_State* L) { return luaL_ref(L, LUA_REGISTRYINDEX); }
    static void get(lua_State* L, int reference) { lua_rawgeti(L, LUA_REGISTRYINDEX, reference); }

    void setUp(lua_State* L) {
        lua_newtable(L); // handles of objects
        pushFunction<&Binding::handleIndex>(L);
        lua_setfield(L, -2, "__index");
        pushFunction<&Binding::refuseChange>(L);
        lua_setfield(L, -2, "__newindex");
        pushFunction<&Binding::handleEqual>(L);
        lua_setfield(L, -2, "__eq");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
        handleMeta_ = keep(L);

        bool const pairs = script_->manifest.application == Application::pairs;
        if (script_->manifest.application != Application::once) {
            setUpSlot(L, 0, script_->first);
        }
        if (pairs) {
            setUpSlot(L, 1, script_->second);
        }
        setUpParameters(L);
        setUpCalls(L);
        setUpStore(L);
        setUpFrame(L);
        lua_newtable(L);
        worldCache_ = keep(L);
        sandbox_.pushSurroundings(L);
        lua_newtable(L); // the world
        setFallback<&Binding::worldIndex>(L);
        pushProxy(L);
        worldAddress_ = lua_topointer(L, -1);
        lua_pushvalue(L, -1);
        world_ = keep(L);
        lua_setfield(L, -3, "world");
        lua_pop(L, 1);
        pushFunction<&Binding::isAlive>(L);
        lua_setfield(L, -2, "alive");
        pushFunction<&Binding::handleEqual>(L);
        lua_setfield(L, -2, "same");
        lua_pop(L, 1);
    }

    void setUpSlot(lua_State* L, std::size_t number, std::vector<std::size_t> const& required) {
        Slot& slot = slots_[number];
        lua_newtable(L); // its properties
        setFallback<&Binding::objectFallback>(L, number);
        for (std::size_t read = 0; read < script_->reads.size(); ++read) {
            DeclaredProperty const& property = script_->reads[read];
            if (property.name.empty() || !property.ofObjects()) {
                continue;
            }
            Shown shown{.read = read,
                        .required = std::find(required.begin(), required.end(), read) != required.end()};
            lua_newtable(L); // its fields
            setFallback<&Binding::fieldFallback>(L, number, slot.shown.size());
            for (FieldPlace const& place : property.fields) {
                if (isEager(place)) {
                    slot.eager.push_back(makeEager(L, slot.shown.size(), place));
                }
            }
            pushProxy(L);
            if (shown.required) {
                lua_pushlstring(L, property.name.data(), property.name.size());
                lua_pushvalue(L, -2);
                lua_rawset(L, -5); // into the object's properties
                shown.present = true;
            }
            shown.proxy = keep(L);
            shown.values = keep(L);
            for (Eager& eager : slot.eager) {
                eager.table = eager.table == 0 ? shown.values : eager.table;
            }
            slot.shown.push_back(shown);
        }
        pushProxy(L);
        slot.address = lua_topointer(L, -1);
        slot.proxy = keep(L);
        slot.fields = keep(L);
    }
    /// Fields that the script's text mentions; it reaches others by their fallback as well.
    [[nodiscard]] bool isEager(FieldPlace const& place) const {
        bool const cheap = place.kind == FieldKind::boolean || place.kind == FieldKind::integer ||
                           place.kind == FieldKind::number || place.kind == FieldKind::vector;
        return cheap && isPlain(place) && script_->words.contains(place.info.key);
    }
    // With the table of fields on top of the stack.
    Eager makeEager(lua_State* L, std::size_t shown, FieldPlace const& place) {
        Eager made{.shown = shown, .place = place};
        lua_pushlstring(L, place.info.key.data(), place.info.key.size());
        if (place.kind == FieldKind::vector) {
            sandbox_.pushVector(L, 0, 0);
            lua_pushvalue(L, -1);
            made.table = keep(L);
            lua_rawset(L, -3);
        } else {
            made.key = keep(L);
        }
        return made;
    }

    void setUpParameters(lua_State* L) {
        lua_newtable(L);
        setFallback<&Binding::parameterFallback>(L);
        pushProxy(L);
        parameters_ = keep(L);
        parameterValues_ = keep(L);
    }
    void setUpCalls(lua_State* L) {
        lua_newtable(L);
        setFallback<&Binding::callFallback>(L);
        for (std::size_t i = 0; i < script_->role->calls.size(); ++i) {
            std::string const name(script_->role->calls[i].text.name);
            pushFunction<&Binding::makeCall>(L, i);
            lua_setfield(L, -2, name.c_str());
        }
        pushProxy(L);
        out_ = keep(L);
        lua_pop(L, 1);
    }
    void setUpStore(lua_State* L) {
        lua_newtable(L);
        setFallback<&Binding::missing>(L, 1);
        for (std::size_t of = 0; of < 2; ++of) {
            lua_newtable(L);
            lua_newtable(L);
            pushFunction<&Binding::storeIndex>(L, of);
            lua_setfield(L, -2, "__index");
            pushFunction<&Binding::storeChange>(L, of);
            lua_setfield(L, -2, "__newindex");
            lua_pushboolean(L, 0);
            lua_setfield(L, -2, "__metatable");
            lua_setmetatable(L, -2);
            lua_setfield(L, -2, of == 0 ? "object" : "script");
        }
        pushProxy(L);
        store_ = keep(L);
        lua_pop(L, 1);
    }
    void setUpFrame(lua_State* L) {
        lua_newtable(L);
        setFallback<&Binding::missing>(L, 0);
        pushFunction<&Binding::random>(L);
        lua_setfield(L, -2, "random");
        pushProxy(L);
        frame_ = keep(L);
        frameValues_ = keep(L);
    }

    // ---- A turn.

    void applyTo(lua_State* L, std::vector<Target> const& targets) {
        sandbox_.pushChunk(L); // anew in each turn, so that no variable of the script lasts to the next one
        sandbox_.callScript(L, 0, 1);
        if (!lua_istable(L, -1)) {
            sandbox_.raise(L, "the script returns no interaction");
        }
        lua_pushliteral(L, "apply");
        lua_rawget(L, -2);
        int const apply = lua_gettop(L);
        lua_newtable(L);
        lua_rawseti(L, LUA_REGISTRYINDEX, worldCache_);
        get(L, frameValues_);
        lua_pushnumber(L, context_->duration);
        lua_setfield(L, -2, "duration");
        lua_pop(L, 1);
        get(L, parameterValues_);
        parameterIndex_ = lua_gettop(L);
        use_ = nullptr;
        fillParameters(L, nullptr);
        // Tables and keys lie on the stack, where they are found faster than in the registry.
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
        std::array<int, 6> arguments{};
        int count = 0;
        bool const once = script_->manifest.application == Application::once;
        for (int const reference :
             {once ? world_ : slots_[0].proxy, slots_[1].proxy, parameters_, out_, store_, frame_}) {
            if (reference != 0) {
                get(L, reference);
                arguments[static_cast<std::size_t>(count++)] = lua_gettop(L);
            }
        }
        for (Target const& target : targets) {
            cause_ = target.cause;
            show(L, slots_[0], target.first);
            if (slots_[1].proxy != 0) {
                show(L, slots_[1], target.second);
            }
            if (target.use != use_) {
                fillParameters(L, target.use);
            }
            lua_pushvalue(L, apply);
            for (int i = 0; i < count; ++i) {
                lua_pushvalue(L, arguments[static_cast<std::size_t>(i)]);
            }
            sandbox_.callScript(L, count, 0);
        }
    }

    void show(lua_State* L, Slot& slot, ObjectId id) {
        if (slot.proxy == 0) {
            return;
        }
        slot.id = id;
        for (Shown& shown : slot.shown) {
            shown.row = context_->homes[shown.read].column->row(id);
            bool const present = shown.row != ColumnBase::absent;
            if (present != shown.present) {
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
        }
        for (Eager const& eager : slot.eager) {
            Shown const& shown = slot.shown[eager.shown];
            if (shown.row == ColumnBase::absent) {
                continue;
            }
            char const* const field = static_cast<char const*>(valueOf(shown)) + eager.place.offset;
            if (eager.place.kind == FieldKind::vector) {
                Vec2 vector;
                std::memcpy(&vector, field, sizeof vector);
                lua_pushvalue(L, keyX_);
                lua_pushnumber(L, vector.x);
                lua_rawset(L, eager.tableIndex);
                lua_pushvalue(L, keyY_);
                lua_pushnumber(L, vector.y);
                lua_rawset(L, eager.tableIndex);
                continue;
            }
            lua_pushvalue(L, eager.keyIndex);
            pushField(L, sandbox_, eager.place, field - eager.place.offset, pushObject_);
            lua_rawset(L, eager.tableIndex);
        }
    }
    [[nodiscard]] void const* valueOf(Shown const& shown) const {
        ColumnBase const& column = *context_->homes[shown.read].column;
        return static_cast<char const*>(column.data()) + column.info().size * shown.row;
    }

    void fillParameters(lua_State* L, ScriptUse const* use) {
        use_ = use;
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
            lua_rawset(L, parameterIndex_);
        }
    }
    static Value settingOf(ScriptSetting const& setting, Value const& kind) {
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

    // ---- What scripts call. None keeps an object with a destructor while it calls what may raise an error,
    // but for strings and lists, which Lua's errors unwind like exceptions on the platforms that it is built
    // for.

    [[nodiscard]] static std::string keyAt(lua_State* L, int index) {
        return lua_type(L, index) == LUA_TSTRING && lua_objlen(L, index) <= longestText
                   ? lua_tostring(L, index)
                   : "?";
    }

    int refuseChange(lua_State* L) {
        sandbox_.raise(
            L, fmt::format("'{}' cannot be changed: an interaction changes nothing but by calling its "
                           "resolver, and what it keeps is in store",
                           keyAt(L, 2)));
    }

    // A property that the object has not, or that is not declared.
    int objectFallback(lua_State* L) {
        std::string const name = keyAt(L, 2);
        if (DeclaredProperty const* const property = script_->read(name)) {
            if (!property->ofObjects()) {
                sandbox_.raise(L, fmt::format("'{}' is no property of an object; read it as world{}", name,
                                              indexed(name)));
            }
            lua_pushnil(L);
            return 1;
        }
        refuseProperty(L, name, targetNames[upvalue(L, 1)]);
    }
    [[noreturn]] void refuseProperty(lua_State* L, std::string const& name, std::string_view of) {
        auto const known = script_->readNames();
        sandbox_.raise(
            L, fmt::format("the script does not declare that it reads '{}' of the {}{}; reads = {{ {} }}",
                           name, of, didYouMean(name, known), listed(known)));
    }
    static std::string indexed(std::string const& name) {
        bool const plain = std::all_of(name.begin(), name.end(),
                                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
        return plain ? "." + name : "[\"" + name + "\"]";
    }

    // A field that is not written in advance.
    int fieldFallback(lua_State* L) {
        Slot& slot = slots_[upvalue(L, 1)];
        Shown const& shown = slot.shown[upvalue(L, 2)];
        pushFieldOf(L, script_->reads[shown.read], keyAt(L, 2), slot.id);
        return 1;
    }
    /// Pushes a field of the property of an object, which has it, or of a slot.
    void pushFieldOf(lua_State* L, DeclaredProperty const& property, std::string const& key, ObjectId id) {
        FieldPlace const* const place = property.field(key);
        if (place == nullptr) {
            auto const known = property.keys();
            sandbox_.raise(L, known.empty() ? fmt::format("{} has no fields", property.name)
                                            : fmt::format("{} has no '{}'{}; it has {}", property.name, key,
                                                          didYouMean(key, known), listed(known)));
        }
        Home const& home = context_->homes[static_cast<std::size_t>(&property - script_->reads.data())];
        if (isPlain(*place)) {
            void const* const value = home.slot != nullptr
                                          ? home.slot->data()
                                          : static_cast<char const*>(home.column->data()) +
                                                home.column->info().size * home.column->row(id);
            pushField(L, sandbox_, *place, value, pushObject_);
            return;
        }
        FieldPusher pusher(L, sandbox_, place->info.key, pushObject_);
        if (home.slot != nullptr) {
            home.slot->visitCurrent(pusher);
        } else {
            home.column->visitCopy(id, pusher);
        }
        if (!pusher.found()) { // one that depends on a choice that this object has not made
            lua_pushnil(L);
        }
    }
    /// Pushes a table with all fields.
    void pushTableOf(lua_State* L, DeclaredProperty const& property, ObjectId id) {
        lua_newtable(L);
        for (FieldPlace const& place : property.fields) {
            lua_pushlstring(L, place.info.key.data(), place.info.key.size());
            pushFieldOf(L, property, std::string(place.info.key), id);
            lua_rawset(L, -3);
        }
    }

    int worldIndex(lua_State* L) {
        std::string const name = keyAt(L, 2);
        DeclaredProperty const* const property = script_->read(name);
        if (property == nullptr) {
            refuseProperty(L, name, "world");
        }
        get(L, worldCache_);
        lua_pushvalue(L, 2);
        lua_rawget(L, -2);
        if (!lua_isnil(L, -1)) {
            return 1;
        }
        lua_pop(L, 1);
        ObjectId const world = context_->store.find("world");
        Home const& home = context_->homes[static_cast<std::size_t>(property - script_->reads.data())];
        if (home.column != nullptr && !home.column->has(world)) {
            lua_pushnil(L);
            return 1;
        }
        pushTableOf(L, *property, world);
        lua_pushvalue(L, 2);
        lua_pushvalue(L, -2);
        lua_rawset(L, -4);
        return 1;
    }

    int parameterFallback(lua_State* L) {
        std::vector<std::string> known;
        for (Parameter const& parameter : script_->manifest.parameters) {
            known.push_back(parameter.name);
        }
        std::string const name = keyAt(L, 2);
        sandbox_.raise(L, fmt::format("there is no parameter '{}'{}; params has {}", name,
                                      didYouMean(name, known), known.empty() ? "nothing" : listed(known)));
    }

    int callFallback(lua_State* L) {
        std::vector<std::string> known;
        for (CallDescription const& call : script_->role->calls) {
            known.emplace_back(call.text.name);
        }
        std::string const name = keyAt(L, 2);
        sandbox_.raise(L, fmt::format("{} has no function '{}'{}; it has {}", script_->role->name, name,
                                      didYouMean(name, known), listed(known)));
    }

    int makeCall(lua_State* L) {
        std::size_t const number = upvalue(L, 1);
        if (context_ == nullptr) {
            sandbox_.raise(L, "calls are made in apply");
        }
        sandbox_.chargeCall(L);
        CallBytes bytes;
        readArguments(L, sandbox_, context_->store, script_->role->calls[number], objectAt_, bytes);
        context_->source.record(number, bytes.bytes.data(), cause_, context_->sink);
        return 0;
    }

    // ---- Handles

    void pushHandle(lua_State* L, ObjectId id) {
        if (!id.valid()) {
            lua_pushnil(L);
            return;
        }
        void* const place = lua_newuserdata(L, sizeof id);
        std::memcpy(place, &id, sizeof id);
        get(L, handleMeta_);
        lua_setmetatable(L, -2);
    }
    [[nodiscard]] std::optional<ObjectId> objectAt(lua_State* L, int index) const {
        if (lua_type(L, index) == LUA_TUSERDATA) { // there are no others
            ObjectId id;
            std::memcpy(&id, lua_touserdata(L, index), sizeof id);
            return id;
        }
        if (lua_type(L, index) != LUA_TTABLE) {
            return std::nullopt;
        }
        void const* const address = lua_topointer(L, index);
        for (Slot const& slot : slots_) {
            if (slot.address == address) {
                return slot.id;
            }
        }
        return address == worldAddress_ ? std::optional(context_->store.find("world")) : std::nullopt;
    }
    int handleIndex(lua_State* L) {
        auto const id = objectAt(L, 1);
        std::string const name = keyAt(L, 2);
        DeclaredProperty const* const property = script_->read(name);
        if (property == nullptr) {
            refuseProperty(L, name, "object");
        }
        if (!id || context_ == nullptr || !context_->store.alive(*id)) {
            sandbox_.raise(L, fmt::format("the object whose '{}' is read is gone", name));
        }
        if (!property->ofObjects()) {
            sandbox_.raise(
                L, fmt::format("'{}' is no property of an object; read it as world{}", name, indexed(name)));
        }
        Home const& home = context_->homes[static_cast<std::size_t>(property - script_->reads.data())];
        if (!home.column->has(*id)) {
            lua_pushnil(L);
            return 1;
        }
        pushTableOf(L, *property, *id);
        return 1;
    }
    int handleEqual(lua_State* L) {
        lua_pushboolean(L, objectAt(L, 1) == objectAt(L, 2) ? 1 : 0);
        return 1;
    }
    int isAlive(lua_State* L) {
        auto const id = objectAt(L, 1);
        lua_pushboolean(L, id && context_ != nullptr && context_->store.alive(*id) ? 1 : 0);
        return 1;
    }

    // ---- What lasts

    int storeIndex(lua_State* L) {
        bool const ofScript = upvalue(L, 1) == 1;
        std::size_t const field = storeField(L, ofScript);
        pushValue(L, sandbox_,
                  ofScript ? context_->kept.ofScript(field) : context_->kept.ofObject(slots_[0].id, field));
        return 1;
    }
    int storeChange(lua_State* L) {
        bool const ofScript = upvalue(L, 1) == 1;
        std::size_t const field = storeField(L, ofScript);
        auto value = valueAt(L, sandbox_, 3);
        std::string wrong;
        if (!value) {
            wrong = fmt::format("'{}' in the store cannot be a {}", keyAt(L, 2), kindOf(L, 3));
        } else if (ofScript) {
            wrong = context_->kept.setOfScript(field, std::move(*value));
        } else {
            wrong = context_->kept.setOfObject(slots_[0].id, field, std::move(*value));
        }
        if (!wrong.empty()) {
            sandbox_.raise(L, wrong);
        }
        return 0;
    }
    std::size_t storeField(lua_State* L, bool ofScript) {
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
    int missing(lua_State* L) {
        bool const ofStore = upvalue(L, 1) == 1;
        sandbox_.raise(L, fmt::format("{} has no '{}'; it has {}", ofStore ? "store" : "frame", keyAt(L, 2),
                                      ofStore ? "'object' and 'script', with what the script declares"
                                              : "'duration', in s, and 'random()'"));
    }
    int random(lua_State* L) {
        lua_pushnumber(L, context_ == nullptr ? 0 : context_->kept.random());
        return 1;
    }

    std::shared_ptr<Script const> script_;
    Sandbox sandbox_;
    std::optional<ScriptError> broken_;
    TurnContext const* context_ = nullptr;
    std::array<Slot, 2> slots_;
    EventId cause_;
    ScriptUse const* use_ = nullptr;
    PushObject const pushObject_ = [this](lua_State* L, ObjectId id) { pushHandle(L, id); };
    ObjectAt const objectAt_ = [this](lua_State* L, int index) { return objectAt(L, index); };
    void const* worldAddress_ = nullptr;
    int handleMeta_ = 0; // references into the registry
    int parameters_ = 0;
    int parameterValues_ = 0;
    int out_ = 0;
    int store_ = 0;
    int frame_ = 0;
    int frameValues_ = 0;
    int world_ = 0;
    int worldCache_ = 0;     // what the world has shown in this turn
    int parameterIndex_ = 0; // indices on the stack during a turn
    int keyX_ = 0;
    int keyY_ = 0;
    std::size_t lastTargets_ = 0;
};

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
