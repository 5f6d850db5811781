// The thesis's notation boxes (5.3 to 5.6) as rows of words, before they are laid out as text or Markdown.
#pragma once

#include "runtime/world/registry.hpp"

#include <span>
#include <string>
#include <vector>

namespace trembler {

struct NotationRow {
    std::string label; ///< empty: the row is all text
    std::string text;
};

struct NotationBox {
    std::string title;
    std::vector<NotationRow> rows;
    std::span<CallInfo const> calls{};
};

/// All properties that a component reads: first the properties that it also writes, then the properties that
/// it only reads.
[[nodiscard]] std::vector<PropertyInfo const*> allRead(ComponentInfo const& info);
/// Names in braces, or the empty set.
[[nodiscard]] std::string propertySet(std::vector<PropertyInfo const*> const& properties);

/// A component. If a resolver writes exactly the properties that it reads, the box states this as the thesis
/// does: "≡ read(...)".
[[nodiscard]] NotationBox boxOf(Registry const& registry, ComponentInfo const& info);
[[nodiscard]] NotationBox boxOf(CompletionInfo const& info);
/// A property (5.3): its meaning and its fields.
[[nodiscard]] NotationBox boxOf(PropertyInfo const& info);

/// The objects of a scene that need a component, in words.
[[nodiscard]] std::string activation(ComponentInfo const& info);
/// The derived property sets in which an interaction runs (5.7.3), in words; empty if there are none.
[[nodiscard]] std::string shortcutNote(Registry const& registry, ComponentInfo const& info);

} // namespace trembler
