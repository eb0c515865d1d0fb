#pragma once

class QObject;

namespace vitrine::ui {

class Workbench;

/// Saves the picture on the screen at once, as PNG in the pictures folder. If it is not finished, it is drawn again
/// with all samples and replaces the file. `parent` is the window, which is the parent of all exports.
void saveScreenshot(Workbench&, QObject& parent);

}  // namespace vitrine::ui
