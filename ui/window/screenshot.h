#pragma once

namespace vitrine::ui {

class MainWindow;

/// Saves what the window shows as PNG in the pictures folder: at once where the picture is finished, otherwise as soon
/// as it is drawn once more, whole; how far that is stands in the picture meanwhile.
void saveScreenshot(MainWindow&);

}  // namespace vitrine::ui
