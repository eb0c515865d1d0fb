#pragma once

#include "render/files/strict_json.h"

#include <memory>
#include <string>
#include <string_view>

namespace vitrine::render {

/// What a JsonScanner reports, in the order of the text.
class JsonEvents {
public:
    virtual ~JsonEvents() = default;
    virtual void open(bool /*isObject*/) {}
    virtual void key(const std::string&) {}
    virtual void value(Json) {}  ///< A value that is neither object nor array.
    virtual void close() {}
    virtual void place(const std::string& /*keyPath*/) {}  ///< At each key and array element.
};

/// One pass over a JSON text with the checks of `parseJson`. Text and name must outlive it.
class JsonScanner {
public:
    struct Position {
        int line = 1;    ///< From 1.
        int column = 1;  ///< From 1, in bytes.
    };
    enum class Paths : unsigned char { ignore, report };

    JsonScanner(std::string_view text, const std::string& name, const JsonLimits&);

    /// Throws Failure, as `parseJson` does.
    void scan(JsonEvents&, Paths);
    /// Of the last character taken.
    [[nodiscard]] Position position() const;

private:
    std::string_view text_;
    const std::string& name_;
    JsonLimits limits_;
    std::size_t taken_ = 0;
};

}  // namespace vitrine::render
