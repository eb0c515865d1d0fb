#pragma once

// tinygltf as this project uses it: the packaged library, never its own file access or image decoders.
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
