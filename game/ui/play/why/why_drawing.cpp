#include "game/ui/play/why/why_drawing.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/world_label.hpp"
#include "render/scene/facts/shape_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Lack;
using insight::Miss;
using insight::Proof;

// Pixels at UI scale 1.
constexpr double ringOfStep = 15;
constexpr double ringOfMiss = 8;
constexpr double dash = 9;
constexpr double besideRing = 24;

/// Steps that happened so close to each other that they share a ring.
struct Spot {
    Point at;
    std::vector<std::size_t> steps;
};

/// `reach`: m.
std::vector<Spot> spotsOf(insight::Answer const& answer, double reach) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        if (answer.chain[i].step.objects.empty()) {
            continue; // it is nowhere
        }
        Point const at = toPoint(answer.chain[i].at);
        auto const near = std::find_if(spots.begin(), spots.end(),
                                       [&](Spot const& spot) { return length(spot.at - at) < reach; });
        if (near == spots.end()) {
            spots.push_back({at, {i}});
        } else {
            near->steps.push_back(i);
        }
    }
    return spots;
}

Spot const* spotOf(std::vector<Spot> const& spots, std::size_t step) {
    auto const at = std::find_if(spots.begin(), spots.end(), [step](Spot const& spot) {
        return std::find(spot.steps.begin(), spot.steps.end(), step) != spot.steps.end();
    });
    return at == spots.end() ? nullptr : &*at;
}

bool isChosen(Spot const& spot, WhyPanel const& panel) {
    return panel.step() && std::find(spot.steps.begin(), spot.steps.end(), *panel.step()) != spot.steps.end();
}

void drawChain(Canvas& canvas, WhyPanel const& panel) {
    insight::Answer const& answer = *panel.answer();
    double const ring = canvas.metres(ringOfStep);
    std::vector<Spot> const spots = spotsOf(answer, 2 * ring);
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        Spot const* const to = spotOf(spots, i);
        for (std::size_t const cause : answer.chain[i].step.because) {
            Spot const* const from = spotOf(spots, cause);
            if (from == nullptr || to == nullptr || from == to) {
                continue;
            }
            Point const way = (1 / length(to->at - from->at)) * (to->at - from->at);
            canvas.arrow(from->at + ring * way, to->at - ring * way,
                         {.colour = palette::accent, .pixels = 3, .outline = 1, .alpha = 0.85F});
        }
    }
    for (Spot const& spot : spots) {
        bool const chosen = isChosen(spot, panel);
        bool const sure = std::any_of(spot.steps.begin(), spot.steps.end(), [&](std::size_t step) {
            return answer.chain[step].proof != Proof::traced;
        });
        canvas.ring(spot.at, ring * (chosen ? 1.25 : 1),
                    {.colour = sure ? palette::accent : palette::inkSoft,
                     .pixels = chosen ? 5.F : 3.F,
                     .outline = 1});
    }
}

void drawDashed(Canvas& canvas, Point from, Point to) {
    double const all = length(to - from);
    double const step = canvas.metres(dash);
    if (all < 1e-9) {
        return;
    }
    Point const way = (1 / all) * (to - from);
    for (double at = 0; at < all; at += 2 * step) {
        canvas.line(from + at * way, from + std::min(at + step, all) * way,
                    {.colour = palette::warning, .pixels = 3, .outline = 1});
    }
}

/// Calls f(from, to, width) for each gap and each distance of a miss, at its moment: `frame`.
template <class F>
void forEachLack(Miss const& miss, std::uint64_t frame, F&& f) {
    if (miss.lack == Lack::distance) {
        f(toPoint(miss.from), toPoint(miss.to), miss.by);
    }
    for (insight::CircuitGap const& gap : miss.gaps) {
        if (gap.reason != insight::GapReason::apart) {
            continue; // no touch is missing there
        }
        f(toPoint(gap.from), toPoint(gap.to), gap.width);
    }
    for (Miss const& other : miss.besides) {
        if (other.frame == 0 || other.frame == frame) { // else it was elsewhere then
            forEachLack(other, frame, f);
        }
    }
}

Miss const* missOf(WhyPanel const& panel) {
    insight::Answer const* const answer = panel.answer();
    return answer != nullptr && !answer->happened && answer->nearest ? &answer->nearest->nearest : nullptr;
}

bool hasChain(WhyPanel const& panel) {
    return panel.open() && panel.answer() != nullptr && panel.answer()->happened;
}

} // namespace

std::vector<ObjectId> objectsOfStep(WhyPanel const& panel, World const& world) {
    std::vector<std::string> names;
    if (hasChain(panel) && panel.step()) {
        names = panel.answer()->chain[*panel.step()].step.objects;
    } else if (Miss const* const miss = missOf(panel); panel.open() && miss != nullptr) {
        names = miss->names;
    }
    std::vector<ObjectId> objects;
    for (std::string const& name : names) {
        if (ObjectId const object = world.store().find(name); object.valid()) {
            objects.push_back(object);
        }
    }
    return objects;
}

std::vector<Extent> gapsOfMiss(WhyPanel const& panel) {
    std::vector<Extent> gaps;
    if (Miss const* const miss = missOf(panel); panel.open() && miss != nullptr) {
        forEachLack(*miss, miss->frame, [&](Point from, Point to, double) {
            Extent gap;
            gap.add(from);
            gap.add(to);
            gaps.push_back(gap);
        });
    }
    return gaps;
}

void drawWhy(Canvas& canvas, WhyPanel const& panel) {
    if (hasChain(panel)) {
        drawChain(canvas, panel);
    } else if (Miss const* const miss = missOf(panel); panel.open() && miss != nullptr) {
        forEachLack(*miss, miss->frame, [&](Point from, Point to, double) {
            drawDashed(canvas, from, to);
            for (Point const end : {from, to}) {
                canvas.ring(end, canvas.metres(ringOfMiss),
                            {.colour = palette::warning, .pixels = 3, .outline = 1});
            }
        });
    }
}

void drawWhyWords(Camera const& camera, double uiScale, WhyPanel const& panel) {
    if (hasChain(panel)) {
        double const ring = ringOfStep * uiScale / camera.pixelsPerMetre;
        for (Spot const& spot : spotsOf(*panel.answer(), 2 * ring)) {
            std::string numbers;
            for (std::size_t const step : spot.steps) {
                numbers += (numbers.empty() ? "" : ", ") + std::to_string(step + 1);
            }
            worldLabel(camera, spot.at, numbers.c_str(),
                       {.look = LabelLook::Chip,
                        .colour = palette::accentDeep,
                        .below = -static_cast<float>(besideRing + 4)});
        }
    } else if (Miss const* const miss = missOf(panel); panel.open() && miss != nullptr) {
        insight::AnswerLanguage const language = answerLanguageInUse();
        forEachLack(*miss, miss->frame, [&](Point from, Point to, double width) {
            worldLabel(camera, 0.5 * (from + to), language.distance(width).c_str(),
                       {.look = LabelLook::Chip,
                        .colour = palette::warning,
                        .below = static_cast<float>(besideRing)});
        });
    }
}

} // namespace trembler::ui
