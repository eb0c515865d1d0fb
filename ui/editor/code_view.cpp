#include "ui/editor/code_view.h"

#include "render/failure.h"
#include "render/files/module.h"

namespace vitrine::ui {

/// A function of its own for the reason that render/image/video_codec.cpp states.
static void* openEditorModule()
{
    return render::openModule({"libvitrine_editor.so", VITRINE_EDITOR_BUILT, "vitrineCodeView",
                               message("shows and edits shaders"), Message::verbatim("QScintilla")},
                              [](void* found) { return found; });
}

std::unique_ptr<CodeView> openCodeView(QWidget* parent)
{
    // A static initialization that throws is tried again by the next call.
    static void* const symbol = openEditorModule();
    std::unique_ptr<CodeView> view(reinterpret_cast<decltype(&vitrineCodeView)>(symbol)(codeViewVersion, parent));
    if (!view)
        throw Failure(ErrorKind::file,
                      "libvitrine_editor.so belongs to another version of Vitrine; build both together.");
    return view;
}

}  // namespace vitrine::ui
