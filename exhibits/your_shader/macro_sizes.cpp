#include "exhibits/your_shader/reading.h"

#include <algorithm>
#include <map>

namespace vitrine::guest {
namespace {

/// Macros of a shader with the number of tokens that they expand to.
class Macros {
public:
    explicit Macros(const Reading& reading) : reading_(reading)
    {
        for (std::uint32_t file = 0; file < reading.shader.files.size(); ++file) collect(file);
    }

    void refuseLarge()
    {
        for (const auto& [name, macro] : macros_)
            if (sizeOf(name, 0) > Limits::macroTokens)
                throw refused(reading_, macro.file, macro.line, name,
                              message("The macro “{1}” expands to more than {2} words; write a function or a loop.",
                                      name, Limits::macroTokens));
    }

private:
    struct Macro {
        std::uint32_t file = 0;
        int line = 1;
        std::map<std::string, std::size_t> words{};  // Words of the body that may be macros, with their number.
        std::size_t others = 0;                      // Other tokens.
        std::size_t size = 0;                        // 0: not known yet.
    };

    void collect(std::uint32_t file)
    {
        const render::Tokens tokens(reading_.shader.files[file].text);
        for (std::size_t i = 0; i + 2 < tokens.size(); i = tokens.lineEnd(i)) {
            if (tokens[i].directive == 0 || tokens.text(i + 1) != "define") continue;
            Macro macro{.file = file, .line = tokens[i].line};
            for (std::size_t at = i + 3; at < tokens.lineEnd(i); ++at) {
                const bool isWord = tokens[at].kind == render::Token::Kind::word;
                if (isWord) ++macro.words[std::string(tokens.text(at))];
                macro.others += isWord ? 0 : 1;
            }
            macros_.insert_or_assign(std::string(tokens.text(i + 2)), std::move(macro));
        }
    }
    /// Returns the size of a macro, or 1 of another word. What macros are given for their parameters is not counted.
    std::size_t sizeOf(const std::string& name, int depth)
    {
        const auto found = macros_.find(name);
        if (found == macros_.end()) return 1;
        Macro& macro = found->second;
        if (macro.size != 0) return macro.size;
        macro.size = 1;  // A macro does not expand inside of itself.
        if (depth > 256) return Limits::macroTokens + 1;
        std::size_t size = macro.others;
        for (const auto& [word, count] : macro.words)
            size = std::min(size + count * sizeOf(word, depth + 1), Limits::macroTokens + 1);
        macro.size = std::max<std::size_t>(size, 1);
        return macro.size;
    }

    const Reading& reading_;
    std::map<std::string, Macro> macros_;
};

}  // namespace

void refuseMacroBombs(const Reading& reading)
{
    Macros(reading).refuseLarge();
}

}  // namespace vitrine::guest
