#include "runtime/world/prototype.hpp"

namespace trembler {

std::uint32_t PrototypeLibrary::add(Prototype prototype) {
    auto const [at, isNew] = numbers_.try_emplace(prototype.name, static_cast<std::uint32_t>(all_.size()));
    if (isNew) {
        all_.push_back(std::move(prototype));
    } else {
        all_[at->second] = std::move(prototype);
    }
    return at->second;
}

std::uint32_t PrototypeLibrary::numberOf(std::string const& name) const {
    auto const at = numbers_.find(name);
    return at == numbers_.end() ? unknown : at->second;
}

} // namespace trembler
