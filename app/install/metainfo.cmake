# cmake [-DVITRINE_PICTURES_URL=https://...] -DOUT=FILE -P metainfo.cmake: the AppStream metadata. Software centers fetch
# screenshots from the web: they are named where the address is known at which assets/pictures is published.
set(VITRINE_SCREENSHOTS "")
if(VITRINE_PICTURES_URL)
    string(APPEND VITRINE_SCREENSHOTS "  <screenshots>\n")
    # A picture of assets/pictures, what it shows, the same in German.
    foreach(shown IN ITEMS
            "default|window.png|The window: hall, exhibits, presets, parameters and the ledger of the frame|Das Fenster: Halle, Exponate, Presets, Parameter und was das Bild kostete"
            "source|golden-hour.png|The hall towards evening|Die Halle gegen Abend"
            "source|fur.png|Fur with physics|Fell mit Physik"
            "source|print_dialog.png|A lenticular print and what each eye sees of it|Ein Linsendruck und was jedes Auge davon sieht")
        string(REPLACE "|" ";" shown "${shown}")
        list(GET shown 0 kind)
        list(GET shown 1 picture)
        list(GET shown 2 caption)
        list(GET shown 3 german)
        string(REPLACE "source" "" kind "${kind}")
        string(REPLACE "default" " type=\"default\"" kind "${kind}")
        string(APPEND VITRINE_SCREENSHOTS "    <screenshot${kind}>\n      <caption>${caption}</caption>\n"
               "      <caption xml:lang=\"de\">${german}</caption>\n"
               "      <image type=\"source\">${VITRINE_PICTURES_URL}/${picture}</image>\n    </screenshot>\n")
    endforeach()
    string(APPEND VITRINE_SCREENSHOTS "  </screenshots>\n")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/org.vitrine.Vitrine.metainfo.xml.in ${OUT} @ONLY)
