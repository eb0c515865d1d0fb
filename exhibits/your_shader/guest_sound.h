#pragma once

#include "render/image/sound.h"
#include "render/image/texture.h"

#include <memory>

// Sounds as pictures, for the ISF inputs `audio` and `audioFFT`. A picture is a function of sound and time alone.
namespace vitrine::guest {

/// Columns of a picture of a sound, if the shader names no number, and at most.
inline constexpr int soundColumns = 256;
inline constexpr int mostSoundColumns = 4096;

/// Returns the last samples before a time, in seconds: a row for each channel, a column for each sample, 0.5 for
/// silence. The sound repeats. Null: silence.
[[nodiscard]] std::shared_ptr<const render::Texture> waveformPicture(const render::Sound*, int columns, double seconds);

/// Returns the amplitudes of the frequencies before a time, in seconds: a row for each channel, a column for each band
/// from 0 to half the sampling rate, 1 for a full sine. Hann window. The sound repeats. Null: silence.
[[nodiscard]] std::shared_ptr<const render::Texture> spectrumPicture(const render::Sound*, int columns, double seconds);

}  // namespace vitrine::guest
