# Writes OUTPUT, a C++ file that contains files of FOLDER as strings: page.html, page.css, and
# draft.js followed by page.js.
set(text "// Made by embed.cmake.\n#include \"post/view_page.hpp\"\n\nnamespace blocks::post {\n\n")
foreach(kind html css js)
  file(READ ${FOLDER}/page.${kind} content)
  if(kind STREQUAL js)
    file(READ ${FOLDER}/draft.js draft)
    string(PREPEND content "${draft}")
  endif()
  string(APPEND text "const char* const view_${kind} = R\"page(${content})page\";\n\n")
endforeach()
file(WRITE ${OUTPUT} "${text}}  // namespace blocks::post\n")
