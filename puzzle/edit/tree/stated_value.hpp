// The text of one property in a level: how it begins, and how places inside it are changed.
#pragma once

#include "puzzle/edit/document/command.hpp"
#include "runtime/world/registry.hpp"

#include <string>

namespace trembler::edit {

/// The text that a property begins with: its initial values, and required fields that any reader accepts.
[[nodiscard]] Json initialStatement(PropertyInfo const& info);
/// The statement with this name for each object that the property must name and the statement does not.
[[nodiscard]] Json withRequiredObjects(PropertyInfo const& info, Json stated, std::string const& name);
/// Sets the member at a place of a value, a JSON pointer, and makes objects that are missing on the way; null
/// removes a member. Throws CommandError for a place that there cannot be.
void setAt(Json& value, std::string const& field, Json const& to);
/// The value with one more entry, of initial values, in the list at that place. Throws CommandError if the
/// value cannot be read, or has no such list.
[[nodiscard]] Json withOneMore(PropertyInfo const& info, Json const& value, std::string const& list);
/// Throws CommandError, in the reader's words, for a value that files may not state.
void mustBeReadable(PropertyInfo const& info, Json const& value);
/// The name of a property inside a sentence.
[[nodiscard]] std::string propertyInWords(PropertyInfo const& info);

} // namespace trembler::edit
