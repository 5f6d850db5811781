#include "game/ui/shared/catalog/part_catalog.hpp"

#include "game/ui/shared/texts.hpp"
#include "puzzle/data/part_groups.hpp"
#include "render/panels/toolbox_tile.hpp"
#include "render/scene/objects/part.hpp"

#include <algorithm>
#include <cctype>

namespace trembler::ui {

std::string PartCatalog::titleOf(std::string const& part) const {
    PartDefinition const* const found = parts_.find(part);
    std::string title = found == nullptr || found->title.empty()
                            ? part
                            : titleIn(found->texts, std::string(languageInUse()), found->title);
    if (!title.empty()) {
        title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    }
    return title;
}

std::string PartCatalog::textOf(std::string const& part) const {
    PartDefinition const* const found = parts_.find(part);
    return found == nullptr ? std::string() : textIn(found->texts, std::string(languageInUse()), found->text);
}

std::vector<PartGroup> const& PartCatalog::groupsOf(std::string const& part) {
    auto const known = groups_.find(part);
    return known != groups_.end() ? known->second
                                  : groups_.emplace(part, trembler::groupsOf(parts_, part)).first->second;
}

Prototype const* PartCatalog::prototype(std::string const& part) {
    if (auto const known = prototypes_.find(part); known != prototypes_.end()) {
        return &known->second;
    }
    PartDefinition const* const found = parts_.find(part);
    return found == nullptr ? nullptr : &prototypes_.emplace(part, found->prototype()).first->second;
}

unsigned PartCatalog::picture(std::string const& part, int pixels) {
    Prototype const* const known = prototype(part);
    if (known == nullptr || pixels <= 0) {
        return 0;
    }
    Picture& made = pictures_[part];
    if (made.pixels != pixels || made.colours != render::palette::inUse()) {
        made.colours = render::palette::inUse();
        made.target = std::make_unique<render::Framebuffer>(render::Size{pixels, pixels});
        made.pixels = pixels;
        made.target->bind();
        render::clearBound(render::tileGround());
        Placement const lying = render::placementOnTile(parts_, part);
        render::Extent const extent = render::extentOnTile(parts_, lying);
        render::Camera camera{{}, 100, {pixels, pixels}};
        if (!extent.empty()) {
            camera.fit(extent.lower, extent.upper, 0.10 * pixels);
        }
        canvas_.begin(camera, {.uiScale = static_cast<float>(pixels) / 80.F});
        render::drawPartOnTile(canvas_, parts_, lying);
        canvas_.end();
    }
    return made.target->texture();
}

double PartCatalog::radius(std::string const& part) {
    render::Extent const extent = render::extentOfPart(parts_, {part, {}, 0, ""});
    return extent.empty() ? 0.0 : std::max(length(extent.lower), length(extent.upper));
}

} // namespace trembler::ui
