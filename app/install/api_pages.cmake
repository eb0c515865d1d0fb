# Target `doc`: pages of the types and functions in the headers, and of all README.md, in doc/html of the build folder. It exists
# where Doxygen is installed, and no other target needs it. Warnings of Doxygen are errors.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
    return()
endif()

set(DOXYGEN_PROJECT_NUMBER ${PROJECT_VERSION})
set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/doc)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR})
set(DOXYGEN_STRIP_FROM_INC_PATH ${PROJECT_SOURCE_DIR})
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
set(DOXYGEN_FILE_PATTERNS *.h *.md)
set(DOXYGEN_EXCLUDE_PATTERNS */tests/*.h */tests/fuzz/* */assets/lessons/[a-z]*.md)
# Pictures and diagrams that the documents show.
set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR})
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
doxygen_add_docs(doc README.md .github/CONTRIBUTING.md .github/SECURITY.md app assets exhibits render tests ui
                 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Writing the pages of the headers into doc/html")
