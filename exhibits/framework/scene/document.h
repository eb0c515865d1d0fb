#pragma once

#include "exhibits/framework/table/parameters.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

namespace vitrine {

/// Storage of an exhibit's document: the parameters of its table, and the file.
struct DocumentPlace {
    std::size_t file = 0, document = 0;
    std::string path = {};
    bool writable = false;                  ///< True if the file belongs to the visitor and not to the program.
    std::string suffix = {};                ///< Ending of a new file, without the dot: "vitrine-scene.json".
    std::optional<std::size_t> draft = {};  ///< Text that is newer than the document, but has errors.
};

/// Interface of exhibits that show a file which visitors edit in the window. The edited content is a parameter
/// (`Parameters::document`) until it is saved, so undo, presets and sessions store it.
class HasDocument {
public:
    virtual ~HasDocument() = default;

    [[nodiscard]] virtual DocumentPlace document(const ParameterValues&) const = 0;
    /// Returns the document text, or the text of the file if there is no document.
    [[nodiscard]] virtual std::string documentText(const ParameterValues&) const = 0;
    /// Returns whether a text can be a document of this exhibit.
    [[nodiscard]] virtual bool isDocument(const std::string& text) const = 0;
    /// Returns the edited text that is not in the file; empty: nothing was edited.
    [[nodiscard]] std::string unsavedText(const ParameterValues& values) const
    {
        const DocumentPlace place = document(values);
        std::string text = place.draft ? std::get<std::string>(values.row(*place.draft)) : std::string();
        return text.empty() ? std::get<std::string>(values.row(place.document)) : text;
    }
    /// Removes the edited text, so that the values show the file.
    void dropUnsaved(ParameterValues& values) const
    {
        const DocumentPlace place = document(values);
        values.resetParameter(place.document);
        if (place.draft) values.resetParameter(*place.draft);
    }
};

}  // namespace vitrine
