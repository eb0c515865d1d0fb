#pragma once

#include "exhibits/museum/picture.h"
#include "render/image/image_io.h"

#include <string_view>

namespace vitrine {

/// Name of the Cryptomatte layer whose objects are exhibits.
inline constexpr const char* cryptomatteLayer = "CryptoObject";

/// Returns the number that stands for a name in the channels of Cryptomatte: its MurmurHash3 (32 bits, seed 0) as the
/// bits of a float that is neither infinite nor too small to be normal (Friedman and Jones 2015, "Fully automatic ID
/// mattes with support for motion blur and transparency").
[[nodiscard]] float cryptomatteId(std::string_view name);

/// Returns what an OpenEXR file of this picture says besides its settings: its camera, what each channel means and in
/// which unit ("vitrine:depth.Z"), and the manifest of Cryptomatte.
[[nodiscard]] render::PictureMetadata exrMetadata(const Museum&, const PictureRequest&);

}  // namespace vitrine
