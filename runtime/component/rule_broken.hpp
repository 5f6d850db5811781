// The exception for breaches of the methodology's rules that the type system cannot detect.
#pragma once

#include <stdexcept>

namespace trembler {

/// Its text names the component and the rule that it breaks.
class RuleBroken : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

} // namespace trembler
