// Adding problems that are expensive to describe.
#pragma once

#include "runtime/level/json/diagnostic.hpp"

#include <utility>

namespace trembler {

template <class Make>
void addProblem(Problems& problems, Make&& make) {
    if (problems.hasRoom()) {
        problems.add(std::forward<Make>(make)());
    } else {
        ++problems.count_;
    }
}

} // namespace trembler
