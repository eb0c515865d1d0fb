# Of the translations TS into OUTPUT: their English texts, one a line, as they stand in the XML. Those with line ends and
# plural forms are the window's alone.
string(ASCII 1 mark)
file(READ ${TS} all)
string(REPLACE ";" "${mark}" all "${all}")  # Of a list of CMake it would be the end of an item.
string(REGEX MATCHALL "<message>[ \n]*(<location[^>]*>[ \n]*)*<source>[^\n]*</source>" found "${all}")
string(REGEX REPLACE "<message>[ \n]*(<location[^>]*>[ \n]*)*<source>" "" found "${found}")
string(REGEX REPLACE "</source>(;|$)" "\n" found "${found}")
string(REPLACE "${mark}" ";" found "${found}")
file(WRITE ${OUTPUT} "${found}")
