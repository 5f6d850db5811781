#include "puzzle/edit/document/tree_patch.hpp"

#include <algorithm>

namespace trembler::edit {
namespace {

Json& childAt(Json& tree, std::size_t position) {
    return tree.is_array() ? tree[position] : tree.get_ref<Json::object_t&>().data()[position].second;
}

Json& nodeAt(Json& tree, std::vector<std::size_t> const& path) {
    Json* node = &tree;
    for (std::size_t const position : path) {
        node = &childAt(*node, position);
    }
    return *node;
}

/// Members `first` to `first + count` of an object.
Json membersOf(Json const& object, std::size_t first, std::size_t count) {
    Json some = Json::object();
    auto const& all = object.get_ref<Json::object_t const&>();
    auto& members = some.get_ref<Json::object_t&>();
    for (std::size_t i = first; i < first + count; ++i) {
        members.push_back(all.data()[i]);
    }
    return some;
}

Json entriesOf(Json const& list, std::size_t first, std::size_t count) {
    Json some = Json::array();
    for (std::size_t i = first; i < first + count; ++i) {
        some.push_back(list[i]);
    }
    return some;
}

/// Whether both are equal; if so, the numbers of `after` get the type that those of `before` have.
bool takeSpelling(Json const& before, Json& after) {
    if (before != after) {
        return false;
    }
    if (before.is_number()) {
        after = before;
    }
    for (std::size_t i = 0; before.is_structured() && i < before.size(); ++i) {
        if (before.is_array()) {
            takeSpelling(before[i], after[i]);
        } else {
            takeSpelling(before.get_ref<Json::object_t const&>().data()[i].second, childAt(after, i));
        }
    }
    return true;
}

std::size_t bytesOf(std::string const& text) {
    return sizeof text + (text.capacity() > std::string().capacity() ? text.capacity() + 1 : 0);
}

/// The memory of a tree.
std::size_t bytesOf(Json const& tree) {
    std::size_t bytes = sizeof tree;
    if (tree.is_string()) {
        return bytes + bytesOf(tree.get_ref<std::string const&>());
    }
    if (tree.is_array()) {
        auto const& list = tree.get_ref<Json::array_t const&>();
        bytes += sizeof list + (list.capacity() - list.size()) * sizeof tree;
        for (Json const& entry : list) {
            bytes += bytesOf(entry);
        }
    } else if (tree.is_object()) {
        auto const& members = tree.get_ref<Json::object_t const&>();
        bytes += sizeof members + (members.capacity() - members.size()) * sizeof members.front();
        for (auto const& [key, value] : members) {
            bytes += bytesOf(key) + bytesOf(value);
        }
    }
    return bytes;
}

/// Puts `there` in the place of `count` entries.
void splice(Json& node, std::size_t first, std::size_t count, Json const& there) {
    if (node.is_array()) {
        auto& list = node.get_ref<Json::array_t&>();
        auto const at = list.begin() + static_cast<std::ptrdiff_t>(first);
        auto const rest = list.erase(at, at + static_cast<std::ptrdiff_t>(count));
        auto const& entries = there.get_ref<Json::array_t const&>();
        list.insert(rest, entries.begin(), entries.end());
        return;
    }
    // Keys are constant, so members cannot be moved along; the object is made again.
    auto& old = node.get_ref<Json::object_t&>();
    Json::object_t made;
    made.reserve(old.size() - count + there.size());
    auto const addMembers = [&] {
        for (auto const& member : there.get_ref<Json::object_t const&>()) {
            made.push_back(member);
        }
    };
    for (std::size_t i = 0; i < old.size(); ++i) {
        if (i == first) {
            addMembers();
        }
        if (i < first || i >= first + count) {
            made.push_back({old.data()[i].first, std::move(old.data()[i].second)});
        }
    }
    if (first >= old.size()) {
        addMembers();
    }
    node = Json(std::move(made));
}

} // namespace

TreePatch TreePatch::between(Json const& before, Json& after) {
    TreePatch patch;
    Path path;
    patch.compare(path, before, after);
    return patch;
}

void TreePatch::compare(Path& path, Json const& before, Json& after) {
    auto const inside = [&](std::size_t position, Json const& a, Json& b) {
        path.push_back(position);
        compare(path, a, b);
        path.pop_back();
    };
    if (before.is_array() && after.is_array()) {
        if (before.size() == after.size()) {
            for (std::size_t i = 0; i < before.size(); ++i) {
                inside(i, before[i], after[i]);
            }
            return;
        }
        std::size_t const shorter = std::min(before.size(), after.size());
        std::size_t head = 0;
        while (head < shorter && takeSpelling(before[head], after[head])) {
            ++head;
        }
        std::size_t tail = 0;
        while (tail < shorter - head &&
               takeSpelling(before[before.size() - 1 - tail], after[after.size() - 1 - tail])) {
            ++tail;
        }
        changes_.emplace_back(Entries{path, head, entriesOf(before, head, before.size() - head - tail),
                                      entriesOf(after, head, after.size() - head - tail)});
        return;
    }
    if (before.is_object() && after.is_object()) {
        auto const& a = before.get_ref<Json::object_t const&>();
        auto& b = after.get_ref<Json::object_t&>();
        std::size_t const shorter = std::min(a.size(), b.size());
        std::size_t head = 0;
        while (head < shorter && a.data()[head].first == b.data()[head].first) {
            inside(head, a.data()[head].second, b.data()[head].second);
            ++head;
        }
        std::size_t tail = 0;
        while (tail < shorter - head &&
               a.data()[a.size() - 1 - tail].first == b.data()[b.size() - 1 - tail].first) {
            inside(a.size() - 1 - tail, a.data()[a.size() - 1 - tail].second,
                   b.data()[b.size() - 1 - tail].second);
            ++tail;
        }
        if (head + tail < a.size() || head + tail < b.size()) {
            changes_.emplace_back(Entries{path, head, membersOf(before, head, a.size() - head - tail),
                                          membersOf(after, head, b.size() - head - tail)});
        }
        return;
    }
    if (!takeSpelling(before, after)) {
        changes_.emplace_back(Value{path, before, after});
    }
}

std::size_t TreePatch::bytes() const {
    std::size_t bytes = sizeof *this + changes_.capacity() * sizeof(Change);
    for (Change const& change : changes_) {
        bytes += std::visit(
            [](auto const& one) {
                return one.path.capacity() * sizeof one.path.front() + bytesOf(one.before) +
                       bytesOf(one.after);
            },
            change);
    }
    return bytes;
}

void TreePatch::apply(Json& tree) const {
    for (Change const& change : changes_) {
        if (auto const* const value = std::get_if<Value>(&change)) {
            nodeAt(tree, value->path) = value->after;
        } else {
            auto const& entries = std::get<Entries>(change);
            splice(nodeAt(tree, entries.path), entries.first, entries.before.size(), entries.after);
        }
    }
}

void TreePatch::revert(Json& tree) const {
    for (auto change = changes_.rbegin(); change != changes_.rend(); ++change) {
        if (auto const* const value = std::get_if<Value>(&*change)) {
            nodeAt(tree, value->path) = value->before;
        } else {
            auto const& entries = std::get<Entries>(*change);
            splice(nodeAt(tree, entries.path), entries.first, entries.after.size(), entries.before);
        }
    }
}

} // namespace trembler::edit
