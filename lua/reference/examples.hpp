// The examples of the reference: each is a script that works.
#pragma once

#include "lua/reference/reference.hpp"

#include <string>

namespace trembler::lua {

/// The script that shows a function: one that was written for it, otherwise one made from its description.
[[nodiscard]] std::string functionExample(ReferenceFunction const& function);

/// Statements that read every field of a property, made from its description.
[[nodiscard]] std::string propertyExampleBody(ReferenceProperty const& property);
/// The script around property.body.
[[nodiscard]] std::string propertyExample(ReferenceProperty const& property);

} // namespace trembler::lua
