// The inside of Turns: the tables by which a script sees objects and makes calls.
#pragma once

#include "lua/binding/call_arguments.hpp"
#include "lua/binding/call_plan.hpp"
#include "lua/binding/values.hpp"
#include "lua/component/turn.hpp"
#include "lua/sandbox/source/spread_vectors.hpp"

#include <array>
#include <lua.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::lua {

/// A script sees an object as tables into which the host writes the values of each object in turn, so reading
/// costs no call of C. An undeclared name is an error, which a function for missing keys raises. A script
/// that assigns to no field of a table sees these tables themselves. Any other script sees empty, read-only
/// tables whose metatables lead to them, so it cannot change the tables.
class Turns::Binding {
public:
    explicit Binding(std::shared_ptr<Script const> script);

    [[nodiscard]] std::optional<ScriptError> const& broken() const { return broken_; }
    [[nodiscard]] std::optional<ScriptError> run(TurnContext const& context,
                                                 std::vector<Target> const& targets);
    [[nodiscard]] TurnUsage usage() const;

private:
    /// A property as one of the two objects of a target shows it.
    struct Shown {
        std::size_t read = 0;  // its place in the script's reads
        int values = 0;        // reference to the table of its fields
        int proxy = 0;         // reference to the table that the script sees
        bool required = false; // every target has it
        bool present = false;  // in the table of the object's properties
        std::uint32_t row = ColumnBase::absent;
        ColumnBase const* column = nullptr; // of this turn
        char const* data = nullptr;
        std::size_t size = 0;
        std::vector<std::uint32_t> rows; // of the targets, for compiled code
    };
    /// A field that is written into a table for each object, not only when the script asks for it.
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
        int fields = 0; // the table of its properties
        void const* address = nullptr;
        std::vector<Shown> shown;
        std::vector<Eager> eager;
    };

    [[nodiscard]] std::string shortName() const;
    [[nodiscard]] VectorArguments vectorArguments() const;

    // Making the tables, once: turn_tables.cpp.
    template <int (Binding::*member)(lua_State*)>
    static int unguardedCall(lua_State* L);
    template <int (Binding::*member)(lua_State*)>
    void pushFunction(lua_State* L, std::size_t a = 0, std::size_t b = 0);
    template <int (Binding::*member)(lua_State*)>
    void setFallback(lua_State* L, std::size_t a = 0, std::size_t b = 0);
    [[nodiscard]] static std::size_t upvalue(lua_State* L, int n);
    [[nodiscard]] static int keep(lua_State* L);
    static void get(lua_State* L, int reference);
    void pushShown(lua_State* L, std::string_view name);
    void pushProxy(lua_State* L, std::string_view name);
    void closeMetatable(lua_State* L, std::string_view name);
    void setUp(lua_State* L);
    void setUpReadings(lua_State* L);
    void setUpHandles(lua_State* L);
    void setUpSlot(lua_State* L, std::size_t number, std::vector<std::size_t> const& required);
    [[nodiscard]] bool isEager(FieldPlace const& place) const;
    [[nodiscard]] Eager makeEager(lua_State* L, std::size_t shown, FieldPlace const& place);
    void setUpParameters(lua_State* L);
    void setUpCalls(lua_State* L);
    void setUpStore(lua_State* L);
    void setUpFrame(lua_State* L);
    void setUpWorld(lua_State* L);

    // A turn: turn.cpp.
    void applyTo(lua_State* L);
    int pushApply(lua_State* L);
    void pushKeysAndTables(lua_State* L);
    void applyToEach(lua_State* L, int apply);
    void findColumns();
    void show(lua_State* L, Slot& slot, ObjectId id);
    void findPresent(lua_State* L, Slot& slot);
    void setPresent(lua_State* L, Slot& slot, Shown& shown, bool present);
    void fillParameters(lua_State* L, ScriptUse const* use);
    [[nodiscard]] Target const& target() const { return (*targets_)[static_cast<std::size_t>(at_)]; }
    [[nodiscard]] ObjectId idOf(std::size_t slot) const {
        return slot == 0 ? target().first : target().second;
    }

    // The same, compiled: trusted_driver.cpp.
    [[nodiscard]] bool canDrive() const;
    void setUpDriver(lua_State* L);
    [[nodiscard]] std::string driverText() const;
    void findRows();
    [[nodiscard]] bool worldIsTarget();
    void drive(lua_State* L, int apply);
    int fillHere(lua_State* L);

    // The functions that scripts call. None holds an object with a destructor while it calls a function that
    // may raise an error, except strings and lists, which Lua's errors unwind like exceptions on the
    // platforms that it is built for.

    // Reading properties: turn_properties.cpp.
    [[nodiscard]] static std::string keyAt(lua_State* L, int index);
    [[nodiscard]] static std::string indexed(std::string const& name);
    [[noreturn]] void refuseProperty(lua_State* L, std::string const& name, std::string_view of);
    void pushFieldOf(lua_State* L, DeclaredProperty const& property, std::string const& key, ObjectId id);
    void pushTableOf(lua_State* L, DeclaredProperty const& property, ObjectId id);
    [[noreturn]] void refuseField(lua_State* L, DeclaredProperty const& property, std::string const& key);
    [[nodiscard]] std::size_t numberOf(DeclaredProperty const& property) const;
    [[nodiscard]] Home const& homeOf(DeclaredProperty const& property) const;
    int refuseChange(lua_State* L);
    int objectFallback(lua_State* L);
    int fieldFallback(lua_State* L);
    int worldIndex(lua_State* L);
    int readingIndex(lua_State* L);

    // Calls: turn_calls.cpp.
    int callFallback(lua_State* L);
    int makeCall(lua_State* L);
    [[nodiscard]] bool readPlain(lua_State* L, CallPlan const& plan, char* into, ArgumentForm form) const;

    // Handles: turn_handles.cpp.
    void pushHandle(lua_State* L, ObjectId id);
    [[nodiscard]] std::optional<ObjectId> objectAt(lua_State* L, int index) const;
    int handleIndex(lua_State* L);
    int handleEqual(lua_State* L);
    int isAlive(lua_State* L);
    int isSame(lua_State* L);

    // Parameters, the store and the frame: turn_store.cpp.
    int parameterFallback(lua_State* L);
    int storeIndex(lua_State* L);
    int storeChange(lua_State* L);
    [[nodiscard]] std::size_t storeField(lua_State* L, bool ofScript);
    int missing(lua_State* L);
    int random(lua_State* L);

    std::shared_ptr<Script const> script_;
    Sandbox sandbox_;
    std::optional<ScriptError> broken_;
    bool direct_ = false; // the script sees the tables themselves
    TurnContext const* context_ = nullptr;
    std::vector<Target> const* targets_ = nullptr;
    std::size_t lastTargets_ = 0;
    std::int32_t at_ = 0; // the target whose turn it is; compiled code writes it
    std::array<Slot, 2> slots_;
    std::vector<CallPlan> plans_;
    CallGatherer gatherer_;
    ScriptUse const* use_ = nullptr;
    PushObject const pushObject_ = [this](lua_State* L, ObjectId id) { pushHandle(L, id); };
    ObjectAt const objectAt_ = [this](lua_State* L, int index) { return objectAt(L, index); };
    void const* worldAddress_ = nullptr;
    ObjectId worldId_; // of this turn; invalid if the level has none
    std::optional<bool> worldIsTarget_;
    int handleMeta_ = 0;            // references into the registry
    std::vector<int> readingMetas_; // of the script's reads: of tables that are made when it reads them
    int parameters_ = 0;
    int parameterValues_ = 0;
    int out_ = 0;
    int outValues_ = 0;
    int outNumbers_ = 0; // the functions that take two numbers for each vector, where vec2() was written
    int store_ = 0;
    int frame_ = 0;
    int frameValues_ = 0;
    int world_ = 0;
    int worldCache_ = 0; // the world's values that were read in this turn
    int driver_ = 0;     // 0: none
    int keyX_ = 0;       // indices on the stack during a turn
    int keyY_ = 0;
    bool rehearsed_ = false;
    std::vector<void const*> pointers_; // for compiled code: ids, then data and rows of the shown columns
    std::array<std::vector<ObjectId>, 2> ids_;
    std::vector<std::uint8_t> fresh_;   // whether a target has other parameters than the one before
    std::vector<std::uint64_t> rowsOf_; // structure versions of the columns for which rows were found
};

// The functions that are called through their names in the description of a call to Lua.

template <int (Turns::Binding::*member)(lua_State*)>
int Turns::Binding::unguardedCall(lua_State* L) {
    auto* const self = static_cast<Binding*>(lua_touserdata(L, lua_upvalueindex(1)));
    return (self->*member)(L);
}
/// Pushes a function that calls a member, with two numbers that identify it.
template <int (Turns::Binding::*member)(lua_State*)>
void Turns::Binding::pushFunction(lua_State* L, std::size_t a, std::size_t b) {
    lua_pushlightuserdata(L, this);
    lua_pushnumber(L, static_cast<double>(a));
    lua_pushnumber(L, static_cast<double>(b));
    lua_pushcclosure(L, &Sandbox::guarded<&Binding::unguardedCall<member>>, 3);
}
/// Gives the table on top of the stack a function for missing keys.
template <int (Turns::Binding::*member)(lua_State*)>
void Turns::Binding::setFallback(lua_State* L, std::size_t a, std::size_t b) {
    lua_newtable(L);
    pushFunction<member>(L, a, b);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);
}

} // namespace trembler::lua
