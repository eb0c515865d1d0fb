# Files of `cmake --install` and their folders, and the Debian package that `cpack` makes from a finished build tree.
# The program finds its assets in share/vitrine and its modules in lib/vitrine/modules, relative to its own folder.

set(vitrine_generated ${PROJECT_BINARY_DIR}/app/install)
set(vitrine_install ${PROJECT_SOURCE_DIR}/app/install)

install(TARGETS vitrine RUNTIME DESTINATION bin)
install(TARGETS vitrine_oiio vitrine_video vitrine_draco vitrine_gamepad vitrine_controllers
                vitrine_editor LIBRARY DESTINATION lib/vitrine/modules)
install(TARGETS vitrine_shader_compiler RUNTIME DESTINATION lib/vitrine)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/ DESTINATION share/vitrine
        PATTERN "*.py" EXCLUDE PATTERN "*.sh" EXCLUDE PATTERN "*.blend*" EXCLUDE PATTERN "__pycache__" EXCLUDE
        PATTERN "pictures" EXCLUDE PATTERN "translations" EXCLUDE)
foreach(size 16 22 24 32 48 64 128 256 512)
    install(FILES ${PROJECT_SOURCE_DIR}/assets/icons/vitrine_${size}.png
            DESTINATION share/icons/hicolor/${size}x${size}/apps RENAME org.vitrine.Vitrine.png)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/assets/icons/vitrine.svg
        DESTINATION share/icons/hicolor/scalable/apps RENAME org.vitrine.Vitrine.svg)
install(FILES ${vitrine_install}/org.vitrine.Vitrine.desktop DESTINATION share/applications)
set(VITRINE_PICTURES_URL "" CACHE STRING "Where assets/pictures is published (https://...): AppStream's screenshots")
install(CODE "
execute_process(COMMAND ${CMAKE_COMMAND} -DVITRINE_PICTURES_URL=${VITRINE_PICTURES_URL} -DOUT=${vitrine_generated}/org.vitrine.Vitrine.metainfo.xml
                -P ${vitrine_install}/metainfo.cmake COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${vitrine_generated}/org.vitrine.Vitrine.metainfo.xml DESTINATION share/metainfo)
install(FILES ${vitrine_install}/org.vitrine.Vitrine.mime.xml DESTINATION share/mime/packages RENAME org.vitrine.Vitrine.xml)

# The help texts are the one home of what commands and options are: manual page and completion are made of them at install.
install(CODE "
execute_process(COMMAND sh ${vitrine_install}/help_texts.sh $<TARGET_FILE:vitrine> ${vitrine_generated} COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${vitrine_generated}/vitrine.1.gz DESTINATION share/man/man1)
install(FILES ${vitrine_generated}/vitrine.bash DESTINATION share/bash-completion/completions RENAME vitrine)
install(FILES ${vitrine_generated}/_vitrine DESTINATION share/zsh/vendor-completions)

install(FILES ${vitrine_generated}/copyright ${vitrine_generated}/changelog.gz DESTINATION share/doc/vitrine)

# The manual: README.md, the documents that it links to, and their pictures.
include(${vitrine_install}/manual.cmake)
vitrine_manual_files(vitrine_manual ${PROJECT_SOURCE_DIR})
foreach(file ${vitrine_manual})
    get_filename_component(folder ${file} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${file} DESTINATION share/doc/vitrine/${folder})
    if(file MATCHES "\\.md$")
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
    endif()
endforeach()
# The Python package, in Debian's folder for packages that depend on no version.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/app/serve/python/vitrine DESTINATION lib/python3/dist-packages
        PATTERN "__pycache__" EXCLUDE)
install(FILES ${vitrine_install}/lintian_overrides DESTINATION share/lintian/overrides RENAME vitrine)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vitrine)
set(CPACK_PACKAGE_CONTACT "The developers of Vitrine <vitrine@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "museum and workbench of real-time rendering techniques")
set(CPACK_PACKAGE_DESCRIPTION "Walk through a hall, stand before an exhibit,
drag its sliders, and see what every quality setting costs: fur, clouds,
signed distance fields, pixel art, beams of light and more. Interlaces views
for lenticular prints, and measures what accuracy costs. Works without a
graphics card, and from the command line without a display.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Opened at run time, hence in no list of the linker: OpenGL, the driver for machines without a graphics card, SVG icons.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1, libgl1-mesa-dri, libegl-mesa0, libglx-mesa0, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-wayland, qt6-translations-l10n")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-numpy")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
include(CPack)
