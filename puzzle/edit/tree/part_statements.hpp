// The statements of parts about the objects made from them: about one object, or the pieces of a composite.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "puzzle/edit/tree/references.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trembler::edit {

/// One of the objects of which a composite part consists.
struct PartPiece {
    std::string name;  ///< as "pieces" of an entry states it: "coil", "lamp holder bulb"
    bool main = false; ///< the one that "properties" of an entry are about
};

/// Looks parts up, and keeps the pieces of composites: make one for a question about many objects. Not
/// thread-safe.
class PartStatements {
public:
    /// `data` must outlive it.
    explicit PartStatements(GameData const& data);
    ~PartStatements();
    PartStatements(PartStatements const&) = delete;
    PartStatements& operator=(PartStatements const&) = delete;

    /// In order of their names; empty for a part of one object, and for one that does not exist.
    [[nodiscard]] std::vector<PartPiece> const& pieces(std::string const& part);
    /// The piece that a name means: its own, or that of the composite whose main piece it is. "" if the part
    /// has none of that name.
    [[nodiscard]] std::string pieceNamed(std::string const& part, std::string const& name);
    /// The endings, after an object's name, of the names of everything else that the object is: pieces,
    /// composites among them, and joints.
    [[nodiscard]] std::vector<std::string> const& namesInside(std::string const& part);
    /// The part's value of a property, as a file would state it; null if it does not have it. Of a composite:
    /// of that piece, or, if it is "", of the main one.
    [[nodiscard]] Json of(std::string const& part, std::string const& piece, PropertyInfo const& info);

private:
    struct Composite;
    /// nullptr if the part is none.
    [[nodiscard]] Composite const* find(std::string const& part);

    GameData const& data_;
    std::map<std::string, std::unique_ptr<Composite>> composites_;
};

/// Adds the new names of everything that is inside of an object which is renamed to `to`. Names that are
/// there already stay: those of entries come first.
void renameInsides(PartStatements& parts, Json const& entry, std::string const& to, NewNames& names);

/// All names by which a level may refer to objects: each entry's, followed by those of its pieces.
[[nodiscard]] std::vector<std::string> namesOfObjectsAndPieces(GameData const& data, Json const& level);

} // namespace trembler::edit
