# cmake [-DVITRINE_PICTURES_URL=https://...] -DOUT=FILE -P metainfo.cmake: the AppStream metadata. Software centers fetch
# screenshots from the web: they are named where the address is known at which assets/pictures is published.
set(VITRINE_SCREENSHOTS "")
if(VITRINE_PICTURES_URL)
    string(APPEND VITRINE_SCREENSHOTS "  <screenshots>\n")
    # A picture of assets/pictures, what it shows, the same in German; the first is the default.
    set(kind " type=\"default\"")
    foreach(shown IN ITEMS
            "window.png|The window: hall, exhibits, presets, parameters and the ledger of the frame|Das Fenster: Halle, Exponate, Presets, Parameter und was das Bild kostete"
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
configure_file(${CMAKE_CURRENT_LIST_DIR}/org.vitrine.Vitrine.metainfo.xml.in ${OUT} @ONLY)
