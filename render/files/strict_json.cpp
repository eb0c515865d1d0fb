#include "render/files/strict_json.h"

#include "render/files/json_scan.h"
#include "render/files/read_file.h"

#include <vector>

namespace vitrine::render {
namespace {

/// Builds the tree from scanner events. Children are complete before they move into their parent.
class TreeBuilder final : public JsonEvents {
public:
    void open(bool isObject) override { open_.push_back({isObject ? Json::object() : Json::array(), {}}); }
    void key(const std::string& text) override { open_.back().key = text; }
    void close() override
    {
        Json done = std::move(open_.back().value);
        open_.pop_back();
        value(std::move(done));
    }
    void value(Json v) override
    {
        if (open_.empty()) {
            root = std::move(v);
            return;
        }
        Open& parent = open_.back();
        if (parent.value.is_array()) parent.value.get_ref<Json::array_t&>().push_back(std::move(v));
        // The scanner has refused duplicates; ordered_map's own insertion would compare with every key.
        else
            parent.value.get_ref<Json::object_t&>().emplace_back(std::move(parent.key), std::move(v));
    }

    Json root;

private:
    struct Open {
        Json value;
        std::string key;
    };
    std::vector<Open> open_;
};

/// Remembers the line of the longest prefix of `wanted` seen so far.
class LineFinder final : public JsonEvents {
public:
    LineFinder(std::string_view wanted, const JsonScanner& scanner) : wanted_(wanted), scanner_(scanner) {}

    void place(const std::string& path) override
    {
        if (path.size() <= longest_ || path.size() > wanted_.size() || wanted_.substr(0, path.size()) != path) return;
        const bool whole = path.size() == wanted_.size();
        if (!whole && wanted_[path.size()] != '.' && wanted_[path.size()] != '[') return;
        longest_ = path.size();
        line = scanner_.position().line;
    }

    int line = 1;

private:
    std::string_view wanted_;
    const JsonScanner& scanner_;
    std::size_t longest_ = 0;
};

}  // namespace

int JsonDocument::lineOf(std::string_view keyPath) const
{
    JsonScanner scanner(text_, name_, JsonLimits{text_.size(), 100'000, text_.size() + 1, text_.size()});
    LineFinder finder(keyPath, scanner);
    scanner.scan(finder, JsonScanner::Paths::report);
    return finder.line;
}

Failure JsonDocument::failure(std::string_view keyPath, std::string_view problem) const
{
    std::string message = name_;
    if (!keyPath.empty()) {
        message += ", line " + std::to_string(lineOf(keyPath)) + ", " + std::string(keyPath);
    }
    return Failure(Blame::file, message + ": " + std::string(problem));
}

JsonDocument parseJson(std::string text, std::string name, const JsonLimits& limits)
{
    TreeBuilder builder;
    JsonScanner scanner(text, name, limits);
    scanner.scan(builder, JsonScanner::Paths::ignore);
    return JsonDocument(std::move(builder.root), std::move(text), std::move(name));
}

JsonDocument readJson(const std::filesystem::path& path, const JsonLimits& limits)
{
    return parseJson(readFile(path, limits.bytes), path.string(), limits);
}

}  // namespace vitrine::render
