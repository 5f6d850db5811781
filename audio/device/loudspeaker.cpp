#include "audio/device/loudspeaker.hpp"

#include "audio/device/openal_output.hpp"
#include "runtime/world/world.hpp"

namespace trembler {
namespace {

std::unique_ptr<Output> openOutput(LoudspeakerOptions const& options, Loudspeaker::Report const& report) {
    std::string why;
    if (std::unique_ptr<Output> found = OpenAlOutput::open(options.synthesiser, why)) {
        return found;
    }
    if (report) {
        report("There will be no sound: " + why + ".");
    }
    return std::make_unique<NullOutput>();
}

} // namespace

Loudspeaker::Loudspeaker(LoudspeakerOptions options, Report report)
    : Loudspeaker(options, openOutput(options, report), report) {}

Loudspeaker::Loudspeaker(LoudspeakerOptions options, std::unique_ptr<Output> output, Report report)
    : options_(std::move(options)), output_(std::move(output)),
      recordings_(options_.sampleFolders, std::move(report)),
      synthesiser_(options_.synthesiser, &recordings_) {
    output_->set(options_.output);
}

Loudspeaker::~Loudspeaker() = default;

void Loudspeaker::enter(World const& world) {
    startAfresh();
    if (dynamic_cast<NullOutput const*>(output_.get()) == nullptr) {
        sounds_ =
            world.want<Sounds>(); // even if the address is the same: the world before may no longer exist
        world_ = &world;
    }
}

void Loudspeaker::leave() {
    if (world_ != nullptr) {
        sounds_.end();
        world_ = nullptr;
        startAfresh();
    }
}

void Loudspeaker::startAfresh() {
    synthesiser_.clear();
    recordings_.newLevel();
    output_->stop();
    roomAt_.reset();
}

void Loudspeaker::frame(World const& world, Listener const& listener) {
    if (world_ != &world || !sounds_) {
        return;
    }
    followRoom(world, listener);
    if (Sounds const* const sounds = world.find<Sounds>()) {
        synthesiser_.hear(*sounds, listener);
    }
    output_->play(synthesiser_.render(), listener);
}

void Loudspeaker::pause(Listener const& listener) {
    if (world_ != nullptr) {
        output_->play(synthesiser_.render(), listener);
    }
}

void Loudspeaker::touch(InterfaceSound sound) {
    ++touched_;
    if (options_.output.touches <= 0) {
        return;
    }
    std::vector<float>& samples = touches_[sound];
    if (samples.empty()) {
        samples = samplesOf(sound, options_.synthesiser.rate);
    }
    output_->playOnce(samples, options_.output.touches);
}

void Loudspeaker::set(OutputSettings const& settings) {
    options_.output = settings;
    output_->set(settings);
}

// Walls rarely change and listeners move slowly, so the room is computed every second, or after half a metre.
void Loudspeaker::followRoom(World const& world, Listener const& listener) {
    constexpr double step = 0.5;           // m
    constexpr std::uint64_t patience = 60; // frames
    if (options_.output.reverb && (!roomAt_ || length(*roomAt_ - listener.at) > step ||
                                   world.frame() >= roomFrame_ + patience || world.frame() < roomFrame_)) {
        output_->set(roomAround(world.store(), listener.at));
        roomAt_ = listener.at;
        roomFrame_ = world.frame();
    }
}

} // namespace trembler
