// The sound of a world, written into a file instead of played: no sound device, no clock.
#pragma once

#include "audio/device/loudspeaker.hpp"
#include "runtime/file/output_file.hpp"

#include <memory>

namespace trembler {

class OpenAlOutput;

/// A .wav file, 16 bits, left and right at the synthesiser's rate, one block of samples per frame of the
/// world. It holds what the game's loudspeaker would have played, through OpenAL's device that plays into
/// memory; the same world makes the same file, bit for bit. Full scale is 100 dB at the listener, as in
/// OpenAlOutput; louder samples are clipped. Used by one thread at a time.
class SoundFile {
public:
    /// Throws std::invalid_argument if the name does not end in .wav, OutputError if the file cannot be
    /// written, and std::runtime_error if OpenAL cannot play into memory here.
    SoundFile(std::filesystem::path file, LoudspeakerOptions const& options, Loudspeaker::Report report = {});
    ~SoundFile();
    SoundFile(SoundFile const&) = delete;
    SoundFile& operator=(SoundFile const&) = delete;

    /// Before the first frame of the world that is to be heard.
    void enter(World const& world) { loudspeaker_->enter(world); }
    /// After every step of the world. Throws OutputError if the file cannot take more.
    void frame(World const& world, Listener const& listener);
    /// Completes the file and puts it in its place; without it there is none. Throws OutputError if not all
    /// of it could be written.
    void finish();

private:
    struct Handle;

    std::filesystem::path name_;
    std::unique_ptr<OutputFile> file_;
    OpenAlOutput* output_ = nullptr; // the loudspeaker's
    std::unique_ptr<Loudspeaker> loudspeaker_;
    std::unique_ptr<Handle> handle_;
};

} // namespace trembler
