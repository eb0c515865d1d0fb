#pragma once

#include <span>
#include <string_view>

// Readers of untrusted files, each as a function of bytes. Returns whether the bytes were accepted; refusing them with
// a Failure is as good. An exception of another kind, or a broken promise about an accepted file, ends the program.
namespace vitrine::fuzz {

/// Preset of one exhibit. Accepted values are legal and survive writing and reading.
bool readPreset(std::string_view bytes);
/// Settings of the whole exhibition with their camera. As above; the camera's view is finite.
bool readExhibition(std::string_view bytes);
/// Lesson; every accepted step has a text and legal values.
bool readLesson(std::string_view bytes);
/// Tour of bookmarks; its cameras are finite, and it reads back as it was written.
bool readTour(std::string_view bytes);
/// Scene of shapes. An accepted scene has a finite field everywhere, and a shader.
bool readScene(std::string_view bytes);
/// glTF model, .glb or .gltf. All accepted indices, numbers and transforms can be drawn.
bool readGltf(std::string_view bytes);
/// Picture of any kind, read as a texture and as an image, with all its metadata. Accepted pictures have the stated
/// size and are finite.
bool readImage(std::string_view bytes);
/// Finished lenticular print (TIFF or PNG) with its description inside.
bool readPrintFile(std::string_view bytes);
/// Description of a print (JSON). An accepted one can be laid out, and its settings are legal.
bool readDescription(std::string_view bytes);
/// Shader of a visitor, in any form. An accepted one has passes with texts, and inputs whose values are in their
/// ranges.
bool readShader(std::string_view bytes);
/// File of one study or several. Accepted ones can be compared and written as a table.
bool readStudy(std::string_view bytes);
/// Request to the service. The answer is one line of JSON, whether it is accepted or not.
bool readRequest(std::string_view bytes);
/// Text typed for a parameter, as its value or its animation. Accepted ones are legal and can be written.
bool readTyped(std::string_view bytes);

/// Recording (GIF, WebP, MP4, WebM or APNG) with its settings inside, which are JSON.
bool readVideo(std::string_view bytes);
/// Names of views, one in each line, as file names and as grids of a quilt. The order of names is a strict weak order,
/// and an accepted grid has views.
bool readNames(std::string_view bytes);

/// Reader with the folder of its corpus in tests/fuzz/corpus.
struct Reader {
    std::string_view corpus;
    bool (*read)(std::string_view bytes);
    bool isText = false;  ///< The files are text: a zero byte anywhere is refused.
};
/// All readers, by the names of their folders.
[[nodiscard]] std::span<const Reader> readers();

}  // namespace vitrine::fuzz
