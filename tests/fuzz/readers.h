#pragma once

#include <span>
#include <string_view>

// Readers of strangers' files, each as one function of bytes. It returns whether the bytes were accepted; bytes that
// are refused with a Failure, politely, are as good. What must not happen ends the program: an exception of another
// kind, or an accepted file that does not keep the reader's promises.
namespace vitrine::fuzz {

/// Preset of one exhibit; what is accepted has legal values and reads back as it was written.
bool readPreset(std::string_view bytes);
/// Settings of the whole exhibition with their camera; as above, and the camera's view is finite.
bool readExhibition(std::string_view bytes);
/// Lesson; every accepted step has a text and legal values.
bool readLesson(std::string_view bytes);
/// Tour of bookmarks; its cameras are finite, and it reads back as it was written.
bool readTour(std::string_view bytes);
/// Scene of shapes; what is accepted has a field that is a number everywhere, and a shader.
bool readScene(std::string_view bytes);
/// glTF model, .glb or .gltf; every index, number and transform that is accepted can be drawn.
bool readGltf(std::string_view bytes);
/// Picture of any kind, as a texture and as an image, with all that it carries; what is accepted is as large as it says
/// and finite.
bool readImage(std::string_view bytes);
/// Finished lenticular print (TIFF or PNG) with its description inside.
bool readPrintFile(std::string_view bytes);
/// Description beside a print (JSON); what is accepted can be laid out, and its settings are legal.
bool readDescription(std::string_view bytes);
/// File of one study or of several; what is accepted can be compared and written as a table.
bool readStudy(std::string_view bytes);
/// Line to the service; whether it is accepted or refused, the answer is one line of JSON.
bool readRequest(std::string_view bytes);
/// Text that somebody typed for a parameter, as its value or its motion; what is accepted is legal and can be written.
bool readTyped(std::string_view bytes);

/// Recording (GIF, WebP, MP4, WebM or APNG) with its settings inside; what is found is JSON.
bool readVideo(std::string_view bytes);
/// Names of views, one a line, each as the name of a file and as the grid of a quilt; the order of names is strict and
/// weak, and an accepted grid has views.
bool readNames(std::string_view bytes);

/// One reader with the folder of tests/fuzz/corpus that it starts from.
struct Reader {
    std::string_view corpus;
    bool (*read)(std::string_view bytes);
    bool isText = false;  ///< Its files are text, hence a zero byte anywhere is refused.
};
/// All readers, by the names of their folders.
[[nodiscard]] std::span<const Reader> readers();

}  // namespace vitrine::fuzz
