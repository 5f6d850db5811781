// One Lua state in which one script runs, without access to anything outside it.
#pragma once

#include "lua/sandbox/limits.hpp"
#include "lua/sandbox/memory.hpp"
#include "lua/sandbox/source/counted_source.hpp"
#include "runtime/math/vec2.hpp"

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

struct lua_State;

namespace trembler::lua {

/// Why a script could not go on.
struct ScriptError {
    std::string message;   ///< with the script's file and line where they are known
    std::string traceback; ///< the calls that led there; may be empty
    bool limit = false;    ///< a limit was reached
};

/// Calls of the resolver in a frame. Compiled code counts them too, so they are plain numbers.
struct CallBudget {
    double made = 0;
    double most = 0;
};

/// The memory, the instructions and the functions that a script gets. A script's text is run again in each
/// turn, and no value that it makes lasts to the next one, so it cannot keep a state that is not hashed. Used
/// by one thread at a time.
///
/// Scripts never see an exception of C++, which they could catch: it ends the turn, or protect(), and is
/// thrown again from there.
///
/// The memory that an untrusted script uses is the same in every run, to the byte. LuaJIT's collector would
/// prevent that: it goes through the strings in the order of their hashes, for which each state has a random
/// seed, and it makes stacks smaller. So it is stopped, all garbage is collected at once where the host
/// decides it, and each turn has a new stack.
class Sandbox {
public:
    /// Throws std::bad_alloc.
    explicit Sandbox(ScriptLimits const& limits, Trust trust = Trust::untrusted);
    ~Sandbox();
    Sandbox(Sandbox const&) = delete;
    Sandbox& operator=(Sandbox const&) = delete;

    /// Compiles a text; `name` stands for it in messages, "wind.lua". To be called once. For `vectors`, see
    /// countSource().
    [[nodiscard]] std::optional<ScriptError> load(std::string_view text, std::string const& name,
                                                  VectorArguments const* vectors = nullptr);

    /// A function that is called back in protected mode. It may call functions that raise Lua errors. Its
    /// values on the stack are removed afterwards.
    using Body = std::function<void(lua_State*)>;
    /// Runs the host's own code in protected mode: running out of memory does not abort the program then.
    [[nodiscard]] std::optional<ScriptError> protect(Body const& body);
    /// Which turn of its frame a turn is.
    enum class TurnOf {
        newFrame,  ///< the first one
        sameFrame, ///< a later one: it has the rest of the limits, and more for its own objects
    };
    /// Runs a turn: `body` within the limits for `objects` objects. After a turn that has failed, only turns
    /// of new frames may follow.
    [[nodiscard]] std::optional<ScriptError> turn(std::size_t objects, Body const& body,
                                                  TurnOf of = TurnOf::newFrame);

    // For the functions that scripts call, and within protect() and turn():

    /// Pushes the function into which the text was compiled.
    void pushChunk(lua_State* L) const;
    /// Counts the instructions of the chunk, once, and those of apply for that many applications, if it does
    /// not count them by itself. Raises a Lua error beyond the limit.
    void chargeText(lua_State* L, std::size_t applications);
    /// Runs the chunk several times, uncounted and without its log. The compiler recognises functions that
    /// were made often as different functions of one text.
    void rehearse(lua_State* L, int times);
    /// Pushes LuaJIT's FFI library. Of a trusted script's state only, for the host's own functions.
    void pushFfi(lua_State* L) const;
    /// Pushes the table of globals that scripts see besides their own; fields that are set in it are seen by
    /// the script.
    void pushSurroundings(lua_State* L) const;
    /// Pops the value on top of the stack and shows it to the script's chunk, under a name of CountedSource,
    /// which a script cannot use itself.
    void showChunk(lua_State* L, std::string_view name) const;
    /// Pushes the metatable of vectors.
    void pushVectorMeta(lua_State* L) const;
    /// Pushes what stands under __metatable in the metatables of vectors, and in those of the host's other
    /// tables, which scripts may neither look through nor change. No script can get either value.
    void pushVectorMark(lua_State* L) const;
    void pushHostMark(lua_State* L) const;
    /// The same of readings, see below.
    void pushReadingMark(lua_State* L) const;
    /// Pushes the keys of a vector's coordinates: "x" and "y" or, where the script assigns to fields, two
    /// that it cannot name.
    void pushVectorKeyX(lua_State* L) const;
    void pushVectorKeyY(lua_State* L) const;
    /// Pushes a vector.
    void pushVector(lua_State* L, double x, double y) const;
    /// The same for one that is a copy of what the script reads: it cannot be changed, as that would change
    /// nothing else.
    void pushReadVector(lua_State* L, double x, double y) const;
    // Tables and lists that are made when a script reads them: the script may look through them, with
    // pairs(), ipairs() and #, and cannot change them. A script that assigns to fields sees an empty table in
    // place of one, in which it stands under a key that the script cannot name.

    /// Pushes the metatable of readings, which the host may copy to answer missing keys in its own way.
    void pushReadingMeta(lua_State* L) const;
    /// Pops a metatable and the table below it, and pushes what the script sees of the table. Other keys than
    /// those that are there are answered by the metatable.
    void closeReading(lua_State* L) const;
    /// Pushes the table itself of the reading at `index`, which is counted from the stack's beginning.
    void pushInside(lua_State* L, int index) const;
    /// Pushes a text for the script: one that reads as a long number in brackets (see readsAsLongNumber()).
    /// Counts it, and raises a Lua error if it is longer than longestString.
    void pushText(lua_State* L, std::string_view text);
    /// The coordinates of a vector, or of another table with numbers x and y.
    [[nodiscard]] std::optional<Vec2> vectorAt(lua_State* L, int index) const;
    /// Calls the function below `arguments` arguments, as the script's own code: blocks are bounded.
    void callScript(lua_State* L, int arguments, int results);
    /// Counts the host's work as this many instructions. Raises a Lua error beyond the limit.
    void charge(lua_State* L, double instructions);
    /// Counts a call of the resolver; `creates`: it creates an object.
    void chargeCall(lua_State* L, bool creates = false);
    /// Raises an error with the place in the script that is under way.
    [[noreturn]] void raise(lua_State* L, std::string const& message);
    /// The same as a limit, which ends the turn: the script cannot catch it.
    [[noreturn]] void raiseLimit(lua_State* L, std::string const& message) { stop(L, message); }
    /// Raises an error if the arguments on the stack are not those of the host's function of that name.
    void checkArguments(lua_State* L, std::string_view function);

    /// Receives the lines that the script logs; set before the turn. Lines beyond the limit are dropped.
    std::function<void(std::string const&)> onLog;
    /// Instructions of the last turn and of those before it in the same frame, and their limit so far.
    [[nodiscard]] std::uint64_t instructions() const { return spent_; }
    [[nodiscard]] std::uint64_t mostInstructions() const { return static_cast<std::uint64_t>(budget_); }
    [[nodiscard]] Memory const& memory() const { return memory_; }
    /// Bytes by which the memory in use may grow in a turn.
    [[nodiscard]] std::size_t mostMemory() const;
    [[nodiscard]] CallBudget& calls() { return calls_; }
    [[nodiscard]] bool trusted() const { return trust_ == Trust::trusted; }
    /// Results of reading the text of the script.
    [[nodiscard]] CountedSource const& source() const { return source_; }
    [[nodiscard]] lua_State* state() const { return state_; }
    /// The message about a script whose functions call one another without end.
    static constexpr std::string_view tooDeep = "the script calls itself too deeply";
    /// The sandbox of a state.
    [[nodiscard]] static Sandbox& of(lua_State* L);
    /// A function of the host as Lua calls it: an exception of C++ in it ends the turn like a limit.
    template <int (*function)(lua_State*)>
    static int guarded(lua_State* L);

private:
    struct Functions;                          // those of the host that Lua calls: prelude/host_functions.hpp
    static constexpr double unlimited = 1e300; // instructions, outside of turns
    /// "wind.lua:12: ", where the script is; empty if it is not known. Needs no memory of the state.
    [[nodiscard]] static std::string placeOf(lua_State* L);
    /// The calls of the script's functions that are under way, a line each, innermost first; one line for
    /// calls of one place that follow one another. Needs no memory of the state.
    [[nodiscard]] static std::string callsOf(lua_State* L);
    /// Called where memory is refused: notes the place.
    void noteRefusal();
    /// Raises the error of the limit: the counter of instructions is below zero.
    [[noreturn]] void over(lua_State* L);
    /// `placed`: put the place in the script before the message.
    [[noreturn]] void stop(lua_State* L, std::string const& message, bool placed = true);
    /// Keeps the exception and raises an error that no script can catch.
    [[noreturn]] void endBy(lua_State* L, std::exception_ptr exception);
    void throwKept();
    void open();
    void openLibraries(lua_State* L);
    /// Compiles a text with counters, and pushes its function.
    void compile(lua_State* L, CountedSource const& source, std::string const& name);
    void bindCounter(lua_State* L) const;
    void chooseGlobals(lua_State* L);
    /// The remaining instructions: a variable of the prelude that all functions of the state share.
    [[nodiscard]] double left(lua_State* L) const;
    void setLeft(lua_State* L, double instructions) const;
    [[nodiscard]] std::optional<ScriptError> run(lua_State* L, Body const& body);
    [[nodiscard]] std::optional<ScriptError> runOnNewStack(Body const& body);
    /// Collects all garbage: between turns and between two calls of the script only.
    void collect();
    void beginTurn(std::size_t objects, TurnOf of);
    void finishTurn(std::optional<ScriptError>& failed);

    ScriptLimits limits_;
    Trust trust_;
    Memory memory_;
    lua_State* state_ = nullptr;
    CountedSource source_;
    int chunk_ = 0; // references into the registry
    int surroundings_ = 0;
    int globals_ = 0;
    int fill_ = 0;
    int reset_ = 0;
    int vectorMeta_ = 0;
    int vectorMark_ = 0;
    int hostMark_ = 0;
    int hide_ = 0;
    int vectorX_ = 0; // the keys of vectors
    int vectorY_ = 0;
    int hiddenX_ = 0;
    int hiddenY_ = 0;
    int readVectorMeta_ = 0;
    int reading_ = 0;
    int inside_ = 0;
    int ffi_ = 0;
    int counted_ = 0;   // a function that shares the counter
    int counterAt_ = 0; // the place of the counter among its upvalues
    bool plainGlobals_ = false;
    bool filled_ = false;
    // Of the frame's turns so far:
    double budget_ = 0;
    double left_ = 0; // of the budget, at the end of the last turn
    std::uint64_t spent_ = 0;
    std::size_t mostAllocated_ = 0; // bytes
    std::size_t allocated_ = 0;
    CallBudget calls_;
    std::uint32_t creations_ = 0;
    std::uint32_t logged_ = 0;
    std::string stopped_; // why a limit ended the turn; empty: none has
    bool counting_ = false;
    bool keepsGarbage_ = false;    // for the rest of the turn
    lua_State* running_ = nullptr; // of an untrusted script: its thread
    std::string refusedAt_;        // where memory was refused
    bool refusedDeep_ = false;     // with very many calls under way
    std::string refusedCalls_;     // the innermost of these
    ScriptError error_;            // of the run under way: filled by its message handler
    std::exception_ptr kept_;      // that has ended it
};

// Errors of Lua pass through as foreign exceptions, which a handler of std::exception does not catch.
template <int (*function)(lua_State*)>
int Sandbox::guarded(lua_State* L) {
    std::exception_ptr exception;
    try {
        return function(L);
    } catch (std::exception const&) {
        exception = std::current_exception();
    }
    of(L).endBy(L, std::move(exception));
}

} // namespace trembler::lua
