#pragma once

#include "exhibits/framework/files/lesson.h"
#include "exhibits/jobs/handout/handout_table.h"

#include <string>

namespace vitrine::jobs {

/// Returns the path of a step's picture in the folder of a handout, "pictures/step-03.png" for step 2.
[[nodiscard]] std::string stepPicture(std::size_t step);

/// Returns the path of a picture of the lesson itself in the folder of a handout, "pictures/lesson-cone.png".
[[nodiscard]] std::string lessonPicture(const std::string& file);

/// Returns an HTML page to print: title, introduction, and each step with its picture, its task and its question. It
/// needs the pictures beside it, and no network. `tables` gives the names and parameters of all subjects.
[[nodiscard]] std::string handoutPage(const Lesson&, const NamedValues& tables, AnswerPlace);

/// Returns an HTML page with one slide for each step, which fills the screen. Arrow keys, space and clicks turn to the
/// next one; a question shows its answer after one more step.
[[nodiscard]] std::string slidesPage(const Lesson&, const NamedValues& tables);

}  // namespace vitrine::jobs
