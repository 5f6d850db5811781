// The exception for breaches of the methodology's rules that the type system cannot detect.
#pragma once

#include <stdexcept>

namespace trembler {

/// The text names the component and the broken rule.
class RuleBroken : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

} // namespace trembler
