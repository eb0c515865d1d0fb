# Writes the English texts of the translations TS into OUTPUT, one a line, as escaped in the XML. Texts with line ends and
# plural forms are left out: only the window has them.
string(ASCII 1 mark)
file(READ ${TS} all)
string(REPLACE ";" "${mark}" all "${all}")  # A semicolon would end an item of a list of CMake.
string(REGEX MATCHALL "<message>[ \n]*(<location[^>]*>[ \n]*)*<source>[^\n]*</source>" found "${all}")
string(REGEX REPLACE "<message>[ \n]*(<location[^>]*>[ \n]*)*<source>" "" found "${found}")
string(REGEX REPLACE "</source>(;|$)" "\n" found "${found}")
string(REPLACE "${mark}" ";" found "${found}")
file(WRITE ${OUTPUT} "${found}")
