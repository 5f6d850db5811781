#include "insight/run/variation.hpp"

#include <utility>

namespace trembler::insight {
namespace {

LeftOut leftOutAt(LeftOut::Kind kind, std::size_t index) {
    LeftOut made;
    made.kind = kind;
    made.index = index;
    return made;
}

LeftOut leftOutNamed(LeftOut::Kind kind, std::string name) {
    LeftOut made;
    made.kind = kind;
    made.a = std::move(name);
    return made;
}

} // namespace

LeftOut withoutPlacement(std::size_t index) {
    return leftOutAt(LeftOut::Kind::placement, index);
}

LeftOut withoutWire(std::size_t index) {
    return leftOutAt(LeftOut::Kind::wire, index);
}

LeftOut withoutInput(std::size_t index) {
    return leftOutAt(LeftOut::Kind::input, index);
}

LeftOut withoutContact(std::string a, std::string b, std::uint64_t from) {
    if (b < a) {
        std::swap(a, b);
    }
    LeftOut made = leftOutNamed(LeftOut::Kind::contact, std::move(a));
    made.b = std::move(b);
    made.from = from;
    return made;
}

LeftOut withoutDip(std::string object, std::string liquid, std::uint64_t from) {
    LeftOut made = leftOutNamed(LeftOut::Kind::dip, std::move(object));
    made.b = std::move(liquid);
    made.from = from;
    return made;
}

LeftOut withoutDevice(std::string object, std::uint64_t from) {
    LeftOut made = leftOutNamed(LeftOut::Kind::device, std::move(object));
    made.from = from;
    return made;
}

LeftOut withoutSwitching(std::string magnet, std::uint64_t from) {
    LeftOut made = leftOutNamed(LeftOut::Kind::switching, std::move(magnet));
    made.from = from;
    return made;
}

LeftOut withoutEffect(std::string name) {
    return leftOutNamed(LeftOut::Kind::effect, std::move(name));
}

} // namespace trembler::insight
