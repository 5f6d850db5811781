#include "runtime/level/read/read_editor.hpp"

#include "runtime/level/json/limits.hpp"

namespace trembler {
namespace {

void checkEditorNames(JsonNode const& node) {
    if (node.isList("a list of names of objects", limits::objects)) {
        for (std::size_t i = 0; i < node.size(); ++i) {
            static_cast<void>(node.element(i).name("the name of an object"));
        }
    }
}

} // namespace

nlohmann::json readEditor(JsonNode const& node) {
    MemberReader reader(node, "an object {\"groups\", \"locked\", \"hidden\"}");
    if (auto const groups = reader.optional("groups");
        groups && groups->isList("a list of groups", limits::objects)) {
        for (std::size_t i = 0; i < groups->size(); ++i) {
            checkEditorNames(groups->element(i));
        }
    }
    for (char const* const key : {"locked", "hidden"}) {
        if (auto const names = reader.optional(key)) {
            checkEditorNames(*names);
        }
    }
    reader.finish();
    return reader.valid() ? node.value() : nlohmann::json();
}

} // namespace trembler
