#pragma once

#include <string_view>

// What reads files that strangers made, each as one function of bytes. It returns whether the bytes were accepted;
// bytes that are refused with a Failure, politely, are as good. What must not happen ends the program: an exception of
// another kind, or an accepted file that does not keep the reader's promises.
namespace vitrine::fuzz {

/// A preset of one exhibit; what is accepted has legal values and reads back as it was written.
bool readPreset(std::string_view bytes);
/// Settings of the whole exhibition with their camera; as above, and the camera's view is finite.
bool readExhibition(std::string_view bytes);
/// A glTF model, .glb or .gltf; every index, number and transform that is accepted can be drawn.
bool readGltf(std::string_view bytes);
/// A picture of any kind, as a texture and as an image; what is accepted is as large as it says and finite.
bool readImage(std::string_view bytes);
/// A scene of shapes; what is accepted has a field that is a number everywhere, and a shader.
bool readScene(std::string_view bytes);
/// A line to the service; whether it is accepted or refused, the answer is one line of JSON.
bool readRequest(std::string_view bytes);

}  // namespace vitrine::fuzz
