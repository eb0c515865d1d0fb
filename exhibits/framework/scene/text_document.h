#pragma once

#include "exhibits/framework/scene/document.h"
#include "render/files/asset_store.h"
#include "render/text/message.h"

#include <string>
#include <vector>

namespace vitrine {

/// Error or remark at a place of an edited text.
struct TextFinding {
    std::string file;          ///< Path as messages show it; that of the document for the text itself.
    int line = 1, column = 1;  ///< From 1; columns in bytes.
    bool isError = true;
    Message sentence;
};

/// Values that show an edited text, and what was found in it.
struct EditedText {
    ParameterValues values;
    bool isShown = false;  ///< False if the text has errors: the values show the last good text and keep this one.
    std::vector<TextFinding> findings;
};

/// Text with which a visitor begins a new document.
struct TextTemplate {
    Message title;
    std::string file;  ///< Value of the file parameter: a file of the program.
};

/// Capability: a document that is edited as a text, such as a shader. Its place has a draft.
class HasText : public HasDocument {
public:
    /// Returns the values with another text. Values of parameters that the new text has, too, are kept. Thread-safe;
    /// takes as long as reading the text, and only for the first time: the store keeps the result.
    [[nodiscard]] virtual EditedText withText(const ParameterValues&, const std::string& text,
                                              render::AssetStore&) const = 0;
    [[nodiscard]] virtual std::vector<TextTemplate> templates() const = 0;
};

}  // namespace vitrine
