#include "puzzle/edit/text/text_merge.hpp"

#include "puzzle/edit/text/lay_out.hpp"

#include <algorithm>
#include <map>

namespace trembler::edit {
namespace {

using OrderedTree = nlohmann::ordered_json;

/// The text by which an entry of a list is recognised although its contents change; empty: there is none.
std::string identityOf(OrderedTree const& entry) {
    if (entry.is_object()) {
        for (char const* const key : {"name", "part", "id"}) {
            if (auto const found = entry.find(key); found != entry.end() && found->is_string()) {
                return std::string(key) + ":" + found->get<std::string>();
            }
        }
    }
    return {};
}

/// Takes the first unused entry of the old list under a key.
class EntryIndex {
public:
    void add(std::string const& key, std::size_t index) { entries_.emplace(key, index); }
    [[nodiscard]] std::size_t take(std::string const& key, std::vector<bool>& used) {
        auto [at, end] = entries_.equal_range(key);
        for (; at != end; at = entries_.erase(at)) {
            if (!used[at->second]) {
                used[at->second] = true;
                return at->second;
            }
        }
        return noEntry;
    }

private:
    std::multimap<std::string, std::size_t> entries_;
};

/// A new entry does not repeat the blank line that sets a group apart.
std::string_view withoutBlankLine(std::string_view lead) {
    return std::count(lead.begin(), lead.end(), '\n') > 1 ? lead.substr(lead.rfind('\n')) : lead;
}

} // namespace

std::vector<std::size_t> matchedEntries(OrderedTree const& now, OrderedTree const& old) {
    std::vector<std::size_t> matched(now.size(), noEntry);
    std::vector<bool> used(old.size(), false);
    std::size_t const shorter = std::min(now.size(), old.size());
    std::size_t head = 0;
    for (; head < shorter && now[head] == old[head]; ++head) {
        matched[head] = head;
    }
    std::size_t tail = 0;
    for (; tail < shorter - head && now[now.size() - 1 - tail] == old[old.size() - 1 - tail]; ++tail) {
        matched[now.size() - 1 - tail] = old.size() - 1 - tail;
    }
    EntryIndex equal;
    EntryIndex alike;
    for (std::size_t i = head; i < old.size() - tail; ++i) {
        equal.add(old[i].dump(-1, ' ', false, OrderedTree::error_handler_t::replace), i);
        if (std::string const identity = identityOf(old[i]); !identity.empty()) {
            alike.add(identity, i);
        }
    }
    for (std::size_t i = head; i < now.size() - tail; ++i) {
        matched[i] = equal.take(now[i].dump(-1, ' ', false, OrderedTree::error_handler_t::replace), used);
    }
    for (std::size_t i = head; i < now.size() - tail; ++i) {
        if (std::string const identity = identityOf(now[i]); matched[i] == noEntry && !identity.empty()) {
            matched[i] = alike.take(identity, used);
        }
    }
    for (std::size_t i = head; now.size() == old.size() && i < now.size() - tail; ++i) {
        if (matched[i] == noEntry && !used[i]) {
            used[i] = true;
            matched[i] = i;
        }
    }
    return matched;
}

std::string TextMerge::textOf(OrderedTree const& tree) {
    if (source_.text_.empty()) {
        return layOutFile(tree);
    }
    add(of(0, source_.root_.begin));
    write(tree, source_.tree_, source_.root_);
    add(of(source_.root_.end, source_.text_.size()));
    return std::move(out_);
}

void TextMerge::write(OrderedTree const& value, OrderedTree const& old, Node const& node) {
    if (value == old) {
        add(of(node.begin, node.end));
        return;
    }
    bool const objects = value.is_object() && old.is_object();
    bool const lists = value.is_array() && old.is_array();
    if ((!objects && !lists) || value.empty() || old.empty()) {
        writeNew(value);
        return;
    }
    std::size_t const begin = out_.size();
    std::size_t const indentHere = indent();
    std::size_t const columnHere = column();
    std::string_view const outer = lastLead_;
    lastLead_ = {};
    if (objects) {
        writeMembers(value, old, node);
    } else {
        writeEntries(value, old, node);
    }
    lastLead_ = outer;
    narrow(value, node, begin, indentHere, columnHere);
}

void TextMerge::writeMembers(OrderedTree const& value, OrderedTree const& old, Node const& node) {
    std::map<std::string_view, std::size_t> places; // of the old members
    std::vector<OrderedTree const*> values;
    for (auto const& [key, member] : old.get_ref<OrderedTree::object_t const&>()) {
        places.emplace(key, values.size());
        values.push_back(&member);
    }
    add("{");
    bool first = true;
    for (auto const& [key, member] : value.get_ref<OrderedTree::object_t const&>()) {
        add(first ? "" : ",");
        auto const at = places.find(key);
        Node const* const entry = at == places.end() ? nullptr : &node.children[at->second];
        writeLead(node, entry, first);
        if (entry != nullptr) {
            add(of(entry->key, entry->begin));
            write(member, *values[at->second], *entry);
        } else {
            add(inOneLine(OrderedTree(key)) + ": ");
            writeNew(member);
        }
        first = false;
    }
    add(of(node.children.back().end, node.end - 1));
    add("}");
}

void TextMerge::writeEntries(OrderedTree const& value, OrderedTree const& old, Node const& node) {
    std::vector<std::size_t> const matched = matchedEntries(value, old);
    add("[");
    for (std::size_t i = 0; i < value.size(); ++i) {
        add(i == 0 ? "" : ",");
        Node const* const entry = matched[i] == noEntry ? nullptr : &node.children[matched[i]];
        writeLead(node, entry, i == 0);
        if (entry != nullptr) {
            write(value[i], old[matched[i]], *entry);
        } else {
            writeNew(value[i]);
        }
    }
    add(of(node.children.back().end, node.end - 1));
    add("]");
}

void TextMerge::writeLead(Node const& around, Node const* entry, bool first) {
    Node const& firstOld = around.children.front();
    std::string_view const firstLead = of(firstOld.lead, firstOld.key);
    if (first) {
        add(firstLead);
        return;
    }
    std::string_view lead;
    if (entry != nullptr && entry != &firstOld) {
        lead = of(entry->lead, entry->key);
    } else if (!lastLead_.empty()) {
        lead = lastLead_;
    } else if (around.children.size() > 1) {
        lead = withoutBlankLine(of(around.children[1].lead, around.children[1].key));
    } else {
        lead = firstLead.find('\n') == std::string_view::npos ? std::string_view(" ") : firstLead;
    }
    add(lead);
    lastLead_ = withoutBlankLine(lead);
}

void TextMerge::writeNew(OrderedTree const& value) {
    add(layOut(value, indent(), column()));
}

void TextMerge::narrow(OrderedTree const& value, Node const& node, std::size_t begin, std::size_t indentHere,
                       std::size_t columnHere) {
    bool const wasLine = of(node.begin, node.end).find('\n') == std::string_view::npos;
    bool const grew = out_.size() - begin > node.end - node.begin;
    if (!wasLine || !grew || lineStart_ > begin || column() <= widestLine) {
        return;
    }
    out_.resize(begin);
    add(layOut(value, indentHere, columnHere));
}

void TextMerge::add(std::string_view text) {
    out_ += text;
    if (std::size_t const line = text.rfind('\n'); line != std::string_view::npos) {
        lineStart_ = out_.size() - text.size() + line + 1;
    }
}

std::string_view TextMerge::of(std::size_t begin, std::size_t end) const {
    return std::string_view(source_.text_).substr(begin, end - begin);
}

std::size_t TextMerge::indent() const {
    std::size_t const found = out_.find_first_not_of(' ', lineStart_);
    return (found == std::string::npos ? out_.size() : found) - lineStart_;
}

} // namespace trembler::edit
