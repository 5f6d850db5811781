#include "insight/whatif/change.hpp"

#include <algorithm>
#include <utility>

namespace trembler::insight {
namespace {

bool concernsTheSame(Change const& a, Change const& b) {
    if (a.kind == Change::Kind::grab && b.kind == Change::Kind::grab) {
        return true; // there is one hand for it, which can hold one object
    }
    if (a.kind != b.kind || a.object != b.object) {
        return false;
    }
    switch (a.kind) {
    case Change::Kind::field:
        return a.property == b.property && a.field == b.field;
    case Change::Kind::cut:
        return a.other == b.other;
    case Change::Kind::input:
        return a.index == b.index;
    default:
        return true;
    }
}

} // namespace

void WhatIf::add(Change change) {
    if (change.kind == Change::Kind::remove) { // nothing else about it matters any more
        std::erase_if(changes, [&](Change const& each) { return each.object == change.object; });
    }
    auto const same = std::find_if(changes.begin(), changes.end(),
                                   [&](Change const& each) { return concernsTheSame(each, change); });
    if (same != changes.end()) {
        *same = std::move(change);
    } else {
        changes.push_back(std::move(change));
    }
}

} // namespace trembler::insight
