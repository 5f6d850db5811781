#include "runtime/component/info.hpp"

namespace trembler {

std::string_view nameOf(ComponentKind kind) {
    switch (kind) {
    case ComponentKind::resolver:
        return "resolver";
    case ComponentKind::dps:
        return "dps";
    case ComponentKind::interaction:
        return "interaction";
    }
    return "";
}

std::string title(ComponentInfo const& info) {
    std::string const name(info.text.name);
    switch (info.kind) {
    case ComponentKind::resolver:
        return name + " Resolver";
    case ComponentKind::dps:
        return name + " DPS";
    case ComponentKind::interaction:
        return "(" + name + ") Interaction";
    }
    return name;
}

} // namespace trembler
