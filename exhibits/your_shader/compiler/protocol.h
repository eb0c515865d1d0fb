#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Messages between the program and vitrine_shader_compiler, which both include this file. A message is its size in
// bytes, 32 bits, followed by texts and numbers. A text is its size and its bytes.
namespace vitrine::guest {

inline constexpr std::uint32_t mostMessageBytes = 64U << 20U;
/// Exit code of a compiler whose memory was not enough.
inline constexpr int outOfMemoryCode = 12;
/// Processor time of the compiler for one request, in seconds. SIGPROF ends its process after that.
inline constexpr int mostProcessorSeconds = 2;

/// Shader source that the compiler process translates.
struct CompilerRequest {
    std::string vertex, fragment;  ///< GLSL 4.50; `#line` names files by number.
    bool forWeb = false;           ///< The answer is GLSL ES 3.00, which WebGL 2 reads.
};

/// Limits of a program, counted in SPIR-V before a driver sees it.
struct ProgramLimits {
    static constexpr std::uint64_t instructions = 100'000;   ///< With all calls expanded. Mesa takes 1.3 s for as many.
    static constexpr std::uint64_t localBytes = 64U << 10U;  ///< Local and private variables.
    static constexpr std::uint64_t samplers = 16;            ///< As many as every OpenGL has for a stage.
};

/// Upper bounds on the work and memory of a program, counted in SPIR-V.
struct ProgramCounts {
    std::uint64_t instructions = 0;  ///< With every call replaced by its function, both stages.
    std::uint64_t localBytes = 0;    ///< Local and private variables.
    std::uint64_t samplers = 0;      ///< Samplers of the stage that has more.
    bool recursive = false;

    [[nodiscard]] bool areTooLarge() const
    {
        return recursive || instructions > ProgramLimits::instructions || localBytes > ProgramLimits::localBytes ||
               samplers > ProgramLimits::samplers;
    }
};

struct CompilerAnswer {
    std::string vertex, fragment;  ///< GLSL of SPIRV-Cross; empty after an error, and if too large.
    std::string log;               ///< Errors of glslang, a line each.
    std::string problem;           ///< Error of SPIRV-Cross; empty if there is none.
    ProgramCounts counts;
};

/// Writes texts and numbers one after another.
class MessageWriter {
public:
    void put(std::uint64_t number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
    void put(std::string_view text)
    {
        put(std::uint64_t{text.size()});
        bytes_ += text;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Reads what `MessageWriter` wrote. Beyond the end, everything is empty and `good` is false.
class MessageReader {
public:
    explicit MessageReader(std::string_view bytes) : bytes_(bytes) {}
    [[nodiscard]] std::uint64_t number()
    {
        std::uint64_t value = 0;
        const std::string_view part = take(sizeof value);
        if (part.size() == sizeof value) std::memcpy(&value, part.data(), sizeof value);
        return value;
    }
    [[nodiscard]] std::string text() { return std::string(take(number())); }
    [[nodiscard]] bool good() const { return good_; }

private:
    std::string_view take(std::uint64_t size)
    {
        good_ = good_ && size <= bytes_.size();
        if (!good_) return {};
        const std::string_view part = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return part;
    }

    std::string_view bytes_;
    bool good_ = true;
};

[[nodiscard]] inline std::string packed(const CompilerRequest& request)
{
    MessageWriter writer;
    writer.put(request.vertex);
    writer.put(request.fragment);
    writer.put(std::uint64_t{request.forWeb});
    return writer.bytes();
}

[[nodiscard]] inline std::optional<CompilerRequest> unpackedRequest(std::string_view bytes)
{
    MessageReader reader(bytes);
    CompilerRequest request;
    request.vertex = reader.text();
    request.fragment = reader.text();
    request.forWeb = reader.number() != 0;
    if (!reader.good()) return std::nullopt;
    return request;
}

[[nodiscard]] inline std::string packed(const CompilerAnswer& answer)
{
    MessageWriter writer;
    for (const std::string* text : {&answer.vertex, &answer.fragment, &answer.log, &answer.problem}) writer.put(*text);
    const ProgramCounts& counts = answer.counts;
    writer.put(counts.instructions);
    writer.put(counts.localBytes);
    writer.put(counts.samplers);
    writer.put(std::uint64_t{counts.recursive});
    return writer.bytes();
}

[[nodiscard]] inline std::optional<CompilerAnswer> unpackedAnswer(std::string_view bytes)
{
    MessageReader reader(bytes);
    CompilerAnswer answer;
    for (std::string* text : {&answer.vertex, &answer.fragment, &answer.log, &answer.problem}) *text = reader.text();
    answer.counts.instructions = reader.number();
    answer.counts.localBytes = reader.number();
    answer.counts.samplers = reader.number();
    answer.counts.recursive = reader.number() != 0;
    if (!reader.good()) return std::nullopt;
    return answer;
}

}  // namespace vitrine::guest
