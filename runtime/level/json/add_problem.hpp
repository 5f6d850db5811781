// Problems that are expensive to make.
#pragma once

#include "runtime/level/json/diagnostic.hpp"

#include <utility>

namespace trembler {

/// Adds the problem that make() returns. Finding its place is a walk through the file, so it is made only if
/// there is room for it; else it is counted.
template <class Make>
void addProblem(Problems& problems, Make&& make) {
    if (problems.hasRoom()) {
        problems.add(std::forward<Make>(make)());
    } else {
        problems.countOne();
    }
}

} // namespace trembler
