#pragma once

#include "exhibits/framework/table/parameters.h"

#include <cstdint>

namespace vitrine::jobs {

/// Place of the answers in a handout.
enum class AnswerPlace : std::uint8_t { atEnd, below, none };

/// Parameters of a lesson's handout.
struct HandoutTable final : Parameters {
    Group lessonGroup = group("Lesson");
    File lesson = file("lesson", "File of the lesson (Markdown). Without one, the lesson of the exhibit is taken.",
                       extensions("md"));
    Choice<AnswerPlace> answers =
        choice("answers", AnswerPlace::atEnd, {"at the end", "below", "none"},
               "Place of the answers: on a page of their own (at the end), below their questions, or nowhere.");

    Group pictureGroup = group("Pictures");
    Count width = count("width", 960, Range{1, 1000000, logarithmic}.soft(16, 3840),
                        "Size of the picture of a step in pixels.", tuple("size", 'x'));
    Count height = count("height", 540, Range{1, 1000000, logarithmic}.soft(9, 2160),
                         "Height of the picture of a step in pixels.", tuple("size", 'x'));
    Count samples =
        count("samples", 0, Range{1, 4096, logarithmic}.soft(1, 64),
              "Samples per pixel. Auto: the hall's supersamples if they are set, else 4.", reads(0, "auto"));
};

[[nodiscard]] const HandoutTable& handoutTable();

}  // namespace vitrine::jobs
