// The examples of functions of all resolvers, in one list.
#include "lua/reference/function_examples.hpp"

#include "lua/reference/function_examples/by_resolver.hpp"

#include <vector>

namespace trembler::lua {

std::span<FunctionExample const> functionExamples() {
    static std::vector<FunctionExample> const all = [] {
        std::vector<FunctionExample> joined;
        for (std::span<FunctionExample const> const part :
             {dynamicsExamples(), fieldExamples(), electricityExamples(), soundExamples(), worldExamples()}) {
            joined.insert(joined.end(), part.begin(), part.end());
        }
        return joined;
    }();
    return all;
}

} // namespace trembler::lua
