#include "physics/dynamics/engines/substepped/touch_record.hpp"

#include <algorithm>

namespace trembler {

void TouchRecord::change(PieceContact const& contact, int delta) {
    changes_.push_back({contact.patch.a, contact.patch.b, delta});
    if (delta < 0) {
        pressures_.end(contact.key);
    } else if (impactsWanted_) {
        pressures_.begin(contact.key);
    }
}

void TouchRecord::take(std::vector<PieceContact>& found,
                       std::function<bool(PieceContact const&)> const& rests) {
    std::sort(found.begin(), found.end(),
              [](PieceContact const& x, PieceContact const& y) { return x.key < y.key; });
    merged_.clear();
    auto old = contacts_.cbegin();
    auto const passOver = [&](std::uint64_t upTo) {
        for (; old != contacts_.cend() && old->key < upTo; ++old) {
            if (rests(*old)) {
                merged_.push_back(*old);
            } else {
                change(*old, -1);
            }
        }
    };
    for (PieceContact const& contact : found) {
        passOver(contact.key);
        if (old != contacts_.cend() && old->key == contact.key) {
            ++old;
        } else {
            change(contact, 1);
        }
        merged_.push_back(contact);
    }
    passOver(~std::uint64_t{0});
    contacts_.swap(merged_);
    found.clear();
}

void TouchRecord::remove(SlotIndex slot) {
    std::erase_if(contacts_, [&](PieceContact const& contact) {
        bool const goes = contact.slotA == slot || contact.slotB == slot;
        if (goes) {
            change(contact, -1);
        }
        return goes;
    });
}

void TouchRecord::noteImpacts(bool wanted) {
    if (impactsWanted_ && !wanted) {
        pressures_.clear();
        impacts_.clear();
    }
    impactsWanted_ = wanted;
}

void TouchRecord::findImpacts(double since, ImpactScene const& scene) {
    if (!impactsWanted_) {
        return;
    }
    budget_.begin();
    for (PieceContact const& contact : contacts_) {
        ContactPatch const& patch = contact.patch;
        double sum = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
            sum += patch.normalImpulse[i];
        }
        double const newImpulse = pressures_.press(contact.key, sum);
        if (!(newImpulse > 0)) {
            continue;
        }
        ImpactBudget::Body const a = scene.before(contact.slotA);
        ImpactBudget::Body const b = scene.before(contact.slotB);
        if (!(newImpulse * (a.inverseMass + b.inverseMass) > faintestImpact)) {
            continue;
        }
        Impact impact{patch.a, patch.b, {}, patch.normal, newImpulse, since};
        for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
            impact.point += patch.normalImpulse[i] / sum * patch.points[i];
        }
        budget_.add(impact, a.inverseMass > 0 ? contact.slotA : contact.slotB, a, b);
    }
    if (budget_.exceeded()) {
        budget_.reset(scene.slots);
        auto const moves = [&](SlotIndex slot) {
            return slot != noSlot && scene.before(slot).inverseMass > 0;
        };
        auto const link = [&](SlotIndex a, SlotIndex b) {
            if (moves(a) && moves(b)) {
                budget_.link(a, b);
            }
        };
        for (PieceContact const& contact : contacts_) {
            link(contact.slotA, contact.slotB);
        }
        for (auto const& [a, b] : scene.joined) {
            link(a, b);
        }
        for (SlotIndex slot = 0; slot < scene.slots; ++slot) {
            if (moves(slot)) {
                budget_.lose(slot, scene.lost(slot));
            }
        }
    }
    budget_.settle(impacts_);
}

} // namespace trembler
