#pragma once

class QObject;

namespace vitrine::ui {

class Workbench;

/// Saves what the window shows as PNG in the pictures folder: at once where the picture is finished, otherwise as soon
/// as it is drawn once more, whole; how far that is stands in the picture meanwhile.
/// `parent` is the window itself: whose children exports are.
void saveScreenshot(Workbench&, QObject& parent);

}  // namespace vitrine::ui
