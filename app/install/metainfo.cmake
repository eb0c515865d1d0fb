# cmake [-DVITRINE_PICTURES_URL=https://...] -DOUT=FILE -P metainfo.cmake: the AppStream metadata. Software centers fetch
# screenshots from the web: they are named where the address is known at which assets/pictures is published.
set(VITRINE_SCREENSHOTS "")
if(VITRINE_PICTURES_URL)
    string(APPEND VITRINE_SCREENSHOTS "  <screenshots>\n")
    # A picture of assets/pictures, what it shows, the same in German; the first is the default.
    set(kind " type=\"default\"")
    foreach(shown IN ITEMS
            "window.png|The window: hall, exhibits, presets, parameters and the frame report|Das Fenster: Halle, Exponate, Presets, Parameter und was das Bild kostete"
            "golden-hour.png|The hall towards evening|Die Halle gegen Abend"
            "fur.png|Fur with physics|Fell mit Physik"
            "print_dialog.png|A lenticular print and what each eye sees of it|Ein Linsendruck und was jedes Auge davon sieht")
        string(REPLACE "|" ";" shown "${shown}")
        list(GET shown 0 picture)
        list(GET shown 1 caption)
        list(GET shown 2 german)
        string(APPEND VITRINE_SCREENSHOTS "    <screenshot${kind}>\n      <caption>${caption}</caption>\n"
               "      <caption xml:lang=\"de\">${german}</caption>\n"
               "      <image type=\"source\">${VITRINE_PICTURES_URL}/${picture}</image>\n    </screenshot>\n")
        set(kind "")
    endforeach()
    string(APPEND VITRINE_SCREENSHOTS "  </screenshots>\n")
endif()

# The releases are those of the change log, which is their only source: "vitrine (0.2.0) ...", lines "  * change" with
# continuations, and " -- name <address>  Thu, 26 Nov 2026 ...".
set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
set(VITRINE_RELEASES "")
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/changelog lines)
foreach(line IN LISTS lines)
    if(line MATCHES "^vitrine \\(([0-9.]+)\\)")
        set(version ${CMAKE_MATCH_1})
        set(changes "")
    elseif(line MATCHES "^  \\* (.*)$")
        string(APPEND changes "|${CMAKE_MATCH_1}")
    elseif(line MATCHES "^    (.*)$")
        string(APPEND changes " ${CMAKE_MATCH_1}")
    elseif(line MATCHES "^ -- .*>  [A-Z][a-z][a-z], ([0-9]+) ([A-Z][a-z][a-z]) ([0-9]+) ")
        string(LENGTH "0${CMAKE_MATCH_1}" length)
        math(EXPR first "${length} - 2")
        string(SUBSTRING "0${CMAKE_MATCH_1}" ${first} 2 day)
        set(year ${CMAKE_MATCH_3})
        list(FIND months ${CMAKE_MATCH_2} month)
        math(EXPR month "${month} + 1")
        if(month LESS 10)
            set(month 0${month})
        endif()
        string(REPLACE "&" "&amp;" changes "${changes}")
        string(REPLACE "<" "&lt;" changes "${changes}")
        string(REPLACE "|" "</li>\n          <li>" changes "${changes}")
        string(REGEX REPLACE "^</li>\n" "" changes "${changes}")
        string(APPEND VITRINE_RELEASES "    <release version=\"${version}\" date=\"${year}-${month}-${day}\">\n"
               "      <description>\n        <ul>\n${changes}</li>\n        </ul>\n      </description>\n    </release>\n")
    endif()
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/org.vitrine.Vitrine.metainfo.xml.in ${OUT} @ONLY)
