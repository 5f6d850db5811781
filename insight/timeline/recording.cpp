#include "insight/timeline/recording.hpp"

#include <algorithm>
#include <utility>

namespace trembler::insight {
namespace {

constexpr std::size_t blocksKeptOpen = 3;

bool holds(SharedWords const& shared, Words const& words) {
    return shared && *shared == words;
}

} // namespace

void Recording::clear() {
    parts_.clear();
    places_.clear();
    beginning_.clear();
    latest_.clear();
    versions_.clear();
    structure_ = 0;
    blocks_.clear();
    loose_.clear();
    packedBytes_ = 0;
    freshBytes_ = 0;
    open_.clear();
}

void Recording::begin(World const& world, GoalJudge const& judge) {
    clear();
    RecordedFrame frame = look(world, judge);
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        beginning_[part] = std::exchange(latest_[part], nullptr);
    }
    frame.values.clear();
    loose_.push_back(std::move(frame));
}

void Recording::add(World const& world, GoalJudge const& judge) {
    if (!begun() || world.frame() <= last()) {
        return;
    }
    loose_.push_back(look(world, judge));
    // So the latest frames need no unpacking, unless they are those of a very large world.
    if (loose_.size() >= 2 * framesInBlock || (freshBytes_ > mostBytes_ / 2 && loose_.size() > 2)) {
        pack();
    }
}

RecordedFrame Recording::look(World const& world, GoalJudge const& judge) {
    RecordedFrame frame;
    frame.number = world.frame();
    Store const& store = world.store();
    lookAtObjects(store);
    lookAtColumns(store);
    lookAtSlots(store);
    lookAtGoals(judge);
    frame.values = latest_;
    return frame;
}

std::size_t Recording::place(RecordedPart const& part) {
    std::string_view const key = part.property != nullptr ? part.property->text.key : std::string_view();
    auto const [at, isNew] = places_.try_emplace({part.kind, key}, parts_.size());
    if (isNew) {
        parts_.push_back(part);
        beginning_.emplace_back();
        latest_.emplace_back();
        versions_.push_back(0);
    }
    return at->second;
}

void Recording::keep(std::size_t part, Words words) {
    if (holds(latest_[part], words) || (!latest_[part] && holds(beginning_[part], words))) {
        return;
    }
    freshBytes_ += words.size() * sizeof(words.front());
    latest_[part] =
        holds(beginning_[part], words) ? nullptr : std::make_shared<Words const>(std::move(words));
}

void Recording::lookAtColumns(Store const& store) {
    for (ColumnBase const* const column : store.columns()) {
        std::size_t const part = place({RecordedPart::Kind::column, &column->info()});
        if (std::exchange(versions_[part], column->version()) != column->version()) {
            Words words;
            WordWriter out(words);
            writeColumn(*column, out);
            keep(part, std::move(words));
        }
    }
}

void Recording::lookAtSlots(Store const& store) {
    for (RecordedSlot const& recorded : recordedSlots()) {
        SlotBase const* const slot = store.findSlot(*recorded.info);
        if (slot == nullptr) {
            continue;
        }
        std::size_t const part = place({RecordedPart::Kind::slot, recorded.info});
        // News of a frame in parts are gathered again, whether or not the last part wrote them.
        if (std::exchange(versions_[part], slot->version()) != slot->version() || slot->reportsNews()) {
            Words words;
            WordWriter out(words);
            recorded.write(store, out);
            keep(part, std::move(words));
        }
    }
}

void Recording::lookAtObjects(Store const& store) {
    std::size_t const part = place({RecordedPart::Kind::objects, nullptr});
    if (std::exchange(structure_, store.structureVersion()) == store.structureVersion()) {
        return;
    }
    Words words;
    WordWriter out(words);
    ObjectTable const& objects = store.objects();
    out.word(objects.size());
    for (std::uint32_t index = 0; index < objects.indexBound(); ++index) {
        if (ObjectId const id = objects.at(index); id.valid()) {
            out.word(packed(id));
            out.text(store.nameOf(id));
        }
    }
    keep(part, std::move(words));
}

void Recording::lookAtGoals(GoalJudge const& judge) {
    Words words;
    WordWriter out(words);
    for (GoalStatus const& goal : judge.status()) {
        out.members(goal.met);
        out.number(goal.progress);
        out.word(goal.frame ? *goal.frame + 1 : 0);
    }
    out.word(judge.solvedFrame() ? *judge.solvedFrame() + 1 : 0);
    keep(place({RecordedPart::Kind::goals, nullptr}), std::move(words));
}

void Recording::pack() {
    auto const end = loose_.begin() + static_cast<std::ptrdiff_t>(std::min(framesInBlock, loose_.size() / 2));
    Block block{std::make_shared<PackedFrames const>(std::span(loose_.begin(), end)), 1};
    loose_.erase(loose_.begin(), end);
    packedBytes_ += block.packed->bytes();
    blocks_.push_back(std::move(block));
    freshBytes_ = looseBytes();
    std::size_t const loose = 2 * freshBytes_; // by when they are packed there are twice as many
    while (packedBytes_ + loose > mostBytes_ && blocks_.size() > 1) {
        std::size_t const before = packedBytes_;
        thin();
        if (packedBytes_ >= before) {
            break; // no frame can be left out any more
        }
    }
}

void Recording::thin() {
    // The older a block is compared with how much of it has been left out, the sooner it is thinned: so the
    // remaining frames become sparser gradually towards the beginning.
    auto const age = [&](Block const& block) {
        std::uint64_t const last = loose_.empty() ? 0 : loose_.back().number;
        return static_cast<double>(last + framesInBlock - block.packed->numbers().front()) / block.stride;
    };
    std::size_t oldest = 0;
    for (std::size_t i = 1; i < blocks_.size(); ++i) {
        oldest = age(blocks_[i]) > age(blocks_[oldest]) ? i : oldest;
    }
    Block& block = blocks_[oldest];
    packedBytes_ -= block.packed->bytes();
    if (block.packed->size() == 1) {
        // Only its first frame is left: two such neighbours become one block, of which every second goes.
        if (oldest == 0) {
            block.stride *= 2;
            packedBytes_ += block.packed->bytes();
            if (blocks_.size() > 1 && blocks_[1].packed->size() == 1) {
                packedBytes_ -= blocks_[1].packed->bytes();
                blocks_.erase(blocks_.begin() + 1);
            }
            return;
        }
        blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(oldest));
        return;
    }
    std::vector<RecordedFrame> const all = block.packed->unpacked();
    std::vector<RecordedFrame> rest;
    for (std::size_t i = 0; i < all.size(); i += 2) {
        rest.push_back(all[i]);
    }
    block.packed = std::make_shared<PackedFrames const>(rest);
    block.stride *= 2;
    packedBytes_ += block.packed->bytes();
}

std::size_t Recording::looseBytes() const {
    std::size_t words = 0;
    std::vector<SharedWords> known;
    for (RecordedFrame const& frame : loose_) {
        known.resize(std::max(known.size(), frame.values.size()));
        for (std::size_t part = 0; part < frame.values.size(); ++part) {
            if (frame.values[part] && frame.values[part] != known[part]) {
                words += frame.values[part]->capacity();
            }
            known[part] = frame.values[part];
        }
        words += frame.values.size() * sizeof(SharedWords) / sizeof(std::uint64_t);
    }
    return words * sizeof(std::uint64_t);
}

void Recording::forgetAfter(std::uint64_t frame) {
    open_.clear();
    // Blocks that reach beyond the frame become loose again, so that later frames follow it directly.
    while (!blocks_.empty() && blocks_.back().packed->numbers().back() > frame) {
        std::vector<RecordedFrame> frames = blocks_.back().packed->unpacked();
        packedBytes_ -= blocks_.back().packed->bytes();
        blocks_.pop_back();
        frames.insert(frames.end(), loose_.begin(), loose_.end());
        loose_ = std::move(frames);
        std::erase_if(loose_, [&](RecordedFrame const& each) { return each.number > frame; });
    }
    std::erase_if(loose_, [&](RecordedFrame const& each) { return each.number > frame; });
    freshBytes_ = looseBytes();
    // The next recorded values are compared with the beginning.
    std::fill(latest_.begin(), latest_.end(), nullptr);
    std::fill(versions_.begin(), versions_.end(), 0);
    structure_ = 0;
}

std::uint64_t Recording::last() const {
    if (!loose_.empty()) {
        return loose_.back().number;
    }
    return blocks_.empty() ? 0 : blocks_.back().packed->numbers().back();
}

std::size_t Recording::blockOf(std::uint64_t frame) const {
    if (!loose_.empty() && loose_.front().number <= frame) {
        return blocks_.size();
    }
    auto const later =
        std::upper_bound(blocks_.begin(), blocks_.end(), frame, [](std::uint64_t number, Block const& block) {
            return number < block.packed->numbers().front();
        });
    return later == blocks_.begin() ? 0 : static_cast<std::size_t>(later - blocks_.begin()) - 1;
}

std::optional<std::uint64_t> Recording::after(std::uint64_t frame) const {
    for (std::size_t i = blockOf(frame); i < blocks_.size(); ++i) {
        auto const numbers = blocks_[i].packed->numbers();
        auto const next = std::upper_bound(numbers.begin(), numbers.end(), frame);
        if (next != numbers.end()) {
            return *next;
        }
    }
    auto const next = std::find_if(loose_.begin(), loose_.end(),
                                   [&](RecordedFrame const& each) { return each.number > frame; });
    return next == loose_.end() ? std::nullopt : std::optional(next->number);
}

std::optional<std::uint64_t> Recording::before(std::uint64_t frame) const {
    for (auto each = loose_.rbegin(); each != loose_.rend(); ++each) {
        if (each->number < frame) {
            return each->number;
        }
    }
    for (std::size_t i = std::min(blockOf(frame) + 1, blocks_.size()); i > 0; --i) {
        auto const numbers = blocks_[i - 1].packed->numbers();
        auto const next = std::lower_bound(numbers.begin(), numbers.end(), frame);
        if (next != numbers.begin()) {
            return *(next - 1);
        }
    }
    return std::nullopt;
}

std::uint64_t Recording::nearest(std::uint64_t frame) const {
    auto const low = before(frame + 1);
    auto const high = after(frame);
    if (!low || !high) {
        return low ? *low : high.value_or(0);
    }
    return frame - *low <= *high - frame ? *low : *high;
}

RecordedFrame const& Recording::at(std::uint64_t frame) const {
    static RecordedFrame const nothing;
    std::uint64_t const number = nearest(frame);
    std::size_t const block = blockOf(number);
    std::vector<RecordedFrame> const& frames = block == blocks_.size() ? loose_ : unpacked(blocks_[block]);
    auto const found = std::lower_bound(
        frames.begin(), frames.end(), number,
        [](RecordedFrame const& each, std::uint64_t sought) { return each.number < sought; });
    return found == frames.end() ? nothing : *found;
}

std::size_t Recording::frames() const {
    std::size_t all = loose_.size();
    for (Block const& block : blocks_) {
        all += block.packed->size();
    }
    return all;
}

std::vector<RecordedFrame> const& Recording::unpacked(Block const& block) const {
    auto const known =
        std::find_if(open_.begin(), open_.end(), [&](Open const& open) { return open.of == block.packed; });
    if (known == open_.end()) {
        open_.push_front({block.packed, block.packed->unpacked()});
        if (open_.size() > blocksKeptOpen) {
            open_.pop_back();
        }
    } else if (known != open_.begin()) {
        std::rotate(open_.begin(), known, known + 1);
    }
    return open_.front().frames;
}

} // namespace trembler::insight
