#include "runtime/component/call.hpp"

namespace trembler {

std::string_view nameOf(Algebra a) {
    switch (a) {
    case Algebra::sumOfRates:
        return "sum, held";
    case Algebra::sumOfAmounts:
        return "sum, once";
    case Algebra::anyOf:
        return "or, held";
    case Algebra::least:
        return "min, held";
    case Algebra::greatest:
        return "max, held";
    case Algebra::countedSet:
        return "counted set";
    case Algebra::create:
        return "unique create";
    case Algebra::destroy:
        return "unique destroy";
    case Algebra::sequence:
        return "sequence, from outside";
    }
    return "";
}

} // namespace trembler
