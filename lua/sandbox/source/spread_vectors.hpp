// Vectors that a script makes only to hand them to a call of its resolver: handed over as two numbers.
#pragma once

#include "lua/sandbox/source/tokens.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::lua {

/// How apply makes calls, and which of their arguments are vectors.
struct VectorArguments {
    std::size_t parameter = 0; ///< of apply, from 1: the table of functions, which is `out` in the examples
    /// By the name of the function: for each of its arguments, whether it is a vector, which may be stated as
    /// two numbers instead.
    std::map<std::string, std::vector<bool>, std::less<>> calls;
};

/// A change of a text.
struct TextEdit {
    std::size_t position = 0; ///< in the text
    std::size_t removed = 0;  ///< bytes from there on
    std::string inserted;
};

/// The changes that make `out.addForce(object, vec2(x, y))` into `__numbers.addForce(object, (x), (y))`, by
/// ascending position: no table is made then, which takes longer than the rest of most scripts. `out` is
/// the name of that parameter; the functions of CountedSource::numbersName take two values for each vector,
/// and report values other than numbers as errors of the vector. Only where the text shows that `out` and
/// `vec2` are the host's, and that all vectors of the call stand in it like that. An error is found when all
/// arguments are evaluated, and not between them. No change crosses a line.
[[nodiscard]] std::vector<TextEdit> spreadVectors(Tokens const& tokens, std::string_view out,
                                                  VectorArguments const& arguments);

} // namespace trembler::lua
