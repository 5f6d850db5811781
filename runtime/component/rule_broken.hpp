// What is thrown where the methodology's rules are broken in a way that types alone cannot see.
#pragma once

#include <stdexcept>

namespace trembler {

/// Names what breaks the rule, and which one.
class RuleBroken : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

} // namespace trembler
