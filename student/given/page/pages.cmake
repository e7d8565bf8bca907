# Makes pages.hpp, which holds each page of this folder as text. In a page, @NAME@ stands for the
# file of that name beside it, a style, a script or a piece of HTML, so that the page is one file.
function(make_pages_header header)
  string(REPLACE "[" "[[]" here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})  # GLOB takes it for a pattern
  file(GLOB files CONFIGURE_DEPENDS ${here}/*)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  foreach(file ${files})
    cmake_path(GET file FILENAME name)
    file(READ ${file} ${name})
  endforeach()
  foreach(page impacts play render studied)
    string(CONFIGURE "${${page}.html}" text @ONLY)
    # A compiler needn't take a long string, but many short ones, one after the other.
    string(REPLACE "\n\n" "\n\n)page\" R\"page(" text "${text}")
    string(APPEND constants "inline constexpr std::string_view ${page} = R\"page(${text})page\";\n")
  endforeach()
  file(CONFIGURE OUTPUT ${header} CONTENT
    "#pragma once\n#include <string_view>\nnamespace bounce::pages {\n@constants@}\n" @ONLY)
endfunction()
