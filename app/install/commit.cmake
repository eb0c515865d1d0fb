# cmake -DROOT=FOLDER -DOUT=FILE -P commit.cmake: writes a source file with the commit of FOLDER, only if it changed. Without
# git, or in an archive, the commit is empty. A repository above FOLDER is none of this project.
set(commit "")
find_program(GIT git)
if(GIT AND EXISTS ${ROOT}/.git)
    execute_process(COMMAND ${GIT} -C ${ROOT} describe --always --exclude=*
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    # Results are what the program measured, and no part of it.
    execute_process(COMMAND ${GIT} -C ${ROOT} status --porcelain --untracked-files=no -- . ":!tests/bench/results"
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
        string(APPEND commit "-dirty")
    endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT [==[
#include "app/kit/commit.h"

namespace vitrine::app {

const char* const commit = "@commit@";

}  // namespace vitrine::app
]==] @ONLY NEWLINE_STYLE UNIX)
