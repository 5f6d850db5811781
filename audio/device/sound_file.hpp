// Writes the sound of a world into a file, without a sound device or a clock.
#pragma once

#include "audio/device/loudspeaker.hpp"
#include "runtime/file/output_file.hpp"

#include <cstdint>
#include <memory>

namespace trembler {

class OpenAlOutput;

/// A .wav file, 16 bits, left and right at the synthesiser's rate, one block of samples per frame of the
/// world. It contains the same sound as the game's loudspeaker plays, rendered by OpenAL's device that plays
/// into memory; equal worlds make equal files, bit for bit. Full scale is 94 dB at the listener, as in
/// OpenAlOutput, whose limiter keeps louder sounds below it. Used by one thread at a time.
class SoundFile {
public:
    /// Pairs of samples: the format has 32 bits for its lengths, and 4 bytes for each pair behind a header.
    static constexpr std::uint64_t mostPairs = 0xFFFF'FFFFULL / 4 - 1024;
    /// Frames of the world that fit at that rate, in pairs per second.
    [[nodiscard]] static std::uint64_t mostFrames(int rate);

    /// Throws std::invalid_argument if the name does not end in .wav, OutputError if the file cannot be
    /// written, and std::runtime_error if this OpenAL cannot play into memory.
    SoundFile(std::filesystem::path file, LoudspeakerOptions const& options, Loudspeaker::Report report = {});
    ~SoundFile();
    SoundFile(SoundFile const&) = delete;
    SoundFile& operator=(SoundFile const&) = delete;

    /// To be called before the first frame to be recorded.
    void enter(World const& world) { loudspeaker_->enter(world); }
    /// To be called after every step of the world. Throws OutputError if writing fails, or if
    /// the file would have more than `mostPairs` (EFBIG).
    void frame(World const& world, Listener const& listener);
    /// Completes the file and puts it in its place; without this call there is no file. Throws OutputError if
    /// not all of it could be written.
    void finish();

private:
    struct Handle;

    std::filesystem::path name_;
    std::unique_ptr<OutputFile> file_;
    OpenAlOutput* output_ = nullptr; // owned by loudspeaker_
    std::unique_ptr<Loudspeaker> loudspeaker_;
    std::unique_ptr<Handle> handle_;
    std::uint64_t pairs_ = 0; // written
};

} // namespace trembler
