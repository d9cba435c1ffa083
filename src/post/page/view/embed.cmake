# Writes OUTPUT, a C++ file that contains files of FOLDER as strings: page.html, page.css, and all
# scripts of scripts.cmake one after the other.
include(${FOLDER}/scripts.cmake)
foreach(name ${view_scripts})
  file(READ ${FOLDER}/${name}.js content)
  string(APPEND js "${content}\n")
endforeach()
file(READ ${FOLDER}/page.html html)
file(READ ${FOLDER}/page.css css)
set(text "// Made by embed.cmake.\n#include \"post/page/view_page.hpp\"\n\nnamespace blocks::post {\n\n")
foreach(kind html css js)
  string(APPEND text "const char* const view_${kind} = R\"page(${${kind}})page\";\n\n")
endforeach()
file(WRITE ${OUTPUT} "${text}}  // namespace blocks::post\n")
