#include "runtime/level/build/check_composites.hpp"

#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/build/references.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/world/store.hpp"

#include <fmt/format.h>

#include <set>
#include <tuple>
#include <utility>

namespace trembler {
namespace {

/// The places and messages of problems that have been reported: several parts may consist of a wrong one.
using Reported = std::set<std::tuple<std::string, std::string, std::string>>;

/// The problems of one part.
class CompositeCheck {
public:
    CompositeCheck(PartLibrary const& library, PartDefinition const& part, Reported& reported,
                   Problems& problems)
        : library_(library), part_(part), reported_(reported), problems_(problems) {}

    void check() {
        PartExpander expander(library_, [this](StatementScope const& scope, std::string path,
                                               std::string message, std::string expected) {
            complain(scope.document, std::move(path), std::move(message), std::move(expected));
        });
        LevelObject entry;
        entry.name = part_.name;
        entry.part = part_.name;
        StatementScope const nowhere;
        ExpandedEntry const expanded = expander.expand(entry, nowhere);
        if (found_) {
            return; // pieces are missing: nothing can be said about references to them
        }
        Store store;
        for (MadeObject const& made : expanded.objects) {
            if (store.find(made.name).valid()) {
                complain(part_.document.get(), "/objects",
                         fmt::format("two pieces are named '{}'", made.name), "pieces with different names");
            } else {
                static_cast<void>(store.create(made.name));
            }
        }
        for (auto const& [name, piece] : expanded.aliases) {
            store.alias(name, store.find(piece));
        }
        for (MadeObject const& made : expanded.objects) {
            checkReferences(made, store);
        }
        for (MadeConnection const& made : expanded.connections) {
            for (std::string const* const name : {&made.connection.a, &made.connection.b}) {
                if (!store.find(*name).valid()) {
                    complainAboutName(made.document, made.connection.path,
                                      name->substr(part_.name.size() + 1));
                }
            }
        }
    }

private:
    void checkReferences(MadeObject const& made, Store const& store) {
        for (StatedProperties const& stated : made.stated) {
            for (PropertySet::Entry const& entry : stated.set->entries()) {
                if (!entry.value || stated.scope->names == nullptr || !stated.states(*entry.info)) {
                    continue;
                }
                auto const value = entry.value->clone();
                for (DanglingReference const& dangling :
                     resolveReferences(*value, *stated.scope->names, store, stated.scope->prefix)) {
                    complainAboutName(stated.scope->document, stated.path, dangling.name);
                }
            }
        }
    }

    /// Only in the part's own file: the parts of its pieces are checked themselves.
    void complainAboutName(JsonDocument const* document, std::string path, std::string const& name) {
        if (document != part_.document.get()) {
            return;
        }
        std::vector<std::string> names;
        for (LevelObject const& piece : part_.objects) {
            names.push_back(piece.name);
        }
        complain(document, std::move(path),
                 fmt::format("there is no piece '{}'{}", name, didYouMean(name, names)), listed(names));
    }

    void complain(JsonDocument const* document, std::string path, std::string message, std::string expected) {
        found_ = true;
        if (document != nullptr && reported_.emplace(document->file(), path, message).second) {
            problems_.add(document->diagnostic(std::move(path), std::move(message), std::move(expected)));
        }
    }

    PartLibrary const& library_;
    PartDefinition const& part_;
    Reported& reported_;
    Problems& problems_;
    bool found_ = false;
};

} // namespace

void checkComposites(PartLibrary const& library) {
    Problems problems;
    Reported reported;
    for (PartDefinition const* const part : library.all()) {
        if (part->composite()) {
            CompositeCheck(library, *part, reported, problems).check();
        }
    }
    problems.throwIfAny();
}

} // namespace trembler
