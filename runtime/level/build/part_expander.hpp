// Expands an entry that is made from a part: to one object, or to the pieces of a composite.
#pragma once

#include "runtime/level/build/made_object.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// A connection with the names of objects in the world, and the file that states it.
struct MadeConnection {
    LevelConnection connection;
    JsonDocument const* document = nullptr; ///< of a part; null: the level's
};

struct ExpandedEntry {
    std::vector<MadeObject> objects; ///< pieces by name, then joints by name; empty only after a problem
    std::size_t main = 0;            ///< the object that the entry's name refers to
    /// Names that refer to an object as well, each with a name of that object; those further inside first.
    std::vector<std::pair<std::string, std::string>> aliases;
    std::vector<MadeConnection> connections;
};

/// Owns the scopes and property sets to which the returned objects refer. They also refer to the library and
/// the entries, so all of these must outlive the objects. Not thread-safe.
class PartExpander {
public:
    /// Receives problems: the scope, the path in its file, the message, and what is expected.
    using Complain = std::function<void(StatementScope const&, std::string, std::string, std::string)>;

    PartExpander(PartLibrary const& library, Complain complain);

    /// The objects that an entry becomes whose names refer to `scope`. `form` is that of its properties:
    /// entry or placement.
    [[nodiscard]] ExpandedEntry expand(LevelObject const& entry, StatementScope const& scope,
                                       StatedProperties::Form form = StatedProperties::Form::entry);

private:
    /// Properties for the piece with that name inside the object at hand, or, without a name, for the object.
    struct Override {
        std::string piece;
        StatedProperties stated;
    };
    /// One object to be made, in the frame around it.
    struct Task {
        LevelObject const& entry;
        std::string name;
        StatementScope const& scope;
        StatedProperties::Form form;
        PieceFrame outer;
        bool isPiece;
        PartDefinition const* represents; ///< see MadeObject::part
        std::vector<Override> overrides;
    };

    void add(Task task, ExpandedEntry& into);
    void addSingle(Task const& task, PartDefinition const* part, ExpandedEntry& into);
    void addComposite(Task const& task, PartDefinition const& part, ExpandedEntry& into);
    void addJoints(Task const& task, PartDefinition const& part, StatementScope const& inside,
                   PieceFrame const& frame, ExpandedEntry& into);
    /// The overrides that a composite passes to each of its pieces, by index in PartDefinition::objects.
    [[nodiscard]] std::vector<std::vector<Override>> passedOn(Task const& task, PartDefinition const& part,
                                                              StatementScope const& inside,
                                                              PieceFrame const& frame);
    [[nodiscard]] bool mayEnter(Task const& task, PartDefinition const& part, ExpandedEntry const& into);
    [[nodiscard]] StatementScope const& scopeOf(PartDefinition const& part);

    PartLibrary const& library_;
    Complain complain_;
    std::deque<StatementScope> scopes_;
    std::map<PartDefinition const*, StatementScope const*> ofParts_; ///< never iterated over
    std::vector<PartDefinition const*> around_;                      ///< the composites being expanded
    PropertySet centre_; ///< where a piece lies that does not state its place
};

} // namespace trembler
