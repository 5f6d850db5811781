// Instructions counted in a script's text: the same count whether the text is interpreted or compiled.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace trembler::lua {

struct VectorArguments;

/// A script's text with counters put in, and the results of reading it.
///
/// LuaJIT can count instructions by itself, by a hook; but compiled code checks no hook, and in interpreted
/// code a hook costs as much as the instructions. So the text is counted: at the beginning of the body of
/// each loop and of each function, and before each goto, it takes the length of that body off a counter and
/// stops where the counter is below zero. The code that a script can run without passing such a place is
/// shorter than its text. An instruction stands for two tokens of the text; a body is counted with all its
/// branches.
struct CountedSource {
    /// A chunk that is to be called with a function, which is called where the counter is below zero. It
    /// returns the script as a function with the counter, a number, as the upvalue `counterName`. Lines are
    /// those of the script.
    std::string text;
    std::size_t chunk = 0; ///< instructions of the script's text outside of loops and functions
    /// Instructions of apply, if only the host can call that function: it has no counter in it, so the host
    /// counts them. 0: it counts by itself.
    std::size_t apply = 0;
    /// How many parameters apply then has; `anyNumber` if it takes more or the number is not known.
    std::size_t parameters = anyNumber;
    /// Whether the script may assign to fields other than those of its store. If not, tables can be shown to
    /// it as they are, without a read-only table before them. If so, every # in `text` is `lengthName ^`, so
    /// that the host gives the length of a list that is behind such a table.
    bool assignsFields = false;
    /// The names to which it assigns that may not be local variables.
    std::set<std::string, std::less<>> assigned;

    static constexpr std::size_t anyNumber = 100;
    static constexpr std::string_view counterName = "__count";
    static constexpr std::string_view stopName = "__over";
    /// The table of functions that take each vector as two numbers: see spreadVectors().
    static constexpr std::string_view numbersName = "__numbers";
    /// The left operand of ^ in place of #. No script can write it, nor ^, which binds as closely as #.
    static constexpr std::string_view lengthName = "\xE2\x80\xA4";
};

/// The fault in the order of a text's blocks, and its line.
struct BlockFault {
    std::size_t line = 0;
    std::string message;
};

/// Puts counters into a text in which faultInSource() has found no fault. If blocks are not closed or closed
/// twice, or one of the names above is used, `fault` states it and the result is not to be used. With
/// `loopsOnly`, only loops are counted: for the host's own text, whose functions do not call themselves. With
/// `vectors`, vectors that are made for a call only are handed over as two numbers (spreadVectors()) if apply
/// can only be called by the host; they count as before.
[[nodiscard]] CountedSource countSource(std::string_view text, std::optional<BlockFault>& fault,
                                        bool loopsOnly = false, VectorArguments const* vectors = nullptr);

} // namespace trembler::lua
