# Makes generated/report/assets.hpp: each file of src/report/assets that the program carries as a string.
set(TT_ASSETS "")
foreach(pair "chart_script uPlot.iife.min.js" "chart_style uPlot.min.css" "chart_licence uPlot.LICENSE"
             "page_script page.js" "page_style page.css"
             "figure_style style.gp" "page_head head.html" "player_markup player.html" "charts_markup charts.html")
  separate_arguments(pair)
  list(GET pair 0 name)
  list(GET pair 1 file)
  set(path ${CMAKE_CURRENT_LIST_DIR}/assets/${file})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(READ ${path} content)
  string(APPEND TT_ASSETS "inline constexpr std::string_view ${name} = R\"asset(${content})asset\";\n\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/assets.hpp.in ${CMAKE_BINARY_DIR}/generated/report/assets.hpp @ONLY)
