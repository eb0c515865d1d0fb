#pragma once

class QObject;

namespace vitrine::ui {

class Workbench;

/// Saves the picture on the screen at once, as PNG in the pictures folder. Where that picture is not finished yet, it
/// is drawn once more, with all samples, and replaces the file. `parent` is the window itself: the parent of all
/// exports.
void saveScreenshot(Workbench&, QObject& parent);

}  // namespace vitrine::ui
