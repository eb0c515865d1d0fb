# Copies a shader (or cpu.h) so that C++ compiles it at float32: literals get an `f`, types lose their `d`.
# cmake -DINPUT=<file> -DOUTPUT=<file> -P float32.cmake
file(READ "${INPUT}" text)
if(INPUT MATCHES "\\.h$")
    string(REPLACE "vitrine::glsl" "vitrine::glsl32" text "${text}")
    string(REPLACE "\"shaders/lib/" "\"float32/lib/" text "${text}")
    string(REPLACE "glm::dvec" "glm::vec" text "${text}")
    string(REPLACE "glm::dmat" "glm::mat" text "${text}")
    string(REPLACE "#define float double" "" text "${text}")
    string(REPLACE "#undef float" "" text "${text}")
else()
    string(REGEX REPLACE "([0-9]+\\.[0-9]+(e-?[0-9]+)?)" "\\1f" text "${text}")
endif()
file(WRITE "${OUTPUT}" "${text}")
