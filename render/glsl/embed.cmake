# cmake -DROOT=shaders -DOUTPUT=embedded.cpp -P embed.cmake: writes every shader as a C++ string.
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/*.glsl ${ROOT}/*.vert ${ROOT}/*.frag ${ROOT}/*.comp)
list(SORT files)
set(entries "")
foreach(file IN LISTS files)
    # Character by character escapes are not needed: a raw string holds a shader. Long files are split
    # because a compiler need not take literals above 64 KiB. With the suffix sv their lengths are known: clang refuses
    # to count so many characters while it compiles.
    file(READ ${ROOT}/${file} text)
    string(LENGTH "${text}" length)
    set(literal "")
    set(position 0)
    while(position LESS length)
        string(SUBSTRING "${text}" ${position} 12000 part)
        string(APPEND literal "R\"shader(${part})shader\"sv\n")
        math(EXPR position "${position} + 12000")
    endwhile()
    if(literal STREQUAL "")
        set(literal "\"\"sv")
    endif()
    string(APPEND entries "    {\"${file}\", ${literal}},\n")
endforeach()
file(WRITE ${OUTPUT}.new "#include \"render/glsl/embedded.h\"\n\nnamespace vitrine::render {\nnamespace {\n\nusing std::string_view_literals::operator\"\"sv;\n\nconstexpr EmbeddedShader shaders[] = {\n${entries}};\n\n}  // namespace\n\nstd::span<const EmbeddedShader> embeddedShaders()\n{\n    return shaders;\n}\n\n}  // namespace vitrine::render\n")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
