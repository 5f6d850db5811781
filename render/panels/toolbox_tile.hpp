// One compartment of the toolbox: a part's picture, its name and how many are left.
#pragma once

#include "render/draw/colour.hpp"

namespace trembler::render {

struct ToolboxTile {
    char const* id = "";
    char const* name = "";
    int count = -1;       ///< how many are left; negative for any number
    unsigned picture = 0; ///< an OpenGL texture, bottom row first (Framebuffer::texture); 0 for none
    bool selected = false;
    float side = 92.F; ///< of the picture's field, pixels at UI scale 1
    float width = 0.F; ///< of the whole tile, at least `side`; 0: the same
};

/// The player's actions on a tile. `taken` is true in the frame in which the mouse button is pressed on it,
/// so that a part can be dragged straight out into the world; a tile with none left is never taken.
struct TileUse {
    bool hovered = false;
    bool taken = false;
};

/// Inside a card. Draws the tile at the cursor.
TileUse toolboxTile(ToolboxTile const& tile);

/// The colour behind a tile's picture: clear the Framebuffer with it.
[[nodiscard]] Colour tileGround();

} // namespace trembler::render
